import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.model.task import LocalLine, Task
from onika.wire import act
from onika.wire.view import ShowTask

SERVO = Task("servo", "s", invar=("Q",), frequency=10.0, local=(LocalLine("STIFF", ("1",)), LocalLine("DAMP", ("1",))))


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, (SERVO,))


def lines(sitting):
    return [(str(say.text), say.where) for say in sitting.says if say.level == "info"]


def test_each_change_of_parameters_is_a_line_with_what_they_were(sitting):  # R-X10
    doc = sitting.new("servo")
    sitting.do(act.Local("servo", (("STIFF", ("1.5",)), ("DAMP", ("1",)), ("MORE", ("2", "3"))), doc))
    assert lines(sitting) == [
        ("parameters of servo: STIFF was 1, is 1.5 now; MORE was –, is 2 3 now", ShowTask("servo"))
    ]


def test_what_is_taken_back_and_done_again_is_a_line_too(sitting):  # R-X10
    doc = sitting.new("servo")
    sitting.do(act.Local("servo", (("STIFF", ("1.5",)), ("DAMP", ("1",))), doc))
    sitting.do(act.Undo(doc))
    sitting.do(act.Redo(doc))
    assert [text for text, _ in lines(sitting)[1:]] == [
        "parameters of servo: STIFF was 1.5, is 1 now",
        "parameters of servo: STIFF was 1, is 1.5 now",
    ]


def test_other_changes_of_a_task_are_none(sitting):
    doc = sitting.new("servo")
    sitting.do(act.Alias("servo", "Q", "GOAL", doc))
    assert lines(sitting) == []
