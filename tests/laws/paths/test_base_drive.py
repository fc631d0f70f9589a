"""The way of a base to a place."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.paths.base_drive import BaseDrive
from onika.laws.planar import advanced, turn_to

DT = 0.02
places = st.tuples(st.floats(-3, 3), st.floats(-3, 3), st.floats(-7, 7))


def driven(start, target, lag=0.0, speed=(0.4, 0.6), turning=(1.2, 3.0)):
    """Every place and every twist on the way of a base that comes to its speeds with a lag (s)."""
    drive = BaseDrive(target, (0.0, 0.0, 0.0), speed, turning, (0.005, 0.01))
    place, real, seen = np.array(start, dtype=float), np.zeros(3), []
    while not drive.is_there:
        wanted = drive.twist(place, DT).copy()
        real = wanted + (real - wanted) * (math.exp(-DT / lag) if lag else 0.0)
        place = advanced(place, real, DT)
        seen.append((place, wanted))
        assert len(seen) < 6000, "it never comes there"
    return seen


@settings(max_examples=examples(40), deadline=None)
@given(places, places, st.sampled_from((0.0, 0.05, 0.1)))
def test_it_comes_to_every_place_from_every_place(start, target, lag):  # R-K04
    seen = driven(start, target, lag)
    place = seen[-1][0]
    assert math.dist(place[:2], target[:2]) < 0.02
    assert abs(turn_to(place[2], target[2])) < 0.02
    twists = np.array([twist for _, twist in seen])
    most, rise = np.array((0.4, 0.0, 1.2)), np.array((0.6, 0.0, 3.0)) * DT
    assert (np.abs(twists) <= most + 1e-9).all()
    assert (np.abs(np.diff(twists, axis=0)) <= rise + 1e-9).all()


def test_where_it_stands_already_it_only_turns():
    seen = driven((1.0, 1.0, 0.0), (1.004, 1.0, 1.0))
    assert max(abs(twist[0]) for _, twist in seen) == 0.0


def test_it_says_how_far_it_is_away():
    drive = BaseDrive((3.0, 4.0, 0.0), np.zeros(3), (1.0, 1.0), (1.0, 1.0), (0.01, 0.01))
    assert drive.away((0.0, 0.0, 0.0)) == pytest.approx(5.0)
