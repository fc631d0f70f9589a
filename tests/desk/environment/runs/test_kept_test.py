import os
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import HOLE, job
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.runs import kept_test
from onika.desk.environment.state.open_application import Judgement
from onika.model.redirect import Redirect
from onika.wire import act
from onika.wire.view import FaultView
from onika.words.reason import Reason


class Keeper:
    """Stands for the runs: what was asked of it, and what it says of them."""

    def __init__(self):
        self.asked = []
        self.result = True, (Reason.plain("1 actions, 2 values"),)

    def __call__(self, path, settings, site, *, progress):
        self.asked.append((path, settings, site))
        self.priority = os.getpriority(os.PRIO_PROCESS, 0)
        progress(2, 5)
        return self.result


@pytest.fixture
def keeper(monkeypatch):
    keeper = Keeper()
    monkeypatch.setattr(kept_test, "keep_in", keeper)
    return keeper


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def shown(play):
    return play.environment.tree.keeping


def finished(play, request):
    """What is shown when it has been kept, or not."""
    play.do(request)
    while shown(play).state == "running":
        play.become()
    return shown(play)


def changed(model, doc, **what):
    """The model with an application that is otherwise."""
    return model.with_application(replace(model.applications[doc], **what))


def test_it_is_kept_aside_and_how_far_it_is_is_shown(play, keeper, tmp_path):  # R-X07
    doc = play.open([job("aC")])
    path = tmp_path / "tests" / "play.test"
    assert play.do(act.KeepTest(doc, expects=("LAMP == 1", " "))) == str(path)
    assert (shown(play).state, shown(play).run, shown(play).path) == ("running", 0, str(path))
    play.become()
    assert (shown(play).run, shown(play).of) == (2, 5)
    play.become()
    assert (shown(play).state, str(shown(play).text)) == ("kept", "1 actions, 2 values")
    assert any(str(say.text) == "play.test is kept: 1 actions, 2 values" for say in play.says)
    ((kept_at, settings, site),) = keeper.asked
    assert kept_at == path and path.parent.is_dir() and site.directories[0].path == tmp_path
    assert (settings.name, settings.is_virtual) == (str(tmp_path / "appl" / "play.appl"), True)
    assert [str(expectation.text) for expectation in settings.expectations] == ["LAMP == 1"]


@pytest.mark.skipif(sys.platform != "linux", reason="only there a thread has a priority of its own")
def test_simulators_take_what_is_left_of_the_processor(play, keeper):  # law 13
    before = os.getpriority(os.PRIO_PROCESS, 0)
    finished(play, act.KeepTest(play.open([job("aC")])))
    assert keeper.priority >= 10 and os.getpriority(os.PRIO_PROCESS, 0) == before


def test_why_it_is_not_kept_is_shown(play, keeper):  # R-X07
    keeper.result = False, (Reason.plain("only a good run can be kept; in this one LAMP == 1 does not hold"),)
    view = finished(play, act.KeepTest(play.open([job("aC")])))
    assert view.state == "failed" and str(view.text).startswith("only a good run can be kept")


def test_one_test_is_kept_at_a_time(play, keeper):
    doc = play.open([job("aC")])
    play.do(act.KeepTest(doc))
    assert "one test is kept at a time" in str(play.no(act.KeepTest(doc, path="other")).reason)
    play.become()
    play.become()
    assert finished(play, act.KeepTest(doc, path="other")).state == "kept"


def test_what_is_no_condition_is_told_at_its_field(play, keeper):  # R-X01
    no = play.no(act.KeepTest(play.open([job("aC")]), expects=("LAMP = 1",)))
    assert "found 'LAMP = 1'" in str(no.fields["expects"]) and keeper.asked == []


def test_a_name_is_one_in_the_folder_of_tests_and_a_whole_path_is_itself(play, keeper, tmp_path):  # R-X07
    doc = play.open([job("aC")])
    for path, expected in (("lamp", "tests/lamp.test"), ("lamp2.test", "tests/lamp2.test")):
        assert finished(play, act.KeepTest(doc, path=path)).path == str(tmp_path / expected)
    assert play.do(act.KeepTest(doc, path=str(tmp_path / "deep" / "x"))) == str(tmp_path / "deep" / "x.test")


@pytest.mark.parametrize("path", ["../x", "a/b", "1st", "a b"])
def test_what_is_no_name_is_told_at_its_field(play, keeper, path):  # R-X01
    assert "expected a name" in str(play.no(act.KeepTest(play.open([job("aC")]), path=path)).fields["path"])


def test_a_folder_that_cannot_be_made_is_told(play, keeper, tmp_path):
    (tmp_path / "tests").write_text("in the way")
    assert "cannot be made" in str(play.no(act.KeepTest(play.open([job("aC")]))).reason)


def test_a_test_that_is_there_is_replaced_only_when_the_user_wants_it(play, keeper, tmp_path):  # R-B07
    doc = play.open([job("aC")])
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "play.test").write_text("")
    no = play.no(act.KeepTest(doc))
    assert "is there already" in str(no.reason) and str(no.remedies[0].label) == "Replace it"
    finished(play, no.remedies[0].act)
    assert len(keeper.asked) == 1


def test_what_is_not_saved_is_saved_first_if_the_user_wants_it(play, keeper, tmp_path):  # R-E12
    doc = play.open([job("aC"), job("bC")])
    play.do(act.RemoveIcons(doc, (2,)))
    no = play.no(act.KeepTest(doc))
    assert "play is changed here and not saved" in str(no.reason) and str(no.remedies[0].label) == "Save and keep"
    play.do(no.remedies[0].act)
    assert not play.environment.tree.applications[doc].is_dirty and shown(play).state == "running"


def test_a_configuration_that_is_not_saved_is_asked_about_too(play, keeper, tmp_path):  # R-E12
    doc = play.open([job("aC")])
    play.do(act.Rate(play.do(act.Open(str(tmp_path / "conf" / "aC.conf"))), "a", 50.0))
    assert "aC is changed here" in str(play.no(act.KeepTest(doc)).reason)


def test_an_application_without_a_file_needs_one_first(play, keeper):
    doc = play.do(act.NewApplication())
    no = play.no(act.KeepTest(doc, saves_unsaved=True, path="x"))
    assert "it has no file yet" in str(no.reason)


def test_what_cannot_run_is_not_even_tried(play, keeper):  # R-E01
    doc = play.open([job("aC"), HOLE])
    hole = FaultView(Reason.plain("an action is missing here"), "fault")
    play.environment.become(
        lambda model: Done(changed(model, doc, judgement=Judgement(model.applications[doc].application, (hole,))))
    )
    assert "play cannot run as it is: an action is missing here" in str(play.no(act.KeepTest(doc)).reason)


def test_what_stands_for_others_does_so_in_the_test(play, keeper):  # R-E09, R-X07
    doc = play.open([job("aC")])
    play.environment.become(lambda model: Done(changed(model, doc, redirects=(Redirect("a", "c"),))))
    finished(play, act.KeepTest(doc))
    assert keeper.asked[0][1].redirects == (Redirect("a", "c"),)


def test_what_comes_with_onika_is_not_written_in(play, keeper, tmp_path, monkeypatch):
    doc = play.open([job("aC")])
    monkeypatch.setattr(kept_test, "is_shipped", lambda base: Path(base) == tmp_path)
    assert play.do(act.KeepTest(doc)) == str(tmp_path / "home" / "onika" / "tests" / "play.test")


def test_what_is_not_open_is_not_kept(play, keeper):
    assert "no longer open" in str(play.no(act.KeepTest("a9")).reason)
