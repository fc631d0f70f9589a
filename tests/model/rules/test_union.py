import pytest

from onika.model.configuration import Configuration, Placed
from onika.model.rules.union import TaskOrigin, conflicts, tasks_of, variables
from onika.model.task import LocalLine, Task
from onika.words.fault import Place
from onika.words.reason import Reason

FLOW = Reason.of("rules.flow", number=0)


def conf(name: str, *tasks: str) -> Configuration:
    return Configuration(name, tuple(map(Placed, tasks)))


def test_every_task_counts_once_in_the_order_of_the_files() -> None:
    tasks = {name: Task(name, name) for name in "xyz"}  # R-E02
    used = (conf("b", "y", "x"), conf("a", "x", "z", "lost"))
    assert [task.name for task in tasks_of(used, tasks)] == ["y", "x", "z"]


def test_the_variables_of_tasks_are_all_they_read_and_write() -> None:
    tasks = [Task("a", "m", invar=("X",), outconst=("Y",), aliases=(("X", "Z"),)), Task("b", "n", outvar=("X",))]
    assert variables(tasks) == {"X", "Y", "Z"}


def device(name: str) -> tuple[LocalLine, ...]:
    return (LocalLine("DEVICE", (name, "fast")),)


@pytest.mark.parametrize(
    ("task", "other", "result"),
    [
        (Task("a", "m"), Task("b", "m"), "expected every module once in a flow, found m in `a` and `b` of flow 0"),
        (
            Task("a", "m", local=device("boxes:arm")),
            Task("b", "n", local=device("boxes:arm")),
            "expected every device claimed once in a flow, found boxes:arm by `a` and `b` of flow 0",
        ),
        (
            Task("a", "m", outconst=("X",)),
            Task("b", "n", outconst=("X",)),
            "expected one supplier of each constant in a flow, found X from `a` and `b` of flow 0",
        ),
    ],
)
def test_what_may_not_live_side_by_side_is_named(task: Task, other: Task, result: str) -> None:
    assert [str(fault.reason) for fault in conflicts([task, other], FLOW, Place("a.appl"))] == [result]  # law 9


def test_a_constant_only_given_while_running_is_a_fault() -> None:
    writer, reader = Task("w", "w", outvar=("X",)), Task("r", "r", inconst=("X",))  # law 9
    assert [str(fault.reason) for fault in conflicts([writer, reader], FLOW, Place("a.appl"))] == [
        "expected constants that are given at initialisation, found X between `w` and `r` of flow 0",
        "expected a task that gives the constant X, found none for `r` of flow 0",
    ]


def test_joint_and_cartesian_moves_may_write_the_same_reference() -> None:
    moves = [Task("jmove", "j", outvar=("Q_REF",)), Task("cmove", "c", outvar=("Q_REF",))]  # decision 1
    assert conflicts(moves, FLOW, Place("a.appl")) == ()


def test_an_inboth_needs_no_supplier_of_the_constant() -> None:
    both = Task("r", "r", inconst=("X",), invar=("X",))  # decision 6
    assert conflicts([both, Task("w", "w", outvar=("X",))], FLOW, Place("a.appl")) == ()


def test_a_task_is_beside_the_first_only_and_its_icon_is_named() -> None:
    tasks = [Task(name, "m") for name in "abc"]  # law 9, R-E01
    sources = {"a": TaskOrigin(Place("a.appl", 3), "open", 0, None), "c": TaskOrigin(Place("a.appl", 9), "x", 2, None)}
    sentences = conflicts(tasks, FLOW, Place("a.appl"), sources)
    assert [(fault.place.line, str(fault.reason)) for fault in sentences] == [
        (0, "expected every module once in a flow, found m in `a` (in `open`, step 0) and `b` of flow 0"),
        (
            9,
            "expected every module once in a flow"
            ", found m in `a` (in `open`, step 0) and `c` (in `x`, step 2) of flow 0",
        ),
    ]
