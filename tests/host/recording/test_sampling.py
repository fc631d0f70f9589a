import struct
from itertools import pairwise

import pytest

from kit.runtime.live_edits import live_edits_with_tasks
from onika.host.recording.sampling import MOST_TRACES
from onika.wire.request import Refused
from onika.wire.samples import MOST_VARIABLES, Sample, Sampled


@pytest.fixture
def hand():
    edits = live_edits_with_tasks(("rt0", "rt1"), counter="rt1")
    edits.change(spawn=["source", "user", "counter"], on=["source", "counter"])
    return edits


def numbers(trace):
    return [value for (value,) in struct.iter_unpack("d", trace.values)]


def times_ms(trace):
    return [round((one.begin_ns + k * one.step_ns) / 1e6) for one in trace.stretches for k in range(one.count)]


def test_every_cycle_of_several_tasks_comes_at_its_own_time_and_only_once(hand):  # R-C14, R-C27
    hand.let_pass(0.1)
    first = hand.asker.ask(Sample(("s0/LEVEL", "s0/COUNT")))
    assert isinstance(first, Sampled)
    hand.let_pass(1.0)
    level, count = hand.asker.ask(Sample(("s0/LEVEL", "s0/COUNT"), (1, 1))).traces
    assert (level.type, count.type) == ("double", "double")
    assert numbers(level) == [numbers(first.traces[0])[-1] + k for k in range(1, 101)]
    assert {late - early for early, late in pairwise(times_ms(level))} == {10}
    assert {late - early for early, late in pairwise(times_ms(count))} == {20}
    (stretch,) = level.stretches
    assert (stretch.first, stretch.count) == (2, 100)
    nothing = hand.asker.ask(Sample(("s0/LEVEL",), (101,))).traces[0]
    assert (nothing.values, nothing.stretches) == (b"", ())


def test_a_variable_that_goes_keeps_what_came_and_says_why_no_more_comes(hand):  # R-C14
    hand.asker.ask(Sample(("s0/COUNT", "s0/LEVEL")))
    hand.let_pass(0.1)
    hand.change(kill=["counter"])
    count, level = hand.asker.ask(Sample(("s0/COUNT", "s0/LEVEL"))).traces
    assert count.reason.key == "host.not_sampled_there"
    assert len(numbers(count)) > 3
    assert not level.reason
    absent = hand.asker.ask(Sample(("s0/NO", "no/X"))).traces
    assert {trace.reason.key for trace in absent} == {"host.not_sampled_there"}


def test_what_nobody_asks_for_any_more_is_not_looked_at(hand, monkeypatch):
    sampling = hand.asker.program._sampling
    hand.asker.ask(Sample(("s0/LEVEL",)))
    assert sampling.due_ns(10**18) is not None
    assert hand.driver._looks
    clock = sampling._clock()
    monkeypatch.setattr(sampling, "_clock", lambda: clock + 10**10)
    sampling.serve()
    assert sampling.due_ns(10**18) is None
    assert hand.driver._looks == ()


def test_more_variables_than_can_be_shown_are_refused(hand):
    answer = hand.asker.ask(Sample(("s0/LEVEL",) * (MOST_VARIABLES + 1)))
    assert isinstance(answer, Refused)
    assert isinstance(hand.asker.ask(Sample(("s0/LEVEL",), (0, 0))), Refused)
    assert MOST_TRACES >= 2 * MOST_VARIABLES
