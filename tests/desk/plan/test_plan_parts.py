import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from onika.desk.plan.plan_parts import BEGIN, parts_of, shared_tags
from onika.wire.plan import Again, Choose, Do, Fork, Halt, Join, Jump, Meet, Unless
from onika.wire.rendezvous_link import SharedTag
from onika.wire.request import TargetValues

TASK = """
from onika.module import Module

class Task(Module):
    trigger = True
"""


@pytest.fixture
def plan():
    """Three flows, of which the last is nested in the first."""
    shop = PlanBuilder()
    for name in ("a", "b", "c"):
        shop.task(name, TASK.replace("Task", f"Task{name}"), module=f"task{name}")
    whole = shop.plan([action("a")], [action("b")], [action("c")])
    programs = (
        (Do(0), Fork(((2, 0),)), Join((2,)), Meet("x"), Again("l", 0), Halt()),
        (Choose((2, 3)), Unless("m", 3), Jump(0), Meet("x"), Do(0), Halt()),
        (Meet("flow2 inner"), Do(0), Halt()),
    )
    flows = [replace(flow, program=program) for flow, program in zip(whole.flows, programs, strict=True)]
    return replace(whole, flows=(flows[0], flows[1], replace(flows[2], parent=0)))


def test_each_runtime_gets_its_flows_those_nested_in_them_and_their_code(plan):  # R-E12, R-F02
    first, second = parts_of(plan, {"flow0": 0, "flow1": 1})
    assert (first.flows, second.flows) == ((0, 2), (1,))
    assert [flow.subsystem for flow in first.plan.flows] == ["flow0", "flow2"]
    assert first.plan.flows[1].parent == 0
    assert [code.module for code in first.plan.code] == ["taska", "taskc"]
    assert [code.module for code in second.plan.code] == ["taskb"]


def test_all_begin_at_a_tag_and_every_place_and_number_is_moved_with_it(plan):
    first, second = parts_of(plan, {"flow0": 0, "flow1": 1})
    begin = Meet(BEGIN)
    assert first.plan.flows[0].program == (
        begin, Do(0), Fork(((1, 0),)), Join((1,)), Meet("x"), Again("l", 1), Halt()
    )  # fmt: skip
    assert second.plan.flows[0].program == (
        begin, Choose((3, 4)), Unless("m", 4), Jump(1), Meet("x"), Do(0), Halt()
    )  # fmt: skip
    assert first.plan.flows[1].program == plan.flows[2].program


def test_a_straight_flow_gets_a_program(plan):
    straight = replace(plan, flows=(replace(plan.flows[0], program=()), plan.flows[1]))
    first, _ = parts_of(straight, {"flow0": 0, "flow1": 1})
    assert first.plan.flows[0].program == (Meet(BEGIN), Do(0), Halt())


def test_tags_of_several_runtimes_are_shared_and_others_are_not(plan):
    parts = parts_of(plan, {"flow0": 0, "flow1": 1})
    assert shared_tags(parts) == (SharedTag(BEGIN, (0, 1)), SharedTag("x", (0, 1)))


def test_targets_go_with_their_flows(plan):
    first, second = parts_of(plan, {"flow0": 0, "flow1": 1})
    whole = tuple(TargetValues(flow, 0, "joint object", ()) for flow in range(3))
    assert [target.flow for target in first.targets(whole)] == [0, 1]
    assert [target.flow for target in second.targets(whole)] == [0]
