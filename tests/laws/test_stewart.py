import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.frames import rotation_exp, rotation_log
from onika.laws.stewart import Platform


def ring(radius, first, apart):
    angles = np.radians([first + 120 * (k // 2) + (apart if k % 2 else -apart) for k in range(6)])
    return np.column_stack((radius * np.cos(angles), radius * np.sin(angles), np.zeros(6)))


PLATFORM = Platform(ring(0.3, 0.0, 15.0), ring(0.2, 0.0, 45.0))
REST = np.eye(4)
REST[2, 3] = 0.35

small = st.floats(-0.04, 0.04)
lean = st.floats(-0.2, 0.2)


def moved(x, y, z, a, b, c):
    pose = REST.copy()
    pose[:3, 3] += x, y, z
    pose[:3, :3] = rotation_exp([a, b, c])
    return pose


@settings(max_examples=examples(60), deadline=None)
@given(where=st.tuples(small, small, small, lean, lean, lean))
def test_the_pose_of_the_lengths_of_a_pose_is_that_pose(where):  # R-K05
    pose = moved(*where)
    assert PLATFORM.pose(PLATFORM.lengths(pose), REST) == pytest.approx(pose, abs=1e-9)


def test_lengths_are_those_between_feet_and_heads():
    assert Platform(np.zeros((6, 3)), np.zeros((6, 3))).lengths(REST).tolist() == [0.35] * 6


def test_rates_are_the_slope_of_the_lengths():
    pose = moved(0.01, -0.02, 0.03, 0.1, -0.05, 0.08)
    for k, column in enumerate(PLATFORM.rates(pose).T):
        step = 1e-6 * np.eye(6)[k]
        there, back = (pose.copy(), pose.copy())
        for other, sign in ((there, 1.0), (back, -1.0)):
            other[:3, 3] += sign * step[:3]
            other[:3, :3] = rotation_exp(sign * step[3:]) @ pose[:3, :3]
        assert column == pytest.approx((PLATFORM.lengths(there) - PLATFORM.lengths(back)) / 2e-6, abs=1e-8)


def test_legs_that_no_pose_has_are_told():
    reason = PLATFORM.pose(np.array([0.1, 2.0, 0.1, 2.0, 0.1, 2.0]), REST)
    assert isinstance(reason, str) and reason.startswith("no pose near the last one")


def test_rotations_stay_rotations():
    pose = PLATFORM.pose(PLATFORM.lengths(moved(0, 0, 0, 0.2, 0.2, 0.2)), REST)
    assert np.linalg.norm(rotation_log(pose[:3, :3]) - 0.2) < 1e-9
