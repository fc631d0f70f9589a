from onika.desk.plan.plan_part import flows_of, part_of
from onika.wire.plan import Code, Do, Fork, Halt, Join, Plan, PlannedFlow


def flow(subsystem, parent=None, program=()):
    return PlannedFlow(subsystem, (), (), program, parent)


PLAN = Plan(
    "play",
    (
        flow("flow0"),
        flow("flow1", program=(Do(0), Fork(((2, 0), (3, 4)), "both"), Join((2, 3)), Halt())),
        flow("flow1.0", 1),
        flow("flow1.1", 1),
        flow("flow2"),
    ),
    (Code("1", "m", "m.py", ""),),
)


def test_nested_flows_stay_with_their_parent():  # R-E12, R-D13
    assert flows_of(PLAN, ("flow1",)) == (1, 2, 3)
    assert flows_of(PLAN, ("flow0", "flow2")) == (0, 4)


def test_a_part_is_a_plan_of_its_own():  # R-E12
    part = part_of(PLAN, (1, 2, 3))
    assert [flow.subsystem for flow in part.flows] == ["flow1", "flow1.0", "flow1.1"]
    assert [flow.parent for flow in part.flows] == [None, 0, 0]
    assert part.flows[0].program == (Do(0), Fork(((1, 0), (2, 4)), "both"), Join((1, 2)), Halt())
    assert part.code == () and part.application == "play"  # no task of it has that code
