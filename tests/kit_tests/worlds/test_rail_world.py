from kit.plans.plan_builder import action
from kit.worlds.rail_world import YardLoading, rail_tasks
from onika.host.loading.plan_preparation import prepare
from onika.wire.request import TargetValues


def test_the_rail_is_a_plan_that_can_run():
    plan = rail_tasks().plan([action("mass", "servo", arguments="1")])
    prepared = prepare(plan, [TargetValues(0, 0, "joint object", (1.0,))], YardLoading())
    assert prepared.faults == []
    assert prepared.triggers == {(0, 0): "servo"}
    assert prepared.constants == {0: {"SIDES": 2}}


def test_the_rail_has_an_end():
    plan = rail_tasks(rtpu="rt1", mass="yard:m1").plan([action("mass", "servo", arguments="1")])
    assert [task.rtpu for task in plan.flows[0].tasks] == ["unknown", "rt1"]
    prepared = prepare(plan, [TargetValues(0, 0, "joint object", (11.0,))], YardLoading())
    assert [str(fault.reason) for fault in prepared.faults] == [
        "expected a target within reach, found there: 11 m is beyond the rail"
    ]
