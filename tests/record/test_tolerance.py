import math

from hypothesis import given, strategies as st

from onika.record.tolerance import EXACT, WALL, Tolerance, usual


@given(st.floats(-1e6, 1e6), st.floats(0, 100), st.floats(-1e6, 1e6))
def test_a_tolerance_is_symmetric(value, room, other):
    assert Tolerance(room).covers(value, other, other) == Tolerance(room).covers(other, value, value)


def test_no_number_is_only_like_itself():
    assert Tolerance(9.0).covers(math.nan, math.nan, math.nan)
    assert not Tolerance(9.0).covers(math.nan, 1.0, 1.0)
    assert Tolerance().covers(math.inf, math.inf, math.inf)


def test_a_number_between_the_bounds_is_covered_however_far_they_are():
    assert Tolerance().covers(1.5, 0.0, math.inf)
    assert not Tolerance().covers(-1.5, 0.0, math.inf)


def test_in_wall_time_speeds_and_forces_are_left_out_each_by_its_own_unit():  # R-X05: they never repeat
    assert WALL.leaves_out("rad", 2) == [False, False]
    assert WALL.leaves_out("rad/s", 2) == [True, True]
    assert WALL.leaves_out("m,m/s,N", 3) == [False, True, True]
    assert WALL.leaves_out("m,N", 3) == [False, False, False]
    assert EXACT.leaves_out("N m", 6) == [False] * 6


def test_what_is_not_said_is_as_usual_and_who_names_values_has_all_of_them_compared():  # R-X05
    assert usual(True, None, None, None) == EXACT
    assert usual(False, None, None, None) == WALL
    assert usual(False, None, None, 0.5) == Tolerance(WALL.value, WALL.part, 0.5, is_of_places=True)
    assert usual(False, 0.1, None, None) == Tolerance(0.1, WALL.part, WALL.seconds)
    assert usual(True, None, 0.1, None) == Tolerance(part=0.1)
