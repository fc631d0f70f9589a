from kit.plans.plan_builder import PlanBuilder
from onika.desk.plan.flow_guests import guest_of, guests_by_flow
from onika.wire.plan import Plan, PlannedAction, PlannedFlow

BARE = "from onika.module import *\n\nclass Bare(Module):\n    pass\n"


def task(name, guest=""):
    return PlanBuilder().task(name, BARE, local={"GUEST": guest} if guest else {})


def action(*tasks, is_noop=False):
    return PlannedAction("a", "aC", None, "", tasks, (), "", is_noop=is_noop)


def flow(subsystem, tasks, *actions, parent=None):
    return PlannedFlow(subsystem, tasks, actions, parent=parent)


ORACLE, ASKS, ARM = task("oracle", "oracle"), task("asks", "oracle"), task("arm")


def test_a_flow_all_of_whose_actions_one_guest_carries_out_is_its():  # R-A20
    theirs = flow("flow1", (ORACLE, ASKS), action("oracle", "asks"), action(is_noop=True), action("asks"))
    assert guest_of((theirs,)) == "oracle"


def test_a_flow_that_asks_a_guest_now_and_then_or_two_of_them_is_nobodys():  # R-A20
    assert guest_of((flow("flow0", (ARM, ASKS), action("arm"), action("asks")),)) == ""
    other = task("other", "augur")
    assert guest_of((flow("flow0", (other, ASKS), action("other"), action("asks")),)) == ""
    assert guest_of((flow("flow0", ()),)) == ""


def test_what_is_nested_in_a_flow_counts_for_it():  # R-A20
    theirs, ours = flow("flow0", (ASKS,), action("asks")), flow("flow1", (ASKS,), action("asks"))
    more, moves = flow("x", (ORACLE,), action("oracle"), parent=0), flow("y", (ARM,), action("arm"), parent=1)
    assert guests_by_flow(Plan("seance", (theirs, ours, more, moves), ())) == {"flow0": "oracle"}
