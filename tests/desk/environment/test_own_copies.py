import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.installed_fixture import InstalledFixture
from onika.desk.environment.initial_model import opened
from onika.wire import act


@pytest.fixture
def desk(tmp_path, monkeypatch):
    return InstalledFixture(tmp_path, monkeypatch)


def copies(desk):
    return {path.rsplit("/", 1)[1]: laboratory for path, laboratory in desk.environment.tree.own_copies.items()}


def test_what_stands_before_a_shipped_file_is_marked_and_compared_with_it(desk):  # R-C05, R-B08
    desk.write("pd", "code", "mine = 1\n")
    desk.look()
    assert copies(desk) == {"pd.py": "generic", "pd.rmod": "generic"}
    assert desk.environment.tree.libraries[str(desk.generic.path)].faults == ()
    both = desk.do(act.CompareWithShipped(str(desk.own.code_file("pd"))))
    assert (both.text, both.shipped_text) == ("mine = 1\n", desk.generic.code_file("pd").read_text())
    assert both.shipped_path == str(desk.generic.code_file("pd"))
    again = opened(desk.site, None, {})[0]
    assert again.own_copies == desk.environment.model.own_copies


def test_going_back_leaves_the_shipped_one_in_force_and_loses_nothing(desk):  # R-X10
    desk.write("pd", "code", "mine = 1\n")
    path = str(desk.own.code_file("pd"))
    assert desk.do(act.GoBackToShipped(path)) == str(desk.generic.code_file("pd"))
    tree = desk.environment.tree
    assert (tree.tasks["pd"].code, copies(desk)) == (str(desk.generic.code_file("pd")), {})
    (kept,) = desk.do(act.ListReplaced())
    assert (kept.path, kept.lines, kept.is_there) == (path, 1, False)
    assert desk.do(act.BringBack(kept.number)) == path
    assert desk.own.code_file("pd").read_text() == "mine = 1\n" and copies(desk) == {"pd.py": "generic"}
    assert desk.installed_files() == desk.before


def test_an_open_configuration_goes_back_as_a_step_that_can_be_taken_back(desk):  # R-X10
    doc = desk.do(act.Open("pauseC"))
    desk.do(act.Place(doc, "pd", 400, 300))
    desk.do(act.Save(doc))
    view = desk.environment.tree.documents[doc]
    assert view.path == str(desk.own.configuration_file("pauseC"))
    desk.do(act.GoBackToShipped(view.path))
    view = desk.environment.tree.documents[doc]
    assert (view.path, list(view.tasks)) == (str(desk.generic.configuration_file("pauseC")), ["pause"])
    assert not view.has_changed_on_disk
    desk.do(act.Undo(doc))
    assert set(desk.environment.tree.documents[doc].tasks) == {"pause", "pd"}


def test_what_is_saved_over_can_be_brought_back_and_that_too(desk):  # R-X10
    desk.write("pd", "code", "first = 1\n")
    desk.write("pd", "code", "second = 1\n")
    (kept,) = desk.do(act.ListReplaced())
    desk.do(act.BringBack(kept.number))
    assert desk.own.code_file("pd").read_text() == "first = 1\n"
    last, before = desk.do(act.ListReplaced())
    assert (before.is_there, last.is_there) == (True, False)
    desk.do(act.BringBack(last.number))
    assert desk.own.code_file("pd").read_text() == "second = 1\n"


def test_a_deleted_icon_is_brought_back(desk):  # R-X10
    desk.do(act.EditOnikon("pauseC", "mine"))
    desk.do(act.RemoveOnikon("pauseC", confirmed=True))
    assert desk.environment.tree.onikons["pauseC"].description != "mine"
    desk.do(act.BringBack(desk.do(act.ListReplaced())[0].number))
    assert desk.environment.tree.onikons["pauseC"].description == "mine"


@pytest.mark.parametrize("path", ["", "/", "nowhere", "/etc/passwd", "\0", "x" * 5000])
def test_what_is_no_copy_is_neither_compared_nor_gone_back_from(desk, path):  # R-B07
    for asked in (act.CompareWithShipped(path), act.GoBackToShipped(path)):
        assert desk.no(asked).reason.key == "desk.no_own_copy"
    shipped = str(desk.generic.code_file("pd"))
    assert desk.no(act.GoBackToShipped(shipped)).reason.key == "desk.no_own_copy"


def test_what_is_not_kept_any_more_is_not_brought_back(desk):  # R-B07
    assert desk.do(act.ListReplaced()) == ()
    assert desk.no(act.BringBack(7)).reason.key == "desk.nothing_to_bring_back"


def test_without_a_place_to_keep_it_a_copy_stays(desk, tmp_path):  # R-B07
    desk.write("pd", "code", "mine = 1\n")
    (tmp_path / "state").write_text("no folder")
    no = desk.no(act.GoBackToShipped(str(desk.own.code_file("pd"))))
    assert no.reason.key == "store.not_kept" and desk.own.code_file("pd").exists()


def test_a_laboratory_that_is_exchanged_under_an_open_file_is_told(desk):  # R-X10
    doc = desk.do(act.Open("pauseC"))
    desk.do(act.Place(doc, "pd", 400, 300))
    file = desk.generic.configuration_file("pauseC")
    file.write_text(file.read_text().replace("100 80", "120 80"))
    desk.look()
    assert desk.environment.tree.documents[doc].has_changed_on_disk
    assert any("pauseC" in sentence for sentence in desk.sentences())
    desk.do(act.Save(doc))
    assert "120 80" in file.read_text() and "pd" in desk.own.configuration_file("pauseC").read_text()


def test_what_one_environment_copies_another_one_shows(desk, tmp_path):  # R-B08
    elsewhere = EnvironmentFixture(tmp_path, (), opened(desk.site, None, {})[0], desk.site)
    source = elsewhere.do(act.ReadText("pd", "code"))
    elsewhere.do(act.WriteText("pd", "code", "theirs = 1\n", source.stamp))
    desk.look()
    assert desk.environment.tree.tasks["pd"].code == str(desk.own.code_file("pd"))
    assert copies(desk) == {"pd.py": "generic", "pd.rmod": "generic"}
