"""What is counted of a task."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from onika.runtime.counters import Counters


@given(st.lists(st.integers(0, 10**9), min_size=1))
def test_the_least_the_mean_and_the_most_are_those_of_the_cycles(times):  # R-A11
    counters = Counters(0)
    for took in times:
        counters.add(took)
    assert (counters.cycles, counters.total_ns) == (len(times), sum(times))
    assert (counters.least_ns, counters.most_ns) == (min(times), max(times))
    assert counters.mean_ns == pytest.approx(sum(times) / len(times))


def test_without_a_cycle_all_is_zero():
    counters = Counters(5)
    assert (counters.least_ns, counters.mean_ns, counters.most_ns) == (0, 0.0, 0)


def test_the_span_is_never_zero():
    assert Counters(5).span_s(1_000_000_005) == 1.0
    assert Counters(5).span_s(5) > 0.0
