"""The transfer of what hardware is given: measured, blended or refused (law 33, requirement X04)."""

import math
from itertools import pairwise

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.runtime.executive_rig import HOME, ExecutiveRig
from kit.worlds.mass_world import MassWorld
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.modules.code import load
from onika.runtime.modules.module import Module
from onika.runtime.transfer.bumpless_channel import BLENDED_NS
from onika.runtime.transfer.bumpless_transfer import limit_of

MS = 1_000_000
LIMIT = 0.1
MOST = BLENDED_NS // (2 * MS)
"""Cycles over which a step may be blended at 500 Hz."""

HAND = """
from onika.module import InVar, Local, Module

class Hand(Module):
    hardware = True
    REF = InVar("double[2]", "N", "what it is given", step={step})
    LIMIT = Local("double", "N", "what one cycle may change it by", default=0.1)

    def init(self):
        self.given = []

    def on(self, inputs):
        self.given.append(None)

    def hold(self):
        self.given.append(None)
        self.device.hold()

    def cycle(self):
        self.given.append(self.REF.copy())
        self.device.write((self.REF[0],))
"""

SOURCE = """
from onika.module import Module, OutVar

class {name}(Module):
    {out} = OutVar("double[2]", "N", "what it wants")

    def on(self, inputs):
        self.count = 0
        if {at_once}:
            self.{out} = ({level}, -{level})

    def cycle(self):
        self.count += 1
        self.{out} = ({level} + {sway} * (self.count % 2) * (self.count >= {after}), -{level})
"""

FOLLOWER = """
from onika.module import InVar, Module, OutVar

class Follower(Module):
    GOAL = InVar("double[2]", "N", "what is wanted")
    REF = OutVar("double[2]", "N", "the same")

    def cycle(self):
        self.REF = self.GOAL
"""


def source(name: str, level: float, out: str = "REF", sway: float = 0.0, at_once: bool = True, after: int = 0) -> str:
    """A module that wants a level, and sways about it after so many cycles."""
    return SOURCE.format(name=name.title(), level=level, out=out, sway=sway, at_once=at_once, after=after)


def hand_rig(step: str = '"LIMIT"', **given) -> ExecutiveRig:
    """A hand at 500 Hz, which has not come on yet."""
    return ExecutiveRig(MassWorld()).spawn(
        "hand", HAND.format(step=step), frequency=500.0, device="m0", rank=0, **given
    )


def driven(rig: ExecutiveRig, level: float, **given) -> ExecutiveRig:
    """The hand is driven by `first` and nothing is watched any more."""
    rig.spawn("first", source("first", level, **given), rank=1).switch(on=["hand", "first"])
    rig.run(rig.now + 200 * MS)
    rig.news.clear()
    return rig


def steps(rig: ExecutiveRig) -> list[news.Stepped]:
    return rig.news_of(news.Stepped)


def largest_step(rig: ExecutiveRig) -> float:
    """The largest step from one cycle to the next in what the hand was given; None stands where it held."""
    given = rig.task("hand").module.given
    pairs = [(a, b) for a, b in pairwise(given) if a is not None and b is not None]
    return max((float(abs(b - a).max()) for a, b in pairs), default=0.0)


def test_a_step_within_its_limit_is_measured_and_passed_on_as_it_is():  # R-X04
    rig = driven(hand_rig(), 0.0)
    rig.spawn("second", source("second", 0.05), rank=1).switch(off=["first"], on=["second"]).run(rig.now + 200 * MS)
    (stepped,) = steps(rig)
    assert (stepped.variable, stepped.unit, stepped.step, stepped.given) == ("REF", "N", 0.05, 0.05)
    assert (stepped.limit, stepped.cycles) == (LIMIT, 0)


def test_a_step_beyond_its_limit_is_blended_within_it_and_told_with_its_numbers():  # R-X04
    rig = driven(hand_rig(), 0.0)
    rig.spawn("second", source("second", 1.0), rank=1).switch(off=["first"], on=["second"]).run(rig.now + 200 * MS)
    (stepped,) = steps(rig)
    assert (stepped.step, stepped.cycles) == (1.0, 20)
    assert stepped.given <= LIMIT
    assert largest_step(rig) <= LIMIT * (1 + 1e-9)
    assert list(rig.task("hand").module.given[-1]) == [1.0, -1.0]


def test_what_comes_through_other_tasks_is_blended_too():  # R-X04
    rig = hand_rig().spawn("follower", FOLLOWER, rank=2)
    rig.spawn("first", source("first", 0.0, "GOAL"), frequency=50.0, rank=1)
    rig.spawn("second", source("second", 2.0, "GOAL"), frequency=50.0, rank=1)
    rig.switch(on=["hand", "first", "follower"]).run(200 * MS)
    rig.switch(off=["first"], on=["second"]).run(500 * MS)
    assert max(event.step for event in steps(rig)) == 2.0
    assert largest_step(rig) <= LIMIT * (1 + 1e-9)
    assert list(rig.task("hand").module.given[-1]) == [2.0, -2.0]


