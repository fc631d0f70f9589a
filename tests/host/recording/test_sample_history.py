import struct
from itertools import pairwise

from hypothesis import given, strategies as st

from onika.host.recording.sample_history import MOST_BYTES, MOST_SENT, SampleHistory
from onika.ring.slots import Ring
from onika.wire.samples import KEPT_NS

MS = 1_000_000


def ring():
    return Ring(memoryview(bytearray(Ring.footprint(8))), 0, 8)


def numbers(values):
    return [value for (value,) in struct.iter_unpack("d", values)]


def put(ring, *values):
    for value in values:
        ring.write(struct.pack("d", value))


def times(stretches):
    return [one.begin_ns + k * one.step_ns for one in stretches for k in range(one.count)]


@given(st.lists(st.integers(0, 100), max_size=30), st.integers(1, 3))
def test_every_value_is_kept_with_its_number_or_its_number_is_missing(bursts, asked_every):  # R-C14
    entry = ring()
    trace = SampleHistory(entry)
    written, came, after, now = 0, {}, 0, 0
    for turn, burst in enumerate(bursts):
        for _ in range(burst):
            written += 1
            put(entry, written)
        trace.take(entry, now + 8 * MS, now, 2 * MS)
        now += 8 * MS
        if turn % asked_every == 0:
            stretches, values = trace.since(after)
            names = [one.first + k for one in stretches for k in range(one.count)]
            came.update(zip(names, numbers(values), strict=True))
            after = max([after, *names])
    stretches, values = trace.since(after)
    came.update(zip((one.first + k for one in stretches for k in range(one.count)), numbers(values), strict=True))
    assert all(number == value for number, value in came.items())
    if max(bursts, default=0) <= 63:
        assert sorted(came) == list(range(1, written + 1))


def test_values_of_a_task_come_as_evenly_as_its_period_though_looks_are_not():  # R-C14
    entry = ring()
    trace = SampleHistory(entry)
    before, written = 0, 0
    for now in (5, 11, 15, 26, 30, 37, 41, 50):
        while written * 2 < now:
            written += 1
            put(entry, written)
        trace.take(entry, now * MS, before * MS, 2 * MS)
        before = now
    stretches, values = trace.since(0)
    moments = times(stretches)
    assert numbers(values) == list(range(1, 26))
    assert all(late - early <= 2 * MS for early, late in pairwise(moments))
    steady = moments[8:]
    assert {late - early for early, late in pairwise(steady)} == {2 * MS}


def test_of_values_that_were_written_over_the_numbers_are_missing():  # R-C14
    entry = ring()
    trace = SampleHistory(entry)
    put(entry, *range(88))
    trace.take(entry, 10 * MS, 0, 0)
    stretches, values = trace.since(0)
    assert [(one.first, one.count) for one in stretches] == [(26, 63)]
    assert numbers(values) == list(range(25, 88))


def test_what_is_kept_is_bounded_in_time_and_in_bytes():  # R-C14
    entry = ring()
    trace = SampleHistory(entry)
    for turn in range(2000):
        put(entry, *range(15))
        trace.take(entry, turn * 8 * MS, (turn - 1) * 8 * MS, 0)
    held, after = 0, 0
    while (answer := trace.since(after))[1]:
        held += len(answer[1])
        after = answer[0][-1].first + answer[0][-1].count - 1
        assert len(answer[1]) < MOST_SENT + 15 * 8
    assert held * 8 <= MOST_BYTES  # a slot takes 64 bytes
    assert after == 30_000
    put(entry, 1.0)
    trace.take(entry, 100 * KEPT_NS, 99 * KEPT_NS, 0)
    assert numbers(trace.since(0)[1]) == [*range(15), 1.0]  # those before it stood in force


def test_of_an_entry_made_anew_values_go_on_under_later_numbers():
    entry = ring()
    trace = SampleHistory(entry)
    put(entry, 1, 2, 3)
    trace.take(entry, MS, 0, 0)
    anew = ring()
    put(anew, 7)
    trace.take(anew, 2 * MS, MS, 0)
    assert numbers(trace.since(3)[1]) == [7]
    assert numbers(trace.since(4)[1]) == []
    assert numbers(trace.since(99)[1]) == [1, 2, 3, 7]  # they were counted by another history
