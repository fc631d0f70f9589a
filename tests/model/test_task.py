"""Tasks as their parameter files describe them."""

import dataclasses

from onika.model.port import PortKind
from onika.model.task import Task, TaskType

TASK = Task(
    name="fwd",
    module="fwdkin",
    aliases=(("Q_MEZ", "Q_SIM"), ("A", "B"), ("B", "A")),
    inconst=("NDOF", "A"),
    outconst=("X0", "C"),
    invar=("Q_MEZ", "A"),
    outvar=("X_MEZ", "X0"),
)


def test_a_name_in_two_lines_is_one_port_of_both_kinds():  # reading 7
    assert TASK.kinds() == {
        "NDOF": PortKind.INCONST,
        "A": PortKind.INBOTH,
        "Q_MEZ": PortKind.INVAR,
        "X0": PortKind.OUTBOTH,
        "C": PortKind.OUTCONST,
        "X_MEZ": PortKind.OUTVAR,
    }


def test_inputs_and_outputs_are_state_variables_by_their_aliases():  # R-C04, R-C07
    assert TASK.inputs == {"NDOF", "B", "Q_SIM"}
    assert TASK.outputs == {"X0", "C", "X_MEZ"}
    assert TASK.svars(("A", "B")) == ("B", "A")


def test_stating_the_period_rather_than_the_rate_is_a_matter_of_taste():
    assert dataclasses.replace(TASK, gives_period=True) == TASK


def test_a_task_is_periodic_unless_it_says_otherwise():  # R-A04
    assert TASK.type is TaskType.PERIODIC
    assert [kind.value for kind in TaskType] == ["periodic", "synchronous", "aperiodic"]
