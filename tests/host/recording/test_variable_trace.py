import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.host.recording.recorded_variable import places_of
from onika.host.recording.variable_trace import VariableTrace
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.words.shape import Shape

MS = 1_000_000


class Bench:
    """One variable, and its trace."""

    def __init__(self, shape="double[2]"):
        self.table = Table(Segment.create("test", 1 << 22))
        self.table.entry("X", Shape.parse(shape))
        (place,) = places_of(self.table, 0, {"X": "rad"})
        self.trace = VariableTrace("flow0", place, self.table.segment.view)

    def write(self, *numbers):
        self.table.ring("X").write(np.array(numbers, dtype=float).tobytes())

    def values(self, begin=0):
        times, values = self.trace.values(begin)
        return [(at, list(np.frombuffer(value))) for at, value in zip(times, values, strict=True)]


def test_what_was_written_between_two_looks_shares_the_time_between_them():  # R-X05
    bench = Bench()
    bench.write(0, 0)
    bench.trace.take(0, -1)
    for number in (1, 2, 3, 4):
        bench.write(number, 0)
    bench.trace.take(8 * MS, 0)
    expected = [(0, [0, 0]), (2 * MS, [1, 0]), (4 * MS, [2, 0]), (6 * MS, [3, 0]), (8 * MS, [4, 0])]
    assert bench.values() == expected


def test_what_has_not_changed_is_said_once():  # R-X05
    bench = Bench()
    for _ in range(5):
        bench.write(7, 7)
    bench.trace.take(5 * MS, 0)
    assert [value for _, value in bench.values()] == [[7, 7]]


def test_what_was_written_over_is_counted():  # R-X05
    bench = Bench()
    for number in range(88):
        bench.write(number, 0)
    bench.trace.take(40 * MS, 0)
    assert bench.trace.missed == 25
    assert [value[0] for _, value in bench.values()] == list(range(25, 88))


def test_the_value_that_was_in_force_at_the_begin_stays():  # R-X05
    bench = Bench()
    for number in range(5):
        bench.write(number, 0)
        bench.trace.take(number * 100 * MS, (number - 1) * 100 * MS)
    size = bench.trace.size
    bench.trace.forget(250 * MS)
    assert bench.values(250 * MS) == [(250 * MS, [2, 0]), (300 * MS, [3, 0]), (400 * MS, [4, 0])]
    assert bench.trace.size < size
    bench.trace.forget(10_000 * MS)
    assert bench.values(10_000 * MS) == [(10_000 * MS, [4, 0])]


def test_of_a_long_value_the_newest_is_kept_and_of_a_picture_one_a_second():  # R-X05
    bench = Bench("double[50,50]")
    assert bench.trace.take(0, -1)
    assert not bench.trace.take(500 * MS, 0)
    assert bench.trace.take(1_000 * MS, 500 * MS)
    assert bench.trace.size == 2 * 50 * 50 * 8


def test_an_entry_that_was_made_anew_is_followed():  # R-X05
    bench = Bench()
    for number in range(5):
        bench.write(number, 0)
    bench.trace.take(MS, 0)
    bench.table.ring("X").words[0] = 0
    bench.write(9, 9)
    bench.trace.take(2 * MS, MS)
    assert bench.values()[-1] == (2 * MS, [9, 9])


@given(st.lists(st.integers(0, 80), min_size=1, max_size=30))
def test_nothing_is_lost_that_lies_there_at_a_look(bursts):  # R-X05
    bench, written, number = Bench(), [], 0
    for look, burst in enumerate(bursts):
        for _ in range(burst):
            number += 1
            bench.write(number, 0)
        written += range(max(number - min(burst, 63) + 1, 1), number + 1)
        if burst:
            bench.trace.take((look + 1) * 100 * MS, look * 100 * MS)
    values = bench.values()
    assert [value[0] for _, value in values] == written
    assert sorted(at for at, _ in values) == [at for at, _ in values]
    assert bench.trace.missed == number - len(written)


@pytest.mark.parametrize("begin", [0, 3 * MS])
def test_what_was_never_written_says_nothing(begin):  # R-X05
    assert Bench().values(begin) == []
