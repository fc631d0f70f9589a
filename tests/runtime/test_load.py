"""What tasks cost, and whether one more is too much."""

import pytest
from hypothesis import given, strategies as st

from onika.runtime.load import MARGIN, TaskLoad, predict, use_of


def load(task, mean_us, hz, is_on=True):
    return TaskLoad("s", task, is_on, hz, mean_us, 2 * mean_us, 100)


def test_a_use_is_the_cycles_time_times_the_rate():  # R-X13
    assert load("a", 500.0, 400.0).use == pytest.approx(0.2)


def test_a_unit_is_used_by_what_is_on():  # R-X13
    assert use_of([load("a", 500.0, 400.0), load("b", 1000.0, 100.0, is_on=False)]) == pytest.approx(0.2)
    assert use_of([]) == 0.0


@pytest.mark.parametrize(
    ("mean_us", "use", "sentence"),
    [
        (200.0, 0.4, ""),
        (450.0, 0.9, ""),
        (460.0, 0.92, "above the margin of 0.9"),
        (700.0, 1.4, "more than all its time; cycles would be missed"),
    ],
)
def test_what_one_more_task_would_do_is_foretold_with_the_number(mean_us, use, sentence):  # R-X13
    foretold = predict("rt0", [], load("c", mean_us, 2000.0))
    assert foretold.use == pytest.approx(use)
    assert sentence in str(foretold.warning)
    assert bool(foretold.warning) == (use > MARGIN)
    if sentence:
        assert f"task c ({mean_us:g} us a cycle at 2000 Hz)" in str(foretold.warning)
        assert f"{use:.2f}" in str(foretold.warning)


def test_a_task_that_is_measured_already_is_not_counted_twice():  # R-X13
    there = [load("a", 100.0, 1000.0), load("c", 500.0, 1000.0)]
    assert predict("rt0", there, load("c", 200.0, 1000.0)).use == pytest.approx(0.3)


LOADS = st.lists(st.builds(load, st.sampled_from("abcd"), st.floats(0, 1e4), st.floats(0, 1e4), st.booleans()))


@given(LOADS, st.floats(0, 1e4), st.floats(1, 1e4))
def test_more_never_makes_less(loads, mean_us, hz):  # R-X13
    more = load("e", mean_us, hz)
    foretold = predict("rt0", loads, more)
    assert foretold.use >= use_of(loads)
    assert bool(foretold.warning) == (foretold.use > MARGIN)
