"""The second engine by itself: what it says of cases that can be worked out by hand."""

import pytest

from kit.engine.reference_engine import ReferenceEngine
from kit.plans.program_tree import Act, Loop, Pick, Side

NOOP = Act(tasks=(), is_noop=True)


def begun(small):
    return [action for kind, flow, action in small.told if (kind, flow) == ("began", 0)]


@pytest.mark.parametrize(
    ("tree", "values", "actions"),
    [
        ((Act(), Act()), [(0, True)] * 2, [0, 1]),
        ((Loop("l", (Act(), Act())), Act()), [(0, False), (0, True), (0, False), (0, False)], [0, 1, 0, 1, 2]),
        ((Loop("l", (Act(), Act()), is_top=True), Act()), [(0, True), (0, False), (0, False)], [0, 1, 0, 2]),
        ((Act(), Pick(((Act(),), (Act(),))), Act()), [(1, False), (0, False)], [0, 2, 3]),
        ((Act(), Pick(((Act(),), (Act(),)))), [(7, False)], [0, 1]),
        ((NOOP, Pick(((Act(),), (Act(),)))), [], [0, 1]),
    ],
)
def test_actions_follow_as_the_tree_says(tree, values, actions):  # R-E05, R-E06, reading 20
    small = ReferenceEngine(tree)
    small.run()
    for choice, loop in values:
        small.finished(0, choice, loop)
    assert begun(small) == actions


def test_flows_wait_for_each_other_and_pass_when_they_are_let():  # R-E04
    small = ReferenceEngine((Act("a"), Act("b")), (Act("a"), Act(), Act("b")))
    small.run()
    small.finished(0, 0, False)
    assert (small.flows[0].state, small.waits_for(0)) == ("waiting", {1})
    small.let_pass(0)
    assert (small.flows[0].state, small.flows[0].action) == ("running", 1)


def test_a_nested_application_is_awaited():  # R-D13
    small = ReferenceEngine((Side(((Act(),), (Act(), Act()))), Act()))
    small.run()
    small.finished(0, 0, False)
    assert (small.flows[0].state, small.waits_for(0)) == ("joining", {1})
    for _ in range(2):
        small.finished(1, 0, False)
    assert (small.flows[0].state, small.flows[0].action) == ("running", 1)


def test_an_error_is_cleared_and_the_step_repeated():  # R-E08
    small = ReferenceEngine((Act(), Act()))
    small.run()
    small.failed(0, "arm")
    assert (small.flows[0].state, small.flows[0].on) == ("stopped", set())
    small.recover(0)
    assert (small.flows[0].state, small.flows[0].on, begun(small)) == ("running", {"move", "arm"}, [0, 0])


def test_a_skip_goes_into_a_loop_and_takes_the_value_away():  # R-E13, reading 22
    small = ReferenceEngine((Act(), Loop("l", (Act(), Act())), Act()))
    small.run()
    small.skip(0, 2)
    assert small.flows[0].loops == ["l"]
    small.skip(0, None)
    assert (small.flows[0].action, small.flows[0].loops) == (3, [])


def test_a_pause_comes_after_the_action_and_a_step_ends_in_one():  # R-E07
    small = ReferenceEngine((Act(), Act(), Act()))
    small.run()
    small.pause(0)
    small.finished(0, 0, False)
    assert small.flows[0].state == "paused"
    small.resume(0, steps=True)
    small.finished(0, 0, False)
    assert (small.flows[0].state, small.flows[0].action) == ("paused", 1)
