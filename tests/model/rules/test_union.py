import pytest

from onika.model.application import AppFlow, Application, Icon
from onika.model.configuration import Configuration, Placed
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.rules.union import configurations_of, conflicts, tasks_of
from onika.model.syntax import IconType, Syntax
from onika.model.task import LocalLine, Task
from onika.words.fault import Place

SYNTAX = Syntax(tuple(IconType(name, 0, 0) for name in ("Complete job", "Complete application", "Complete NOP")), ())


def icon(name: str, kind: str = "Complete job") -> Icon:
    return Icon(Onikon(name, kind, "", (), blank()))


def conf(name: str, *tasks: str) -> Configuration:
    return Configuration(name, tuple(map(Placed, tasks)))


def test_every_configuration_and_task_counts_once_in_the_order_of_the_file() -> None:
    found = {"b": conf("b", "y", "x"), "a": conf("a", "x", "z", "lost")}  # R-E02
    flow = AppFlow((icon("b"), icon("a"), icon("b"), icon("nop", "Complete NOP"), icon("missing")))
    used = configurations_of(flow, SYNTAX, found, {})
    assert used == (found["b"], found["a"])
    tasks = {name: Task(name, name) for name in "xyz"}
    assert [task.name for task in tasks_of(used, tasks)] == ["y", "x", "z"]


def test_nested_applications_are_entered_and_recursion_ends() -> None:
    inner = Application("inner", False, (AppFlow((icon("b"), icon("inner", "Complete application"))),))  # R-E06
    flow = AppFlow((icon("inner", "Complete application"),))
    assert configurations_of(flow, SYNTAX, {"b": conf("b")}, {"inner": inner}) == (conf("b"),)


def device(name: str) -> tuple[LocalLine, ...]:
    return (LocalLine("DEVICE", (name, "fast")),)


@pytest.mark.parametrize(
    ("one", "other", "found"),
    [
        (Task("a", "m"), Task("b", "m"), "m in `a` and `b` of flow 0"),
        (
            Task("a", "m", local=device("boxes:arm")),
            Task("b", "n", local=device("boxes:arm")),
            "boxes:arm by `a` and `b` of flow 0",
        ),
        (Task("a", "m", outconst=("X",)), Task("b", "n", outconst=("X",)), "X from `a` and `b` of flow 0"),
    ],
)
def test_what_may_not_live_side_by_side_is_named(one: Task, other: Task, found: str) -> None:
    assert [fault.found for fault in conflicts([one, other], "flow 0", Place("a.appl"))] == [found]  # law 9


def test_a_constant_only_given_while_running_is_a_fault() -> None:
    writer, reader = Task("w", "w", outvar=("X",)), Task("r", "r", inconst=("X",))  # law 9
    assert [fault.expected for fault in conflicts([writer, reader], "flow 0", Place("a.appl"))] == [
        "constants that are given at initialisation",
        "a task that gives the constant X",
    ]


def test_joint_and_cartesian_moves_may_write_the_same_reference() -> None:
    moves = [Task("jmove", "j", outvar=("Q_REF",)), Task("cmove", "c", outvar=("Q_REF",))]  # decision 1
    assert conflicts(moves, "flow 0", Place("a.appl")) == ()


def test_an_inboth_needs_no_supplier_of_the_constant() -> None:
    both = Task("r", "r", inconst=("X",), invar=("X",))  # decision 6
    assert conflicts([both, Task("w", "w", outvar=("X",))], "flow 0", Place("a.appl")) == ()
