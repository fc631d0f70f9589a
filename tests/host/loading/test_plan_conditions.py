import pytest
from msgspec import structs

from kit.plans.plan_builder import PlanBuilder, action
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_conditions import wrong_conditions
from onika.host.loading.plan_preparation import prepare
from onika.wire.plan import Again, Choose, Do, Halt, Jump, Rest, Unless

ARM = """
from onika.module import Module, OutConst, OutVar

class Arm(Module):
    trigger = True
    NDOF = OutConst("int", "-", "number of joints")
    Q_MEZ = OutVar("double[NDOF]", "rad", "where it is")
    LAMP = OutVar("int", "-", "whether it is lit")
    NAME = OutVar("string", "-", "what it is called")
"""


def wrong_in(*program, subsystem="flow0"):
    shop = PlanBuilder()
    shop.task("arm", ARM)
    plan = shop.plan([action("arm"), action("arm")])
    flow = structs.replace(plan.flows[0], program=program, subsystem=subsystem)
    prepared = prepare(structs.replace(plan, flows=(flow,)), (), ModuleFacts())
    return wrong_conditions((flow,), prepared.flows, {0: {"NDOF": 6}})


def rest(condition):
    return wrong_in(Do(0), Rest(0, condition), Do(1), Halt())


@pytest.mark.parametrize("condition", ["LAMP == 1", "Q_MEZ[5] > 0.5", "flow0/LAMP != 0", "NDOF == 6", ""])
def test_what_names_one_number_is_sound(condition):  # R-D13
    assert rest(condition) == []


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("Q_MEZ > 0", "one number of Q_MEZ, which is double[6] and counted from 0"),
        ("Q_MEZ[6] > 0", "one number of Q_MEZ, which is double[6] and counted from 0"),
        ("Q_MEZ[0,1] > 0", "one number of Q_MEZ, which is double[6] and counted from 0"),
        ("LAMP[0] == 1", "one number of LAMP, which is int and counted from 0"),
        ("NAME == 1", "a condition on numbers; NAME is string"),
        ("ELSEWHERE == 1", "a variable that a task of flow0 reads or writes"),
        ("flow7/LAMP == 1", "a variable that a task of flow7 reads or writes"),
        ("later", "an address, a comparison and a number, as in 'LAMP == 1'"),
    ],
)
def test_what_could_never_hold_is_told_with_its_action(condition, expected):  # R-D13, R-E01
    (fault,) = rest(condition)
    assert str(fault.reason) == f"expected {expected}, found {condition}"
    assert str(fault.instead) == "the application is not run"
    assert fault.place.file == "test.appl"


def test_loops_and_branches_are_looked_at_too():  # R-D13
    wrong = "Q_MEZ[9] > 0"
    assert len(wrong_in(Choose((1, 3), (wrong,)), Do(0), Jump(3), Do(1), Halt())) == 1
    assert len(wrong_in(Do(0), Again("l", 0, wrong), Do(1), Halt())) == 1
    assert len(wrong_in(Do(0), Unless("l", 4, wrong), Do(1), Jump(0, "l"), Halt())) == 1
