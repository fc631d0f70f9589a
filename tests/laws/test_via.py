import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.via import Via

LIMIT = np.array([1.0, 2.0, 0.5])
places = st.tuples(*(st.floats(-3.0, 3.0) for _ in range(3)))
times = st.floats(0.1, 5.0)


def sampled(path, count=400):
    looks = np.linspace(0.0, path.duration, count)
    points = [path.at(t) for t in looks]
    return looks, np.array([q for q, _ in points]), np.array([speed for _, speed in points])


@settings(max_examples=examples(60), deadline=None)
@given(places, places, places, times, times)
def test_it_goes_through_its_points_within_their_range_and_the_speed_limits(start, via, end, first, second):
    path = Via(start, via, end, (first, second), LIMIT)
    assert path.duration >= first + second
    for t, place in ((0.0, start), (path.stretch * first, via), (path.duration, end), (path.duration + 1.0, end)):
        assert path.at(t)[0] == pytest.approx(place, abs=1e-9)
    _, places_, speeds = sampled(path)
    points = np.array([start, via, end])
    assert (places_ >= points.min(axis=0) - 1e-9).all()
    assert (places_ <= points.max(axis=0) + 1e-9).all()
    assert (np.abs(speeds) <= 1.003 * LIMIT).all()
    assert path.at(0.0)[1] == pytest.approx(np.zeros(3))
    assert path.at(path.duration)[1] == pytest.approx(np.zeros(3), abs=1e-9)


@settings(max_examples=examples(40), deadline=None)
@given(places, places, places, times, times)
def test_its_speed_is_its_derivative_over_the_point_on_the_way_too(start, via, end, first, second):
    path = Via(start, via, end, (first, second), LIMIT)
    h = 1e-5
    for t in (0.3 * path.duration, path.stretch * first, 0.8 * path.duration):
        if h < t < path.duration - h:
            slope = (path.at(t + h)[0] - path.at(t - h)[0]) / (2.0 * h)
            assert slope == pytest.approx(path.at(t)[1], abs=1e-3)


def test_a_joint_that_goes_on_does_not_stop_on_the_way_and_one_that_turns_round_does():
    path = Via([0.0, 0.0], [1.0, 1.0], [2.0, 0.0], (1.0, 2.0), [9.0, 9.0])
    assert path.at(1.0)[1] == pytest.approx([2 * 1.0 * 0.5 / 1.5, 0.0])


def test_where_a_joint_would_be_too_fast_both_segments_take_longer_alike():
    path = Via([0.0], [1.0], [2.0], (0.5, 0.5), [1.0])
    assert path.stretch > 1.5
    assert path.duration == pytest.approx(path.stretch * 1.0)
    assert path.at(path.stretch * 0.5)[0] == pytest.approx([1.0])


def test_who_is_there_already_stays():
    path = Via([1.0], [1.0], [1.0], (0.1, 0.1), [1.0])
    _, positions, speeds = sampled(path, 20)
    assert (positions == 1.0).all()
    assert (speeds == 0.0).all()
