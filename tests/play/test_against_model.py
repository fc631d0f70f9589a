"""Random applications under the engine, beside a second, plain reading of the specification (R-E04 to R-E08, R-E13).

Every word is heard at once here; late words are the matter of `test_explored`.
"""

from itertools import count

import pytest
from hypothesis import settings, strategies as st
from hypothesis.stateful import (
    RuleBasedStateMachine,
    initialize,
    invariant,
    precondition,
    rule,
)

from kit.engine.engine_sim import RUNTIME, EngineSim
from kit.engine.reference_engine import ReferenceEngine
from kit.examples import examples
from kit.plans.program_tree import Act, Loop, Pick, Side, engine_for, planned
from onika.engine import news
from onika.engine.orders import Began, Done, Settle
from onika.wire import steer
from onika.words.reason import Reason

NOOP = Act(tasks=(), is_noop=True)
TASKS = (("move", "arm"), ("grip", "arm"), ("move", "view"), ("arm", "view"))

real = st.builds(
    Act, st.sampled_from(["", "", "a", "b"]), st.sampled_from(TASKS), breakpoint=st.sampled_from([None, None, "", "A"])
)
idle = st.builds(
    Act, st.sampled_from(["", "", "a"]), st.just(()), st.just(True), st.sampled_from([None, None, "", "A"])
)
conditions = st.sampled_from(["", "", "A", "B"])
acts = st.one_of(real, real, real, idle)


INTRICATE = (
    Loop("l", (Loop("k", (Act(), Act())), Act())),
    Loop("l", (Loop("k", (Act(), Act()), is_top=True), Act())),
    Loop("l", (Side(((Act("a"), Act("a")), (Act("a"), Act(), Act("a")))), Act())),
)
"""What chance would make too seldom."""


def nodes(depth):
    if not depth:
        return acts
    inner = st.lists(nodes(depth - 1), max_size=2).map(tuple)
    return st.one_of(
        acts,
        acts,
        st.sampled_from(INTRICATE),
        st.builds(
            lambda first, body, last, when: Loop("l", (first, *body, last), False, when), real, inner, acts, conditions
        ),
        st.builds(
            lambda first, body, last, when: Loop("l", (first, *body, last), True, when), acts, inner, real, conditions
        ),
        st.builds(lambda first, two, when: Pick((first, two), (when,) if when else ()), inner, inner, conditions),
        st.builds(lambda first, two: Side((first, two)), inner, inner),
    )


applications = st.lists(st.lists(nodes(2), max_size=4).map(tuple), min_size=1, max_size=3)


def renamed(tree, numbers, within=""):
    """The same with a name of its own for every loop, and tags of their own for every nested application."""
    made = []
    for node in tree:
        match node:
            case Act():
                made.append(Act(within + node.tag if node.tag else "", node.tasks, node.is_noop, node.breakpoint))
            case Loop():
                name = f"l{next(numbers)}"
                made.append(Loop(name, renamed(node.body, numbers, within), node.is_top, node.condition))
            case Pick():
                made.append(Pick(tuple(renamed(flow, numbers, within) for flow in node.flows), node.conditions))
            case Side():
                inside = f"n{next(numbers)} "
                made.append(Side(tuple(renamed(flow, numbers, inside) for flow in node.flows)))
    return tuple(made)


