import msgspec

from kit.plan_builder import action
from kit.rail_world import rail_tasks
from onika.wire.plan import Plan


def test_a_plan_travels_whole():
    plan = rail_tasks(rtpu="rt1").plan([action("mass", "servo", arguments='1 "two words"', rates={"mass": 250.0})])
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(plan), type=Plan) == plan


def test_a_plan_cannot_be_changed_and_equal_plans_are_equal():
    first, other = (rail_tasks().plan([action("mass", "servo")]) for _ in range(2))
    assert first == other
    for part in (first, first.flows[0], first.flows[0].tasks[0], first.flows[0].actions[0], first.code[0]):
        assert part.__struct_config__.frozen
