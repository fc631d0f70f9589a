import pytest

from kit.desk.installed_fixture import InstalledFixture
from onika.desk.environment.refresh import refreshed
from onika.store.folder_arrangement import in_order
from onika.wire import act

PICTURE = "7" * 1024


@pytest.fixture
def desk(tmp_path, monkeypatch):
    desk = InstalledFixture(tmp_path, monkeypatch)
    for name in ("first", "second", "third"):
        desk.do(act.MakeTarget(name, "Pause object", (("2",),), PICTURE))
    desk.do(act.MakeTarget("other", "Level object", (("0.2",),), PICTURE))
    return desk


def icons(desk):
    """The targets of the own dictionary in the order in which they are shown."""
    view = desk.environment.tree.dictionaries[str(desk.own.path)]
    own = [name for name, onikon in desk.environment.tree.onikons.items() if onikon.dictionary == view.path]
    return in_order(sorted(own, key=lambda name: desk.environment.tree.onikons[name].order), view.arranged)


def tasks(desk):
    view = desk.environment.tree.libraries[str(desk.generic.path)]
    names = [task.name for task in desk.environment.tree.tasks.values() if task.library == view.path]
    return in_order(names, view.arranged)


def test_an_icon_is_put_before_another_and_stays_there(desk):  # R-D24
    desk.do(act.ArrangeIcon("third", "first"))
    assert [name for name in icons(desk) if name != "other"] == ["third", "first", "second"]
    desk.do(act.ArrangeIcon("third"))
    assert [name for name in icons(desk) if name != "other"] == ["first", "second", "third"]
    file = desk.own.path / "dict" / "OnikaArrangement.dta"
    assert "PLACE       first\nPLACE       second\nPLACE       third" in file.read_text()


def test_undo_takes_it_back(desk):  # R-D24, R-X10
    before = icons(desk)
    desk.do(act.ArrangeIcon("second", "first"))
    assert str(desk.environment.tree.own_undo) == "arranging second"
    desk.do(act.Undo(""))
    assert icons(desk) == before and not (desk.own.path / "dict" / "OnikaArrangement.dta").exists()
    desk.do(act.Redo(""))
    assert icons(desk).index("second") < icons(desk).index("first")


def test_it_stays_within_its_type_and_its_window(desk):  # R-D24, R-D01
    for before in ("other", "nobody", "home"):
        assert desk.no(act.ArrangeIcon("first", before)).reason.key == "desk.arranged_apart"
    assert "nobody" in str(desk.no(act.ArrangeIcon("nobody")).reason)
    assert desk.no(act.ArrangeTask("pd", "nobody")).reason.key == "desk.arranged_apart"


def test_tasks_of_what_is_shipped_are_arranged_and_it_is_not_written(desk):  # R-D24, R-B07
    last = tasks(desk)[-1]
    desk.do(act.ArrangeTask(last, tasks(desk)[0]))
    assert tasks(desk)[0] == last
    assert desk.installed_files() == desk.before
    assert "BASE        generic" in (desk.own.path / "module" / "OnikaArrangement.dta").read_text()


def test_what_somebody_else_writes_is_followed(desk):  # R-D24, R-X10
    file = desk.own.path / "dict" / "OnikaArrangement.dta"
    file.write_text("VERSION     2.0\n\nPLACE       third\n\nEOF\n")
    desk.environment.become(lambda model: refreshed(model, desk.disk.changed(model), desk.site))
    assert icons(desk)[0] == "third"
    file.write_text("VERSION     2.0\n\nPLACE\n\nEOF\n")
    desk.environment.become(lambda model: refreshed(model, desk.disk.changed(model), desk.site))
    assert icons(desk)[0] != "third" and any("the usual order is kept" in str(line.text) for line in desk.says)
    assert desk.no(act.ArrangeIcon("second", "first")).reason.key == "store.arrangement_at_fault"