class Comparison(RuleBasedStateMachine):
    """One application, told to both."""

    @initialize(trees=applications)
    def begin(self, trees):
        numbers = count()
        trees = [renamed(tree, numbers) for tree in trees]
        plan = planned(*trees)
        self.true = set()
        judged = engine_for(plan, stands_still=True, judge=lambda _flow, condition: condition in self.true)
        self.theatre = EngineSim(plan, judged)
        self.small = ReferenceEngine(*trees, judge=lambda condition: condition in self.true)
        self.told = []
        self.flows = len(plan.flows)
        self.feed(news.Run())
        self.small.run()

    def feed(self, message):
        self.note(self.theatre.feed(message))
        while self.theatre.speakers():
            address = self.theatre.speakers()[0]
            if address == RUNTIME:
                break
            self.note(self.theatre.hear(address))

    def note(self, orders):
        kinds = {Began: "began", Done: "done"}
        self.told += [(kinds[type(order)], order.flow, order.index) for order in orders if type(order) in kinds]
        self.settles = any(isinstance(order, Settle) for order in orders) or getattr(self, "settles", False)

    def may(self, act):
        return not self.theatre.engine.refusal(act)

    @rule(which=st.integers(0, 9), choice=st.sampled_from([0, 0, 1, 2]), loop=st.booleans())
    def finishes(self, which, choice, loop):
        self.finish(which, choice, loop)

    @rule(which=st.integers(0, 9), loops=st.lists(st.booleans(), min_size=1, max_size=6))
    def some_finish(self, which, loops):
        for loop in loops:
            self.finish(which, 0, loop)
            self.both_are_in_the_same_place()

    def finish(self, which, choice, loop):
        triggers = list(self.theatre.triggers_on())
        if triggers:
            address = triggers[which % len(triggers)]
            self.theatre.say(address, news.Finished(*address, choice, loop), "off")
            self.feed_mail()
            self.small.finished(address[0], choice, loop)

    def feed_mail(self):
        while speakers := [speaker for speaker in self.theatre.speakers() if speaker != RUNTIME]:
            self.note(self.theatre.hear(speakers[0]))

    @rule(which=st.integers(0, 19))
    def fails(self, which):
        on = self.theatre.on()
        if on and which < len(on):
            flow, task = on[which]
            self.theatre.say((flow, task), news.Failed(flow, task, Reason.plain("broke")), "error")
            self.feed_mail()
            self.small.failed(flow, task)

    def name(self, flow):
        return self.theatre.plan.flows[flow].subsystem

    @rule(which=st.integers(0, 9))
    def pauses(self, which):
        flow = which % self.flows
        states = ("running", "waiting", "joining", "stopped")
        assert self.may(steer.Pause(self.name(flow))) == (self.small.flows[flow].state in states)
        if self.may(steer.Pause(self.name(flow))):
            self.feed(steer.Pause(self.name(flow)))
            self.small.pause(flow)

    @rule(which=st.integers(0, 9))
    def resumes(self, which):
        flow = which % self.flows
        small = self.small.flows[flow]
        assert self.may(steer.Resume(self.name(flow))) == (small.state == "paused" or small.is_pausing)
        if self.may(steer.Resume(self.name(flow))):
            self.feed(steer.Resume(self.name(flow)))
            self.small.resume(flow)

    @rule(which=st.integers(0, 9))
    def steps(self, which):
        flow = which % self.flows
        if self.may(steer.Step(self.name(flow))):
            self.feed(steer.Step(self.name(flow)))
            self.small.resume(flow, steps=True)

    @rule(which=st.integers(0, 9), action=st.one_of(st.none(), st.integers(0, 9)))
    def skips(self, which, action):
        flow = which % self.flows
        skip = steer.Skip(self.name(flow), action)
        if self.may(skip):
            self.feed(skip)
            self.small.skip(flow, action)

    @rule(which=st.integers(0, 9))
    def passes(self, which):
        flow = which % self.flows
        if self.may(steer.Pass(self.name(flow))):
            assert self.small.flows[flow].state in ("waiting", "joining")
            self.feed(steer.Pass(self.name(flow)))
            self.small.let_pass(flow)

    @rule(which=st.integers(0, 9))
    def leaves(self, which):
        flow = which % self.flows
        if self.small.flows[flow].state in ("running", "waiting") and self.may(steer.Leave(self.name(flow))):
            self.feed(steer.Leave(self.name(flow)))
            self.small.leave(flow)

    @rule(which=st.integers(0, 9))
    def recovers(self, which):
        flow = which % self.flows
        assert self.may(steer.Recover(self.name(flow))) == (self.small.flows[flow].state == "stopped")
        if self.may(steer.Recover(self.name(flow))):
            self.feed(steer.Recover(self.name(flow)))
            self.small.recover(flow)

    @rule(condition=st.sampled_from("AB"))
    def turns(self, condition):
        self.true ^= {condition}

    @precondition(lambda self: hasattr(self, "theatre"))
    @invariant()
    def both_are_in_the_same_place(self):
        names = [flow.subsystem for flow in self.theatre.plan.flows]
        for number, place in enumerate(self.theatre.engine.positions()):
            small = self.small.flows[number]
            assert (place.state, place.action) == (small.state, small.action)
            assert place.tag == (small.at[1] if small.state == "waiting" else "")
            assert {names.index(name) for name in place.waits_for} == self.small.waits_for(number)
            if small.state != "done":
                assert place.is_pausing == small.is_pausing
            if small.state == "running":
                assert list(place.loops) == small.loops
            on = {task for flow, task in self.theatre.on() if flow == number}
            assert on == small.on
        for number in range(len(names)):
            assert [mark for mark in self.told if mark[1] == number] == [
                mark for mark in self.small.told if mark[1] == number
            ]
        assert not self.small.is_done or self.settles


Comparison.TestCase.settings = settings(max_examples=examples(150), stateful_step_count=25, deadline=None)
test_the_engine_does_what_a_plain_reading_of_the_specification_does = Comparison.TestCase


STORIES = {
    "who skips a tag in a nested application, and who is let pass there, meet in the next round": (  # R-D13
        (Loop("l", (Side(((Act("a"),), (Act(), Act("a"), Act()))), Act())),),
        [("skip", 1, 2), ("pass", 0), *[("finish", 0, True)] * 6],
    ),
    "a loop that was left is not left again in the next round": (  # R-E07
        (Loop("l", (Loop("k", (Act(), Act())), Act())),),
        [("leave", 0), *[("finish", 0, True)] * 8],
    ),
    "a value beyond the flows takes flow 0": (  # reading 20
        (Act(), Pick(((Act(),), (Act(),)))),
        [("finish", 2, False), ("finish", 0, False)],
    ),
    "a flow that has ended pauses no more, though one of its tasks fails then": (  # R-E13
        (Act(),),
        [("pause", 0), ("skip", 0, None), ("fail", 0)],
    ),
}
"""What chance hardly ever tells."""


def tell(name):
    tree, acts_of_it = STORIES[name]
    story = Comparison()
    story.begin(trees=[tree])
    for kind, *what in acts_of_it:
        if kind == "finish":
            story.finish(0, *what)
        elif kind == "skip":
            flow, action = what
            story.feed(steer.Skip(story.name(flow), action))
            story.small.skip(*what)
        else:
            {"pass": story.passes, "leave": story.leaves, "pause": story.pauses, "fail": story.fails}[kind](*what)
        story.both_are_in_the_same_place()
    return story


@pytest.mark.parametrize("name", STORIES)
def test_a_story_that_chance_hardly_ever_tells(name):
    assert tell(name).told
