"""What is counted of a task."""

import pytest
from hypothesis import given, strategies as st

from onika.runtime.counters import Counters


@given(st.lists(st.integers(0, 10**9), min_size=1))
def test_the_least_the_mean_and_the_most_are_those_of_the_cycles(times):  # R-A11
    counters = Counters()
    for took in times:
        counters.add(took)
    assert (counters.cycles, counters.total_ns) == (len(times), sum(times))
    assert (counters.least_ns, counters.most_ns) == (min(times), max(times))
    assert counters.mean_ns == pytest.approx(sum(times) / len(times))


def test_without_a_cycle_all_is_zero():
    counters = Counters()
    assert (counters.least_ns, counters.mean_ns, counters.most_ns) == (0, 0.0, 0)


def test_only_the_time_in_which_the_task_was_on_is_profiled():  # R-A17
    counters = Counters()
    assert counters.profiled_ns(50) == 0
    counters.begin(100)
    assert counters.profiled_ns(150) == 50
    counters.end(200)
    counters.end(300)
    counters.begin(400)
    assert counters.profiled_ns(410) == 110


def test_counting_anew_goes_on_where_the_task_is_on():  # R-A17
    assert Counters(1000).profiled_ns(1500) == 500
