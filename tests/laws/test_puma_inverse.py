import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws import puma560
from onika.laws.frames import rotation_of_rpy
from onika.laws.puma_inverse import PumaInverse
from onika.laws.textbook import serial_arm

BASE, TOOL = np.eye(4), puma560.TOOL.copy()
BASE[:3, :3], BASE[:3, 3] = rotation_of_rpy(0.1, 0.2, 3.0), (1.2, 0.1, 0.2)
TOOL[:3, :3] = rotation_of_rpy(0.3, 0.2, 0.1)
PLACES = {"plain": (np.eye(4), puma560.TOOL), "moved": (BASE, TOOL)}
ARMS = {name: serial_arm(puma560.DH, base=base, tool=tool) for name, (base, tool) in PLACES.items()}
INVERSES = {
    name: PumaInverse(puma560.DH, base, tool, puma560.QMIN, puma560.QMAX) for name, (base, tool) in PLACES.items()
}

# well inside the limits, wrist bent: no two branches meet
shares = st.lists(st.floats(0.02, 0.98), min_size=6, max_size=6)


def _within(share):
    return puma560.QMIN + np.array(share) * (puma560.QMAX - puma560.QMIN)


@settings(max_examples=examples(200), deadline=None)
@given(st.sampled_from(sorted(PLACES)), shares)
def test_joints_to_pose_to_joints_gives_the_same_joints(place, share):  # R-K01
    q = _within(share)
    pose = ARMS[place].forward(q)
    solution = INVERSES[place].nearest(pose, q)
    assert not isinstance(solution, str)
    assert np.abs(ARMS[place].forward(solution) - pose).max() < 1e-7
    if abs(math.sin(q[4])) > 1e-3 and not _folded(q):
        assert np.abs(solution - q).max() < 1e-5


@settings(max_examples=examples(100), deadline=None)
@given(shares, shares)
def test_nearest_is_the_nearest_of_all_branches_within_limits(share, near):
    pose, q_near = ARMS["plain"].forward(_within(share)), _within(near)
    solution = INVERSES["plain"].nearest(pose, q_near)
    assert not isinstance(solution, str)
    assert ((solution >= puma560.QMIN) & (solution <= puma560.QMAX)).all()
    for branch in INVERSES["plain"].branches(pose, q_near):
        if ((branch >= puma560.QMIN) & (branch <= puma560.QMAX)).all():
            assert np.sum((solution - q_near) ** 2) <= np.sum((branch - q_near) ** 2) + 1e-6


@settings(max_examples=examples(50), deadline=None)
@given(shares)
def test_all_eight_branches_reach_the_pose(share):
    q = _within(share)
    pose = ARMS["moved"].forward(q)
    branches = INVERSES["moved"].branches(pose, q)
    assert 4 <= len(branches) <= 8  # fewer than eight where axes 4 and 6 are in line
    for branch in branches:
        assert np.abs(ARMS["moved"].forward(branch) - pose).max() < 1e-6


def test_with_axes_four_and_six_in_line_joint_four_stays_where_it_was():
    q = np.array([0.2, -0.7, 2.4, 0.6, 0.0, -0.3])
    solution = INVERSES["plain"].nearest(ARMS["plain"].forward(q), q)
    assert np.allclose(solution, q, atol=1e-7)


def test_theta_offsets_are_taken_off():
    dh = puma560.DH.copy()
    dh[:, 3] = 0.1, -0.2, 0.3, 0.2, -0.1, 0.4
    q = np.array([0.2, -0.7, 2.4, 0.6, 0.8, -0.3])
    inverse = PumaInverse(dh, np.eye(4), puma560.TOOL, puma560.QMIN, puma560.QMAX)
    solution = inverse.nearest(serial_arm(dh, tool=puma560.TOOL).forward(q), q)
    assert np.allclose(solution, q, atol=1e-9)


@pytest.mark.parametrize(
    ("place", "sentence"),
    [
        ((2.0, 0.0, 0.0), "from the shoulder"),
        ((0.0, 0.05, 0.3), "from joint 1's axis"),
        ((math.nan, 0, 0), "out of reach"),
    ],
)
def test_out_of_reach_says_so(place, sentence):  # R-E09
    pose = np.eye(4)
    pose[:3, 3] = place
    reason = INVERSES["plain"].nearest(pose, puma560.HOME)
    assert isinstance(reason, str)
    assert sentence in reason


def test_beyond_limits_names_the_joint_and_its_limits():  # R-E09
    high = puma560.QMAX.copy()
    high[2] = 0.3
    inverse = PumaInverse(puma560.DH, np.eye(4), puma560.TOOL, puma560.QMIN, high)
    q = np.array([0.18, -0.63, 2.70, 0.0, 1.07, 1.75])
    reason = inverse.nearest(ARMS["plain"].forward(q), q)
    assert isinstance(reason, str)
    assert reason.startswith("joint ")
    assert "rad, beyond" in reason


def test_a_full_turn_is_added_where_limits_ask_for_it():
    low, high = puma560.QMIN.copy(), puma560.QMAX.copy()
    low[5], high[5] = math.radians(180), math.radians(500)
    inverse = PumaInverse(puma560.DH, np.eye(4), puma560.TOOL, low, high)
    q = np.array([0.18, -0.63, 2.70, 0.0, 1.07, 0.5])
    solution = inverse.nearest(ARMS["plain"].forward(q), q)
    assert not isinstance(solution, str)
    assert low[5] <= solution[5] <= high[5]


def _folded(q):
    """Whether the arm is near a posture in which two branches of elbow or shoulder meet."""
    bend = math.atan2(puma560.DH[3, 2], puma560.DH[2, 0])
    pose = ARMS["plain"].forward(q)
    wrist = pose[:3, 3] - (puma560.DH[5, 2] + 0.130) * pose[:3, 2]
    aside = math.hypot(wrist[0], wrist[1]) - puma560.DH[1, 2]
    return abs(math.sin(q[2] - bend)) < 1e-3 or aside < 1e-3
