from kit.plans.plan_builder import PlanBuilder
from onika.desk.plan.flow_worlds import driven_worlds, worlds_by_flow
from onika.wire.plan import Plan, PlannedFlow

BARE = "from onika.module import *\n\nclass Bare(Module):\n    pass\n"


def task(name, device=""):
    return PlanBuilder().task(name, BARE, local={"DEVICE": device} if device else {})


def flow(subsystem, *tasks, parent=None):
    return PlannedFlow(subsystem, tasks, (), parent=parent)


def test_a_flow_drives_the_worlds_of_its_tasks_devices():  # R-E09
    assert driven_worlds(flow("flow0", task("a", "yard:m0"), task("b"), task("c", "cell:arm"))) == ("cell", "yard")
    assert driven_worlds(flow("flow0", task("b"))) == ()


def test_what_is_nested_in_a_flow_counts_for_it_whatever_it_is_called():  # R-E09
    outer, other = flow("left.arm", task("a", "cell:arm")), flow("right", task("b"))
    inner = flow("left.arm.1", task("c", "yard:m0"), parent=0)
    innermost = flow("left.arm.1.1", task("d", "sea:boat"), parent=2)
    plan = Plan("play", (outer, other, inner, innermost), ())
    assert worlds_by_flow(plan) == {"left.arm": ("cell", "sea", "yard"), "right": ()}