def test_what_on_leaves_for_a_device_and_cannot_be_blended_is_refused_before_anybody_sees_it():  # R-X04
    rig = driven(hand_rig(), 0.0)
    rig.spawn("second", source("second", 100.0), rank=1).switch(off=["first"], on=["second"]).run(rig.now + 200 * MS)
    (refused,) = rig.news_of(news.Refused)
    assert refused.command == "on"
    assert refused.reason == (
        "REF[0] would step by 100 N: a cycle may change it by 0.1 N, 0.1 s by 5 N; "
        "begin near 0 N, or turn hand off first and on again after this task"
    )
    assert rig.task("second").state is State.OFF
    assert rig.task("hand").state is State.ON
    assert largest_step(rig) == 0.0


def test_what_the_refusal_says_helps_does_help():  # R-X04, R-X01
    rig = driven(hand_rig(), 0.0)
    rig.spawn("second", source("second", 100.0), rank=1).switch(off=["first"], on=["second"]).run(rig.now + 200 * MS)
    rig.switch(off=["hand"]).run(rig.now + 20 * MS).switch(on=["second"]).run(rig.now + 20 * MS)
    rig.switch(on=["hand"]).run(rig.now + 200 * MS)
    assert (rig.task("second").state, rig.task("hand").state) == (State.ON, State.ON)
    assert list(rig.task("hand").module.given[-1]) == [100.0, -100.0]
    assert largest_step(rig) == 0.0


def test_what_nobody_could_foresee_and_cannot_be_blended_makes_the_device_hold():  # R-X04
    rig = driven(hand_rig(), 0.0)
    rig.spawn("second", source("second", 100.0, at_once=False), rank=1)
    rig.switch(off=["first"], on=["second"]).run(rig.now + 200 * MS)
    (failed,) = rig.news_of(news.Failed)
    assert failed.task == "hand"
    assert "REF[0] would step by 100 N: a cycle may change it by 0.1 N, 0.1 s by 5 N;" in failed.text
    assert "turn off what came on" in failed.text
    assert largest_step(rig) == 0.0
    (stepped,) = steps(rig)
    assert (stepped.step, stepped.given, stepped.cycles) == (100.0, 0.0, 0)


def test_after_the_fault_is_cleared_it_begins_anew_from_a_hold():  # R-X04
    rig = driven(hand_rig(), 0.0)
    rig.spawn("second", source("second", 100.0, at_once=False), rank=1)
    rig.switch(off=["first"], on=["second"]).run(rig.now + 200 * MS)
    rig.do(command.Clear(HOME, "hand")).switch(on=["hand"]).run(rig.now + 200 * MS)
    assert rig.task("hand").state is State.ON
    assert list(rig.task("hand").module.given[-1]) == [100.0, -100.0]
    assert largest_step(rig) == 0.0


def test_an_exchange_of_code_is_blended_or_refused_as_a_switch_is():  # R-X04 R-A14
    rig = driven(hand_rig(), 0.0)
    far = rig.spawn_of("first", source("first", 100.0), rank=1)
    near = rig.spawn_of("first", source("first", 1.0), rank=1)
    rig.do(command.Swap(far)).run(rig.now + 200 * MS)
    (refused,) = rig.news_of(news.Refused)
    assert (refused.command, "would step by 100 N" in refused.reason) == ("swap", True)
    assert rig.task("hand").state is State.ON
    rig.do(command.Swap(near)).run(rig.now + 200 * MS)
    assert list(rig.task("hand").module.given[-1]) == [1.0, -1.0]
    assert 0.0 < largest_step(rig) <= LIMIT * (1 + 1e-9)


def test_a_step_without_a_limit_is_told_and_passed_on():  # R-X04
    rig = driven(hand_rig("None"), 0.0)
    rig.spawn("second", source("second", 100.0), rank=1).switch(off=["first"], on=["second"]).run(rig.now + 200 * MS)
    (stepped,) = steps(rig)
    assert (stepped.step, stepped.given, stepped.limit) == (100.0, 100.0, 0.0)


def test_what_steps_by_nature_is_neither_told_nor_held_back():  # R-X04
    rig = driven(hand_rig("float('inf')"), 0.0)
    rig.spawn("second", source("second", 100.0), rank=1).switch(off=["first"], on=["second"]).run(rig.now + 200 * MS)
    assert steps(rig) == []
    assert largest_step(rig) == 100.0


def test_a_step_without_a_reconfiguration_is_the_tasks_own_affair():  # R-X04
    rig = driven(hand_rig(), 0.0, sway=3.0, after=20)  # at 100 Hz
    rig.run(rig.now + 200 * MS)
    assert steps(rig) == []
    assert largest_step(rig) == 3.0


