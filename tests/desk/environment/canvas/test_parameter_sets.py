"""Parameter sets are kept, compared, switched and removed (requirement X10)."""

from dataclasses import replace

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.outcome import Done
from onika.model.task import LocalLine, Task
from onika.wire import act
from onika.wire.sheet import LocalSheet, ModuleSheet
from onika.wire.view import ShowSaveAs

SERVO = Task(
    "servo",
    "s",
    invar=("Q",),
    frequency=10.0,
    local=(LocalLine("DEVICE", ("w:arm",)), LocalLine("STIFF", ("1",))),
)
PATH = Task("path", "p", outvar=("Q",), frequency=10.0, local=(LocalLine("SPEED", ("0.5",)),))
SHEET = ModuleSheet(
    (),
    (),
    (
        LocalSheet("STIFF", "double", "-", "share of KP", 1.0, 0.1, 2.0),
        LocalSheet("DAMP", "double", "-", "share of KD", 1.0, 0.1, 2.0),
    ),
    *(False, False, False, 0, ""),
)


@pytest.fixture
def sitting(tmp_path):
    fixture = EnvironmentFixture(tmp_path, (SERVO, PATH))
    fixture.environment.become(
        lambda model: Done(replace(model, libraries=replace(model.libraries, sheets={"s": SHEET})))
    )
    return fixture


@pytest.fixture
def doc(sitting):
    opened = sitting.new("servo", "path")
    sitting.do(act.Save(opened, "move", str(sitting.base.path)))
    return opened


def tune(sitting, doc, stiff, damp="1.0"):
    lines = (("DEVICE", ("w:arm",)), ("STIFF", (stiff,)), ("DAMP", (damp,)))
    sitting.do(act.Local("servo", lines, doc))


def local(sitting, doc, name="servo"):
    model = sitting.environment.model
    return {line.key: line.words for line in model.libraries_of(model.documents[doc]).tasks[name].local}


def file(sitting):
    return sitting.base.path / "conf" / "move.sets"


def test_a_set_keeps_what_is_tuned_of_all_tasks_beside_the_configuration(sitting, doc):
    view = sitting.do(act.KeepSet(doc, " as  found "))
    assert view.path == str(file(sitting))
    (kept,) = view.sets
    assert kept.name == "as found"
    assert kept.values == (
        ("servo", "STIFF", ("1",)),
        ("servo", "DAMP", ("1.0",)),
        ("path", "SPEED", ("0.5",)),
    )
    assert "DEVICE" not in file(sitting).read_text()


def test_a_switch_leaves_tasks_alone_in_which_nothing_differs_also_defaults(sitting, doc):  # R-X10
    sitting.do(act.KeepSet(doc, "as found"))  # keeps DAMP as its default, which stands in no line
    sitting.do(act.Local("path", (("SPEED", ("0.2",)),), doc))
    sitting.do(act.SwitchSet(doc, "as found"))
    assert local(sitting, doc) == {"DEVICE": ("w:arm",), "STIFF": ("1",)}
    assert local(sitting, doc, "path")["SPEED"] == ("0.5",)


def test_a_set_is_switched_as_one_step_which_undo_takes_back(sitting, doc):  # R-X10
    tune(sitting, doc, "0.5", "0.7")
    sitting.do(act.Local("path", (("SPEED", ("0.2",)),), doc))
    sitting.do(act.KeepSet(doc, "soft"))
    tune(sitting, doc, "2", "2")
    sitting.do(act.Local("path", (("SPEED", ("0.9",)),), doc))
    view = sitting.do(act.SwitchSet(doc, "soft"))
    assert local(sitting, doc) == {"DEVICE": ("w:arm",), "STIFF": ("0.5",), "DAMP": ("0.7",)}
    assert local(sitting, doc, "path") == {"SPEED": ("0.2",)}
    assert view.present == view.sets[0].values
    assert str(sitting.environment.tree.documents[doc].undo) == "switching to the parameter set soft"
    sitting.do(act.Undo(doc))
    assert (local(sitting, doc)["STIFF"], local(sitting, doc, "path")["SPEED"]) == (("2",), ("0.9",))


