"""Places and speeds on a floor."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.planar import advanced, turn_to

speeds = st.tuples(st.floats(-2, 2), st.floats(-2, 2), st.floats(-3, 3))


@settings(max_examples=examples(50), deadline=None)
@given(st.tuples(st.floats(-5, 5), st.floats(-5, 5), st.floats(-6, 6)), speeds)
def test_a_long_step_is_as_many_short_ones(place, twist):  # R-K04
    short = np.array(place)
    for _ in range(40):
        short = advanced(short, twist, 0.025)
    assert advanced(place, twist, 1.0) == pytest.approx(short, abs=1e-9)


def test_it_goes_round_a_quarter_of_a_circle():  # R-K04
    assert advanced((1, 2, 0), (math.pi / 2, 0, math.pi / 2), 1.0) == pytest.approx((2, 3, math.pi / 2))
    assert advanced((0, 0, math.pi / 2), (1, 1, 0), 2.0) == pytest.approx((-2, 2, math.pi / 2))


@given(st.floats(-20, 20), st.floats(-20, 20))
def test_a_turn_is_the_shorter_one(turn, wanted):
    way = turn_to(turn, wanted)
    assert abs(way) <= math.pi + 1e-12
    assert math.cos(turn + way) == pytest.approx(math.cos(wanted), abs=1e-9)
    assert math.sin(turn + way) == pytest.approx(math.sin(wanted), abs=1e-9)
