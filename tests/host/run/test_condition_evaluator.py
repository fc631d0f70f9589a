import pytest

from onika.host.run.condition_evaluator import ConditionEvaluator
from onika.ring.segment import Segment
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.words.shape import Shape


def subsystem(name, **values):
    table = Table(Segment.create("table", SIZE))
    for svar, (shape, data) in values.items():
        entry = table.entry(svar, Shape.parse(shape).resolve({}))
        table.ring(entry.name).write(data)
    return RunningSubsystem(name, table, (), {})


@pytest.fixture
def judge():
    left = subsystem("left", LAMP=("int", (1).to_bytes(4, "little")))
    right = subsystem("right", LAMP=("int", (0).to_bytes(4, "little")))
    return ConditionEvaluator({0: left, 1: right})


def test_a_variable_is_looked_for_in_the_flow_that_asks(judge):  # R-D13
    assert judge.holds(0, "LAMP == 1")
    assert not judge.holds(1, "LAMP == 1")


def test_an_address_names_another_flow(judge):  # R-D13
    assert judge.holds(1, "left/LAMP == 1")
    assert not judge.holds(0, "right/LAMP >= 1")


@pytest.mark.parametrize("text", ["NOWHERE == 0", "nobody/LAMP == 1", "LAMP[0] == 1"])
def test_what_is_not_there_never_holds(judge, text):  # law 8
    assert not judge.holds(0, text)


def test_what_is_no_condition_is_the_programmers_fault(judge):
    with pytest.raises(ValueError, match="expected an address"):
        judge.holds(0, "import os")
