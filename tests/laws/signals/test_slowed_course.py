"""A course that is gone through more slowly than it comes."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.signals.slowed_course import SlowedCourse

DT = 0.01


def passed_on(course, pieces, share):
    rows = []
    for piece in pieces:
        course.follow(np.array([piece]), share, DT)
        rows.append(float(course.value[0]))
    return rows


def test_all_of_its_time_is_the_course_itself():  # R-K05
    course = SlowedCourse([0.0], 1000, ease=1e9)
    pieces = np.sin(np.arange(50) / 7.0)
    assert passed_on(course, pieces, 1.0) == pytest.approx(pieces.tolist())
    assert course.behind == 1


def test_half_of_its_time_is_the_same_path_in_twice_as_long():  # R-K05
    course = SlowedCourse([0.0], 1000, ease=1e9)
    pieces = np.arange(1.0, 41.0)
    rows = passed_on(course, pieces, 0.5)
    assert rows == pytest.approx((np.arange(1, 41) * 0.5).tolist())
    assert passed_on(course, [40.0] * 100, 1.0)[-1] == 40.0


def test_none_of_its_time_is_rest_and_the_share_changes_evenly():  # R-K05
    course = SlowedCourse([0.0], 1000, ease=10.0)
    rows = passed_on(course, np.arange(1.0, 101.0), 1.0)
    assert np.diff(rows, n=2).max() <= 0.1 + 1e-9
    slowed = passed_on(course, np.arange(101.0, 201.0), 0.0)
    assert slowed[-1] == slowed[-50]
    assert np.diff([rows[-1], *slowed]).max() <= 1.0 + 1e-9


def test_where_more_than_it_may_keep_is_behind_it_goes_as_fast_as_it_comes():
    course = SlowedCourse([0.0], 10, ease=1e9)
    passed_on(course, np.arange(1.0, 200.0), 0.0)
    assert course.behind <= 12


@settings(max_examples=examples(50), deadline=None)
@given(st.lists(st.tuples(st.floats(-1, 1), st.floats(0, 1)), min_size=1, max_size=60))
def test_it_leaves_nothing_out_and_is_never_faster_than_what_comes(course_and_shares):  # R-K05
    course = SlowedCourse([0.0], 1000, ease=1e9)
    fastest = np.abs(np.diff([0.0, *(piece for piece, _ in course_and_shares)])).max() / DT
    for piece, share in course_and_shares:
        assert np.abs(course.follow(np.array([piece]), share, DT)).max() <= fastest + 1e-6
    last = course_and_shares[-1][0]
    assert passed_on(course, [last] * 80, 1.0)[-1] == pytest.approx(last)


def test_what_is_no_number_is_passed_over():
    course = SlowedCourse([1.0], 10, ease=1e9)
    assert passed_on(course, [2.0, float("nan"), 3.0], 1.0) == [2.0, 2.0, 3.0]
