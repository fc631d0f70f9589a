from onika.desk.plan.subsystem_renaming import chiefs, rehoused
from onika.wire.plan import Again, Choose, Do, Plan, PlannedFlow, Rest, Unless


def test_flows_and_those_nested_in_them_move_together():
    flows = (PlannedFlow("flow0", (), ()), PlannedFlow("flow1", (), ()), PlannedFlow("flow0.1", (), (), parent=0))
    plan = Plan("play", flows, ())
    moved = rehoused(plan, {"flow0": "left"})
    assert [flow.subsystem for flow in moved.flows] == ["left", "flow1", "left.1"]
    assert chiefs(plan) == ("flow0", "flow1")


def test_conditions_are_asked_where_their_variables_are():
    program = (Do(0), Rest(0, "flow1/Q > 3"), Again("l", 0, "Q > 3"), Choose((1, 2), ("flow1/A == 1",)), Unless("l", 1))
    plan = Plan("play", (PlannedFlow("flow0", (), (), program), PlannedFlow("flow1", (), ())), ())
    moved = rehoused(plan, {"flow1": "right"}).flows[0].program
    assert moved == (
        Do(0), Rest(0, "right/Q > 3"), Again("l", 0, "Q > 3"), Choose((1, 2), ("right/A == 1",)), Unless("l", 1),
    )  # fmt: skip
