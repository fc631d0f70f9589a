import pytest

from kit.plans.flow_program import bottom, branch, nested, program
from onika.desk.plan.begin_places import FlowEnd, begun_at, entry, is_anywhere, places
from onika.engine.program import FlowProgram
from onika.wire.plan import Again, Do, Jump, Meet, Plan, PlannedAction, PlannedFlow, Rest
from onika.words.reason import Reason


def flow(name, count, *parts, parent=None):
    actions = tuple(PlannedAction(f"a{number}", f"a{number}", None, "", (), (), "") for number in range(count))
    return PlannedFlow(name, (), actions, program(*parts) if parts else (), parent)


def plan(*flows):
    return Plan("play", flows, ())


def onward(one, action, *, is_acting=False):
    """Where a flow of one application goes on, as the instruction there, or why it does not."""
    whole = plan(one)
    found = places(whole, {0: FlowEnd(action, is_acting)}, whole)
    return found if isinstance(found, Reason) else FlowProgram(one).instructions[found[one.subsystem]]


def test_what_was_done_is_behind_and_what_was_under_way_is_done_again():  # R-K06
    straight = flow("flow0", 3, Do(0), Rest(0), Meet("m"), Do(1), Do(2))
    assert onward(straight, 0) == Meet("m")  # behind the breakpoint, at the tag
    assert onward(straight, 1, is_acting=True) == Do(1)  # behind the tag, which was met
    assert onward(straight, 2) == FlowProgram(straight).instructions[-1]


def test_where_the_past_decides_what_follows_nobody_goes_on():  # R-K06
    forked = flow("flow0", 3, Do(0), branch([Do(1)], [Do(2)]))
    assert onward(forked, 0).key == "run.goes_on_undecided"
    assert onward(forked, 0, is_acting=True) == Do(0)
    assert onward(flow("flow0", 1, bottom("round", Do(0))), 0).key == "run.goes_on_undecided"
    beside = plan(flow("flow0", 2, Do(0), nested([(1, 0)], Do(1))), flow("flow0.1", 1, parent=0))
    assert places(beside, {0: FlowEnd(1, is_acting=True)}, beside).key == "run.goes_on_nested"
    with pytest.raises(ValueError, match="beside each other"):
        entry(beside.flows[0], 1)


def test_a_plan_that_begins_elsewhere_is_the_same_program_behind_a_jump():  # R-K06
    looped = flow("flow0", 3, Do(0), bottom("round", Do(1)), Do(2))
    begun = begun_at(plan(looped), {"flow0": 1}).flows[0].program
    assert begun == (Jump(2), Do(0), Do(1), Again("round", 2), Do(2), *looped.program[-1:])
    assert begun_at(plan(looped), {"flow0": 0}) == plan(looped)
    forked = plan(flow("flow0", 2, Do(0), nested([(1, 0)]), Do(1)), flow("flow1", 1), flow("flow0.1", 1, parent=0))
    begun_apart = begun_at(forked, {"flow0": 3, "flow1": 0})
    assert begun_apart.flows[1:] == forked.flows[1:]
    assert FlowProgram(begun_apart.flows[0]).parallel_at(3) == (2,)


def test_who_did_nothing_in_a_run_that_began_elsewhere_begins_there_again():  # R-K06
    two = plan(flow("flow0", 2), flow("flow1", 2, Do(0), Meet("m"), Do(1)))
    former = begun_at(two, {"flow0": 1, "flow1": 1})
    ends = {0: FlowEnd(1, is_acting=False), 1: FlowEnd(-1, is_acting=False)}
    assert places(two, ends, former) == {"flow0": 2, "flow1": 1}
    assert not is_anywhere(two, dict.fromkeys(ends, ends[1]))
    assert is_anywhere(former, dict.fromkeys(ends, ends[1]))