def test_nothing_is_measured_where_nobody_knows_what_the_device_was_held_with():  # R-X04
    rig = driven(hand_rig(), 0.0)
    rig.spawn("second", source("second", 100.0), rank=1)
    rig.switch(off=["hand", "first"], on=["second", "hand"]).run(rig.now + 200 * MS)
    assert rig.task("hand").state is State.ON
    assert list(rig.task("hand").module.given[-1]) == [100.0, -100.0]
    assert largest_step(rig) == 0.0


def test_another_rate_in_the_midst_of_a_blend_takes_it_to_its_end():  # R-X04
    rig = driven(hand_rig('("dt", 50.0)'), 0.0)
    rig.spawn("second", source("second", 2.0), rank=1).switch(off=["first"], on=["second"]).run(rig.now + 10 * MS)
    rig.switch(rates=[("hand", 250.0)]).run(rig.now + 200 * MS)
    assert list(rig.task("hand").module.given[-1]) == [2.0, -2.0]
    assert largest_step(rig) <= 0.2 * (1 + 1e-9)
    assert rig.task("hand").input_guard.transfer.is_open is False


def test_a_bad_limit_is_an_error_of_init():  # R-X04
    rig = hand_rig(local=(("LIMIT", ("-1",)),))
    (failed,) = rig.news_of(news.Failed)
    assert (failed.entry, "expected a step above 0, found LIMIT = -1.0" in failed.text) == ("init", True)


def test_a_limit_may_be_a_product_of_numbers_ports_and_parameters():  # R-X04
    made = load(HAND.format(step='("dt", 2.0, "LIMIT")'), "hand.py", "hand")
    assert issubclass(made, Module)
    module = made()
    module.dt, module.LIMIT = 0.5, 4.0
    assert limit_of(module, ("dt", 2.0, "LIMIT")) == 4.0
    assert limit_of(module, math.inf) == math.inf
    assert limit_of(module, None) is None


LEVELS = st.sampled_from([0.0, 0.05, -0.3, 1.0, -2.4, 4.9, 40.0, -300.0])
SOURCES = st.tuples(LEVELS, st.sampled_from([0.0, 0.04]), st.booleans(), st.sampled_from([50.0, 250.0, 500.0]))
PAUSES = st.sampled_from([0, 2, 6, 30, 90, 400])


@settings(max_examples=examples(60), deadline=None)
@given(st.lists(st.tuples(SOURCES, st.sampled_from(["switch", "swap", "through"]), PAUSES), min_size=2, max_size=7))
def test_no_exchange_ever_gives_the_device_a_step_above_its_limit(exchanges):  # R-X04
    """Controllers and what they follow, exchanged at random: the device goes over into the new, or stays, or holds."""
    rig = hand_rig().spawn("follower", FOLLOWER, frequency=250.0, rank=2)
    rig.switch(on=["hand"])
    present = ""
    for number, ((level, sway, at_once, hz), way, pause) in enumerate(exchanges):
        name = f"source{number}"
        out = "GOAL" if way == "through" else "REF"
        text = source(name, level, out, sway, at_once)
        old = rig.task(present) if present else None
        if way == "swap" and old is not None and old.state is State.ON and "REF" in old.binding.rings:
            rig.do(command.Swap(rig.spawn_of(present, text.replace(name.title(), present.title()), frequency=hz)))
        else:
            others = [other for other in (present, "follower") if other]
            rig.spawn(name, text, frequency=hz, rank=1)
            on = ["follower", name] if out == "GOAL" else [name]
            rig.switch(off=others, on=on)
            present = name
        rig.run(rig.now + pause * MS)
        assert largest_step(rig) <= LIMIT * (1 + 1e-9)
        if rig.task("hand").state is State.ERROR:
            rig.do(command.Clear(HOME, "hand")).switch(on=["hand"])
    rig.run(rig.now + 600 * MS)
    assert largest_step(rig) <= LIMIT * (1 + 1e-9)
    for event in steps(rig):
        assert event.given <= LIMIT * (1 + 1e-9)


@settings(max_examples=examples(30), deadline=None)
@given(st.floats(0.11, 4.9), st.booleans(), st.sampled_from([50.0, 100.0, 500.0]), st.sampled_from(["REF", "GOAL"]))
def test_each_planted_jump_is_caught_with_its_number(jump, at_once, hz, out):  # R-X04
    rig = hand_rig().spawn("follower", FOLLOWER, frequency=500.0, rank=2)
    rig.spawn("first", source("first", 0.0, out), frequency=hz, rank=1)
    rig.spawn("second", source("second", jump, out, 0.0, at_once), frequency=hz, rank=1)
    rig.switch(on=["hand", "first", *["follower"] * (out == "GOAL")]).run(200 * MS)
    rig.news.clear()
    rig.switch(off=["first"], on=["second"]).run(500 * MS)
    assert [event.step for event in steps(rig)] == [pytest.approx(jump)]
    assert 2 <= steps(rig)[0].cycles <= MOST
    assert largest_step(rig) <= LIMIT * (1 + 1e-9)
