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


def test_several_cycles_are_counted_at_once():
    counters, one_by_one = Counters(), Counters()
    for took in (5, 9, 3, 4):
        one_by_one.add(took)
    counters.add_several(2, 14, 5, 9)
    counters.add_several(2, 7, 3, 4)
    assert (counters.cycles, counters.total_ns, counters.least_ns, counters.most_ns) == (4, 21, 3, 9)
    assert counters.mean_ns == one_by_one.mean_ns
