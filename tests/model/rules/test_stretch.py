"""What a flow can come to, as far as it is known before the run (readings 21 and 22, R-D11, R-X03)."""

import pytest

from kit.plans import build
from kit.plans.program_tree import Act, Loop, Pick, Side, planned
from onika.model.rules.stretch import ENDLESS, IDLE, FlowOutcome, FlowStop, ReturnValue, program_of, ways
from onika.wire.plan import Do, Halt, Meet, Rest
from onika.words.reason import Reason

MEET = Act("a")
NOOP = Act(tasks=(), is_noop=True)


def stops(*tree, at=0, value=ReturnValue.NONE):
    flow = planned(tree).flows[0]
    return [way.stop.at if way.stop != IDLE else "end" for way in ways(flow, flow.program, at, value)]


@pytest.mark.parametrize(
    ("tree", "result"),
    [
        ((Act(), MEET), [1]),
        ((Act(),), ["end"]),
        ((Act(), Pick(((MEET,), ()))), [2, "end"]),
        ((Act(), Loop("l", (Act(), Act())), MEET), [4]),
        ((Loop("l", (MEET, Act())),), [0]),
        ((Pick(((MEET,), ())),), [1]),  # no value before: flow 0
        ((NOOP, Pick(((MEET,), ()))), [2]),  # a no-op returns flow 0
        ((NOOP, Pick(((MEET,), ()), ("A > 1",))), [2, "end"]),  # conditions are not known before
        ((Loop("l", (Act(), NOOP)), MEET), [-2]),  # a no-op goes on for ever
        ((Loop("l", (NOOP, Act()), is_top=True), MEET), [-2]),
    ],
)
def test_every_stop_is_found_that_the_values_allow(tree, result):
    assert stops(*tree) == result


@pytest.mark.parametrize(
    ("value", "result"), [(ReturnValue.NONE, [5]), (ReturnValue.NOOP, [0]), (ReturnValue.ANY, [5, 0])]
)
def test_a_test_goes_by_the_value_before_it(value, result):
    assert stops(Loop("l", (MEET, Act("b"))), Act("c"), at=4, value=value) == result


def takes(number):
    return Reason.of("rules.takes_flow", number=number, branch=Reason.of("rules.branch"))


def test_the_flows_that_are_begun_on_the_way_are_told_with_their_choices():  # R-D13
    flow = planned((Act(), Pick(((Side(((), (MEET,))),), ())))).flows[0]
    result = ways(flow, flow.program, 0, ReturnValue.NONE)
    assert result == (
        FlowOutcome(FlowStop(3, ReturnValue.ANY), ((1, 0),), (takes(0),)),
        FlowOutcome(IDLE, (), (takes(1),)),
    )


def test_a_loop_that_waits_nowhere_and_is_never_left_is_endless():
    flow = planned((Loop("l", (NOOP, NOOP)),)).flows[0]
    assert ways(flow, flow.program, 0, ReturnValue.NONE) == (FlowOutcome(ENDLESS, (), ()),)


def test_a_value_that_nobody_will_look_at_is_forgotten():
    (way,) = ways(flow := planned((NOOP, MEET)).flows[0], flow.program, 0, ReturnValue.NONE)
    assert way.stop == FlowStop(1, ReturnValue.ANY)


def test_without_a_program_the_actions_follow_each_other_with_their_tags():
    jobs = [build.job("move", trigger="move", synch_tag=tag) for tag in (None, "a")]
    flow = build.plan(jobs).flows[0]
    assert program_of(flow) == (Do(0), Meet("a"), Do(1), Halt())


def test_a_program_is_taken_as_it_is():
    flow = planned((Act(breakpoint=""),)).flows[0]
    assert program_of(flow) == (Do(0), Rest(0), Halt())