def test_one_value_that_is_refused_refuses_the_whole_set(sitting, doc):  # R-X10
    sitting.do(act.KeepSet(doc, "soft"))
    text = file(sitting).read_text().replace("servo STIFF 1", "servo STIFF 7").replace("SPEED 0.5", "SPEED 0.1")
    file(sitting).write_text(text)
    before = sitting.environment.model
    no = sitting.no(act.SwitchSet(doc, "soft"))
    assert list(no.fields) == ["servo STIFF"]
    assert "nothing is changed: servo: LOCAL STIFF: expected 0.1..2 -, found 7" in str(no.reason)
    assert sitting.environment.model is before


def test_values_of_tasks_that_are_not_here_are_left_out_and_told(sitting, doc):
    sitting.do(act.KeepSet(doc, "all"))
    sitting.do(act.Remove(doc, ("path",)))
    tune(sitting, doc, "0.3")
    sitting.do(act.SwitchSet(doc, "all"))
    assert local(sitting, doc)["STIFF"] == ("1",)
    assert any("left out: path" in str(say.text) for say in sitting.says)


def test_a_set_of_this_name_is_replaced_only_where_that_is_said(sitting, doc):
    sitting.do(act.KeepSet(doc, "soft"))
    tune(sitting, doc, "0.5")
    no = sitting.no(act.KeepSet(doc, "soft"))
    assert no.remedies[0].act == act.KeepSet(doc, "soft", overwrites=True)
    view = sitting.do(no.remedies[0].act)
    assert [(kept.name, kept.values[0]) for kept in view.sets] == [("soft", ("servo", "STIFF", ("0.5",)))]


def test_what_was_done_to_sets_is_taken_back_and_done_again(sitting, doc):  # R-X10
    sitting.do(act.KeepSet(doc, "soft"))
    text = file(sitting).read_text()
    assert sitting.do(act.RemoveSet(doc, "soft")).sets == ()
    sitting.do(act.Undo(doc))
    assert file(sitting).read_text() == text
    sitting.do(act.Undo(doc))
    assert not file(sitting).exists()
    sitting.do(act.Redo(doc))
    assert file(sitting).read_text() == text


@pytest.mark.parametrize("name", ["", "  ", "x" * 61, "a\x00b"])
def test_a_name_that_no_line_holds_is_refused_beside_its_field(sitting, doc, name):  # R-B07
    assert list(sitting.no(act.KeepSet(doc, name)).fields) == ["name"]


def test_a_configuration_without_a_file_keeps_no_sets_and_says_how_to_get_there(sitting):
    blank = sitting.new("servo")
    for asked in (
        act.ListSets(blank),
        act.KeepSet(blank, "soft"),
        act.SwitchSet(blank, "x"),
        act.RemoveSet(blank, "x"),
    ):
        assert sitting.no(asked).remedies[0].show == ShowSaveAs()


def test_sets_that_are_not_there_and_files_at_fault_are_named(sitting, doc):  # R-B07
    assert "no parameter set stiff" in str(sitting.no(act.SwitchSet(doc, "stiff")).reason)
    assert "no parameter set stiff" in str(sitting.no(act.RemoveSet(doc, "stiff")).reason)
    file(sitting).write_text("VERSION 2.0\nSET\nEOF\n")
    for asked in (act.ListSets(doc), act.KeepSet(doc, "soft"), act.SwitchSet(doc, "soft"), act.RemoveSet(doc, "soft")):
        assert "move.sets:2" in str(sitting.no(asked).reason)


def test_where_no_task_has_a_parameter_there_is_nothing_to_keep(sitting):
    doc = sitting.new()
    sitting.do(act.Save(doc, "blank", str(sitting.base.path)))
    assert "no task of blank" in str(sitting.no(act.KeepSet(doc, "soft")).reason)
