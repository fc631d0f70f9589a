from dataclasses import replace

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.outcome import Done
from onika.model.task import LocalLine, Task
from onika.wire import act
from onika.wire.sheet import LocalSheet, ModuleSheet
from onika.wire.view import ParameterView

WRITER = Task("writer", "w", invar=("IN",), outvar=("Q", "R"), frequency=10.0)
SERVO = Task("servo", "s", invar=("Q",), frequency=10.0, local=(LocalLine("STIFF", ("9",)), LocalLine("NOTE", ("x",))))
SHEET = ModuleSheet(
    (),
    (),
    (LocalSheet("STIFF", "double", "-", "share of KP", 1.0, 0.1, 2.0), LocalSheet("GAIN", "double[2]", "m", "", None)),
    *(False, False, False, 0, ""),
)


@pytest.fixture
def sitting(tmp_path):
    fixture = EnvironmentFixture(tmp_path, (WRITER, SERVO))
    fixture.environment.become(
        lambda model: Done(replace(model, libraries=replace(model.libraries, sheets={"s": SHEET})))
    )
    return fixture


def task(sitting, name):
    return sitting.environment.model.libraries.tasks[name]


def test_a_page_sees_what_the_module_declares_of_each_parameter(sitting):  # R-C04
    assert sitting.environment.tree.tasks["servo"].parameters == (
        ParameterView("STIFF", ("9",), "double", "-", "share of KP", 0.1, 2.0, ("1.0",)),
        ParameterView("GAIN", (), "double[2]", "m"),
        ParameterView("NOTE", ("x",)),
    )
    assert sitting.environment.tree.tasks["writer"].parameters == ()


def test_a_value_beyond_its_bounds_or_of_another_kind_is_refused_beside_its_line(sitting):  # R-B07
    for words, sentence in ((("3",), "expected 0.1..2 -, found 3"), (("stiff",), "number"), ((), "found 0 words")):
        no = sitting.no(act.Local("servo", (("NOTE", ("x",)), ("STIFF", words))))
        assert list(no.fields) == ["line 1"]
        assert sentence in str(no.fields["line 1"])


def test_what_the_file_has_wrong_already_keeps_nobody_from_changing_another_line(sitting):  # R-C04
    sitting.do(act.Local("servo", (("STIFF", ("9",)), ("NOTE", ("y",)), ("GAIN", ("1", "2")))))
    assert task(sitting, "servo").local[1:] == (LocalLine("NOTE", ("y",)), LocalLine("GAIN", ("1", "2")))


def test_nobody_knows_the_parameters_of_a_task_that_is_not_there(sitting):
    assert "nobody" in str(sitting.no(act.Local("nobody", ())).reason)


def test_parameters_are_changed_and_taken_back(sitting):  # R-C04
    doc = sitting.new()
    sitting.do(act.Local("writer", (("GAIN", ("1", "2.5")), ("OFF", ())), doc))
    assert task(sitting, "writer").local == (LocalLine("GAIN", ("1", "2.5")), LocalLine("OFF", ()))
    sitting.do(act.Undo(doc))
    assert task(sitting, "writer").local == ()


@pytest.mark.parametrize(
    "line",
    [("MODULE", ("x",)), ("EOF", ()), ("9A", ("x",)), ("", ()), ("A", ("two words",)), ("A", ("a\nB",)), ("A", ("",)),
     ("#A", ()), ("A", ("\x00",)), ("A B", ())],
)  # fmt: skip
def test_a_parameter_that_no_file_could_hold_is_refused_beside_its_line(sitting, line):  # R-B07
    no = sitting.no(act.Local("writer", (("GOOD", ("1",)), line)))
    assert list(no.fields) == ["line 1"]


def test_a_parameter_given_twice_is_refused(sitting):  # R-B07
    fields = sitting.no(act.Local("writer", (("A", ("1",)), ("A", ("2",))))).fields
    assert {line: str(why) for line, why in fields.items()} == {"line 1": "expected A once"}
