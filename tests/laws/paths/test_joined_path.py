"""A path joined to where the arm is."""

import numpy as np
import pytest

from onika.laws.paths.joined_path import JoinedPath
from onika.laws.paths.polynomial import PolynomialPath

SPEED = np.array([1.0, 1.0])
PATH = PolynomialPath(np.array([[0.5, 0.0, 0.0, 10.0, -15.0, 6.0], [0.0] * 6]), 2.0, SPEED)


def test_it_begins_where_the_arm_is_and_ends_where_the_path_ends():
    joined = JoinedPath(np.array([0.0, 0.3]), PATH, SPEED)
    assert joined.at(0.0)[0] == pytest.approx([0.0, 0.3])
    assert joined.duration == pytest.approx(1.875 * 0.5 + 2.0)
    assert joined.end == pytest.approx([1.5, 0.0])


def test_nothing_jumps_where_the_two_meet_and_no_joint_is_too_fast():
    joined = JoinedPath(np.array([0.0, 0.3]), PATH, SPEED)
    times = np.linspace(0.0, joined.duration, 2001)
    places = np.array([joined.at(t)[0] for t in times])
    speeds = np.array([joined.at(t)[1] for t in times])
    assert np.abs(np.diff(places, axis=0)).max() <= 1.001 * (times[1] - times[0])
    assert np.abs(speeds).max() <= 1.0 + 1e-9
    assert np.abs(np.diff(speeds, axis=0)).max() < 0.02


def test_an_arm_that_stands_there_already_begins_with_the_path():
    joined = JoinedPath(np.array([0.5, 0.0]), PATH, SPEED)
    assert joined.duration == pytest.approx(2.0)
    assert joined.at(1.0)[0] == pytest.approx([1.0, 0.0])
