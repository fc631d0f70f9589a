"""What follows no faster than it may."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.laws.signals.limited_rate import LimitedRate

DT = 0.01


@given(st.lists(st.tuples(st.floats(-9, 9), st.floats(-9, 9)), min_size=1, max_size=40))
def test_no_element_is_ever_faster_than_its_rate(course):
    limited = LimitedRate([0.0, 0.0], [1.0, 3.0])
    for wanted in course:
        before = limited.value.copy()
        speed = limited.follow(np.array(wanted), DT)
        assert (np.abs(speed) <= np.array([1.0, 3.0]) + 1e-9).all()
        assert limited.value - before == pytest.approx(speed * DT, abs=1e-12)


def test_what_stands_still_is_reached_and_not_passed():
    limited = LimitedRate([0.0], 1.0)
    for _ in range(55):
        limited.follow(np.array([0.5]), DT)
    assert limited.value == pytest.approx([0.5])
    assert limited.follow(np.array([0.5]), DT) == pytest.approx([0.0])


def test_what_is_no_number_is_not_followed():
    limited = LimitedRate([0.2, 0.2], 1.0)
    limited.follow(np.array([np.nan, np.inf]), DT)
    assert limited.value.tolist() == [0.2, 0.2]
