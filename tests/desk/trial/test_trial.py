from pathlib import Path

import pytest

from onika.desk.run.settings import RunSettings
from onika.desk.trial import trial
from onika.desk.trial.judging import Verdict
from onika.desk.trial.trial import Trial, find, limit_of, read, settings_of, try_all, try_out
from onika.files import kept
from onika.model.kept import KeptAction, KeptFlow, KeptRun
from onika.model.redirect import Redirect
from onika.store.site import open_site
from onika.words.condition import Condition
from onika.words.reason import Reason

SITE = open_site([], {}, None)


@pytest.fixture
def folder(workshop, tmp_path, monkeypatch):
    """A folder with three tests, the second of which fails, at a runtime that is played; it is asked for in `asked`."""
    good = workshop.kept().kept
    for name, kept_run in (("arm", good), ("hand", KeptRun("stack", "", (KeptFlow("flow9"),))), ("lamp", good)):
        (tmp_path / f"{name}.test").write_text(kept.write(kept_run))
    monkeypatch.setattr(trial, "give_account", lambda settings, site, limit_s: workshop.run())
    return tmp_path


def test_a_test_asks_for_the_run_that_was_kept():  # R-X07
    kept_run = KeptRun("stack", "", (), (), 3, 0.25, (("a", "b", "1"),), ("LAMP == 1",), ("puma=scara",))
    lit, other = Condition.parse("LAMP == 1"), Redirect.parse("puma=scara")
    expected = RunSettings("stack", True, (lit,), 0.25, 3, (("a", "b", "1"),), redirects=(other,), has_black_box=False)
    assert settings_of(kept_run) == expected
    assert (settings_of(kept_run, 2).seed, settings_of(kept_run, 2).shake) == (5, 2)


def test_a_run_may_take_twice_as_long_as_the_kept_one_and_a_minute():  # R-X07
    flow = KeptFlow("flow0", (), (KeptAction("a", 10.0, 0.1), KeptAction("b", 5.0, 0.1)))
    assert limit_of(KeptRun("stack", "", (flow, flow))) == 120.0


def test_tests_are_found_in_folders_and_by_a_word_of_their_names(folder):  # R-X07
    assert [path.stem for path in find([folder])[0]] == ["arm", "hand", "lamp"]
    assert [path.stem for path in find([folder, folder / "arm.test"], "A")[0]] == ["arm", "hand", "lamp"]
    assert [path.stem for path in find([folder], "am")[0]] == ["lamp"]
    paths, (fault,) = find([folder / "nowhere"])
    assert (paths, fault.reason) == ([], Reason.of("desk.no_test_file", ending=".test"))


def test_all_are_tried_and_told_in_order_each_also_shaken(folder):  # R-X07
    done = list(try_all(find([folder])[0], SITE, workers=3, shakes=1))
    assert [Path(tried.file).stem for tried in done] == ["arm", "arm", "hand", "hand", "lamp", "lamp"]
    assert [tried.shake for tried in done] == [None, 1] * 3
    assert [tried.verdict.is_passed for tried in done] == [True, True, False, False, True, True]
    assert str(done[1].name).endswith("arm.test shaken 1")


def test_a_file_that_is_no_test_fails_with_its_faults(folder):  # R-X07, R-B07
    (folder / "arm.test").write_text("VERSION 2.0\nEOF\n")
    tried = try_out(folder / "arm.test", SITE)
    assert not tried.verdict.is_passed
    assert all("arm.test" in str(failure) for failure in tried.verdict.failures)
    assert read(folder / "gone.test")[0] is None


def test_a_trial_is_called_by_its_file():
    assert str(Trial("a.test", Verdict(), 1.0).name) == "a.test"
