"""Motions of limited jerk."""

import numpy as np
import pytest

from onika.laws.paths.jerk_limited import JerkLimited

START, END = np.array([0.0, 1.0, 0.5]), np.array([1.0, 0.6, 0.5])
SPEED, ACCELERATION, JERK = np.array([1.0, 2.0, 1.0]), np.full(3, 3.0), np.full(3, 20.0)


def course(least=0.1):
    made = JerkLimited(START, END, SPEED, ACCELERATION, JERK, least)
    times = np.linspace(0.0, made.duration, 4001)
    return made, times, [np.array(part) for part in zip(*(made.at(t) for t in times), strict=True)]


def test_it_begins_and_ends_at_rest_at_its_places():
    made, _, (places, speeds, accelerations) = course()
    assert places[0] == pytest.approx(START)
    assert places[-1] == pytest.approx(END)
    for part in (speeds, accelerations):
        assert part[[0, -1]] == pytest.approx(np.zeros((2, 3)), abs=1e-6)
    assert made.at(99.0)[0] == pytest.approx(END)


def test_no_limit_is_passed_and_what_is_told_fits_together():
    _, times, (places, speeds, accelerations) = course()
    step = times[1]
    assert (np.abs(speeds) <= SPEED + 1e-9).all()
    assert (np.abs(accelerations) <= ACCELERATION + 1e-9).all()
    assert (np.abs(np.diff(accelerations, axis=0) / step) <= JERK * 1.01).all()
    assert np.gradient(places, times, axis=0)[2:-2] == pytest.approx(speeds[2:-2], abs=2e-3)


def test_it_takes_no_longer_than_the_limits_ask_for_or_as_long_as_it_is_told():
    full = 1.0 / 1.0 + 1.0 / 3.0 + 3.0 / 20.0  # way / speed, and what rising to it and falling adds
    assert course()[0].duration == pytest.approx(full, abs=1e-6)
    assert course(5.0)[0].duration == pytest.approx(5.0)
