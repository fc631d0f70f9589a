import math

from hypothesis import given, strategies as st

from onika.record.tolerance import Tolerance


@given(st.floats(-1e6, 1e6), st.floats(0, 100), st.floats(-1e6, 1e6))
def test_a_tolerance_is_symmetric(one, room, other):
    assert Tolerance(room).covers(one, other, other) == Tolerance(room).covers(other, one, one)


def test_no_number_is_only_like_itself():
    assert Tolerance(9.0).covers(math.nan, math.nan, math.nan)
    assert not Tolerance(9.0).covers(math.nan, 1.0, 1.0)
    assert Tolerance().covers(math.inf, math.inf, math.inf)


def test_a_number_between_the_bounds_is_covered_however_far_they_are():
    assert Tolerance().covers(1.5, 0.0, math.inf)
    assert not Tolerance().covers(-1.5, 0.0, math.inf)
