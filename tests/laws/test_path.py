import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.frames import rotation_log, rotation_of_rpy
from onika.laws.path import PEAK, StraightLine, joint_duration, quintic, ramped

angles = st.floats(-3.0, 3.0)


def test_the_quintic_starts_and_ends_at_rest():
    assert quintic(0.0, 2.0) == (0.0, 0.0)
    assert quintic(2.0, 2.0) == (1.0, 0.0)
    assert quintic(-1.0, 2.0) == (0.0, 0.0)
    assert quintic(5.0, 2.0) == (1.0, 0.0)
    assert quintic(0.0, 0.0) == (1.0, 0.0)


def test_half_way_in_half_the_time_at_peak_speed():
    value, speed = quintic(1.0, 2.0)
    assert value == pytest.approx(0.5)
    assert speed == pytest.approx(PEAK / 2.0)


@settings(max_examples=examples(50), deadline=None)
@given(st.floats(0.01, 0.99), st.floats(0.1, 10.0))
def test_the_speed_is_the_slope_of_the_value(share, duration):
    t, d = share * duration, 1e-5 * duration
    slope = (quintic(t + d, duration)[0] - quintic(t - d, duration)[0]) / (2 * d)
    assert quintic(t, duration)[1] == pytest.approx(slope, rel=1e-4, abs=1e-6)


def test_the_slowest_joint_decides_how_long_it_takes():
    assert joint_duration([0.0, 0.0], [1.0, -3.0], [1.0, 2.0]) == pytest.approx(PEAK * 1.5)
    assert joint_duration([1.0], [1.0], [1.0]) == 0.0


def _pose(x, y, z, roll, pitch, yaw):
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation_of_rpy(roll, pitch, yaw), (x, y, z)
    return pose


poses = st.builds(_pose, angles, angles, angles, angles, angles, angles)


@settings(max_examples=examples(50), deadline=None)
@given(poses, poses, st.floats(0.0, 1.0))
def test_a_line_is_straight_and_turns_evenly(start, end, share):
    line = StraightLine(start, end)
    assert np.allclose(line.at(0.0), start, atol=1e-9)
    assert np.allclose(line.at(1.0), end, atol=1e-7)
    there = line.at(share, np.empty((4, 4)))
    assert np.allclose(there[:3, 3], start[:3, 3] + share * (end[:3, 3] - start[:3, 3]))
    assert np.allclose(there[:3, :3] @ there[:3, :3].T, np.eye(3), atol=1e-12)
    if line.angle < math.pi - 1e-3:
        assert np.linalg.norm(rotation_log(start[:3, :3].T @ there[:3, :3])) == pytest.approx(
            share * line.angle, abs=1e-6
        )


def test_a_line_without_a_turn_keeps_the_orientation_to_the_last_bit():
    start, end = _pose(0, 0, 0, 0.3, 0.2, 0.1), _pose(1, 0, 0, 0.3, 0.2, 0.1)
    assert np.array_equal(StraightLine(start, end).at(0.37)[:3, :3], start[:3, :3])


def test_the_slower_of_way_and_turn_decides_the_duration():
    line = StraightLine(_pose(0, 0, 0, 0, 0, 0), _pose(0.3, 0, 0, 0, 0, 1.0))
    assert line.duration(0.3, 10.0) == pytest.approx(PEAK * 1.0)
    assert line.duration(3.0, 0.5) == pytest.approx(PEAK * 2.0)


@pytest.mark.parametrize("ramp", [0.05, 0.25, 0.5])
def test_a_ramped_motion_rises_stays_and_falls_and_is_the_sum_of_its_speeds(ramp):
    times = np.linspace(0.0, 2.0, 4001)
    places, rates = (np.array(part) for part in zip(*(ramped(t, 2.0, ramp) for t in times), strict=True))
    assert (places[0], places[-1], rates[0], rates[-1]) == (0.0, 1.0, 0.0, 0.0)
    assert rates.max() == pytest.approx(0.5 / (1.0 - ramp))
    assert np.gradient(places, times)[2:-2] == pytest.approx(rates[2:-2], abs=0.01)
    assert np.abs(np.diff(rates)).max() <= 0.5 / (1.0 - ramp) / ramp / 2.0 * 1.01 * times[1]
    assert ramped(0.0, 0.0, ramp) == (1.0, 0.0)
