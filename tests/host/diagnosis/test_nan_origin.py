import math

from kit.plans.plan_builder import PlanBuilder
from onika.host.diagnosis.nan_origin import Suspicion, is_no_number, suspicion
from onika.module import InVar, Module, OutVar
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.wiring import wire


def task(name, reads=(), writes=()):
    """A task of a module with these ports, all of them scalars."""
    ports = {port: InVar("double", "N", "read") for port in reads}
    ports |= {port: OutVar("double", "N", "written") for port in writes}
    cls = type(name.capitalize(), (Module,), {"__doc__": "A task.", **ports})
    planned = PlanBuilder().task(name, "from onika.module import Module\nclass One(Module):\n    pass\n")
    return wire(planned, sheet_of(cls))


ROBOT = task("robot", ["TAU"], ["Q"])
PD = task("pd", ["Q", "GOAL"], ["TAU_PD"])
SUM = task("sum", ["TAU_PD", "TAU_G"], ["TAU"])
GRAVITY = task("gravity", ["Q"], ["TAU_G"])
GOAL = task("goal", [], ["GOAL"])
EVERYBODY = (ROBOT, PD, SUM, GRAVITY, GOAL)


def suspected(*wrong, failed=ROBOT):
    return suspicion(failed, EVERYBODY, set(wrong).__contains__)


def test_who_made_what_is_no_number_out_of_proper_numbers_is_suspected():  # R-X06, law 5
    suspects = suspected("TAU")
    assert (suspects.task, suspects.is_made_there) == ("sum", True)
    assert str(suspects.reason) == "TAU is no number: made by sum, of proper numbers"


def test_what_is_no_number_is_followed_upstream():  # R-X06
    suspects = suspected("TAU", "TAU_G")
    assert (suspects.task, suspects.trail) == ("gravity", (("TAU", "sum"), ("TAU_G", "gravity")))
    assert str(suspects.reason) == "TAU is no number: made by sum, out of TAU_G by gravity, of proper numbers"


def test_a_circle_ends_where_it_closes():  # R-X06
    suspects = suspected("TAU", "TAU_PD", "Q")
    assert (suspects.task, suspects.is_made_there) == ("pd", False)
    assert str(suspects.reason) == "TAU is no number: made by sum, out of TAU_PD by pd"


def test_nobody_is_suspected_where_the_task_read_proper_numbers():  # R-X06
    assert suspected("GOAL") == Suspicion()
    assert str(suspected().reason) == suspected().task == ""


def test_what_nobody_writes_accuses_nobody():  # R-X06
    assert suspicion(ROBOT, (ROBOT,), {"TAU"}.__contains__) == Suspicion()


def test_a_number_is_a_finite_one():
    assert [is_no_number(value) for value in (1, 1.0, [1.0, 2.0], "nan", [])] == [False] * 5
    assert [is_no_number(value) for value in (math.nan, -math.inf, [[1.0], [math.nan]])] == [True] * 3
