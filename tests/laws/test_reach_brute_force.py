"""What pre-flight says of reach, against brute force: thousands of postures tried, the nearest ones improved."""

import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.laws.arm import ArmModel
from onika.laws.frames import nine_of_pose, pose_of_nine, rotation_of_rpy
from onika.laws.reach import postures, why_not
from onika.laws.robot import published

PUMA, SCARA = published(puma560, 0, 0, 0, 0), published(adept_one, 0, 0, 0, 0)
UNNAMED = {**PUMA, "ROBOT": "nobody"}
"""The same arm where no closed form is known."""
ARMS = pytest.mark.parametrize("constants", [PUMA, SCARA, UNNAMED], ids=["puma", "scara", "unnamed"])
TRIED, IMPROVED, STEPS = 4000, 10, 40
CLOSE = 1e-7


class BruteForce:
    """An arm whose postures are tried without knowing anything of it but where its tool goes."""

    def __init__(self, constants, rng):
        self.low, self.high = np.asarray(constants["QMIN"]), np.asarray(constants["QMAX"])
        self.arm = ArmModel(constants["SCREW"], base=constants["BASE"], tool=constants["TOOL"])
        self.tried = rng.uniform(self.low, self.high, (TRIED, len(self.low)))
        self.seen = np.array([self.arm.forward(q) for q in self.tried])

    def comes_to(self, pose):
        """Whether a posture within the limits brings the tool there."""
        away = np.linalg.norm((self.seen - pose).reshape(TRIED, 16), axis=1)
        return any(self._improved(self.tried[k], pose) for k in np.argsort(away)[:IMPROVED])

    def _improved(self, start, pose):
        q = start.copy()
        for _ in range(STEPS):
            lacks = self._lacking(q, pose)
            if np.linalg.norm(lacks) < CLOSE:
                return True
            jacobian = self.arm.jacobian(q)
            step = jacobian.T @ np.linalg.solve(jacobian @ jacobian.T + 1e-9 * np.eye(6), lacks)
            q = np.clip(q + np.clip(step, -0.3, 0.3), self.low, self.high)
        return False

    def _lacking(self, q, pose):
        here = self.arm.forward(q)
        turned = sum(np.cross(here[:3, k], pose[:3, k]) for k in range(3)) / 2.0
        return np.concatenate([pose[:3, 3] - here[:3, 3], turned])


@ARMS
def test_where_a_posture_brings_the_tool_pre_flight_lets_it_go(constants):  # law 26, R-X19
    brute = BruteForce(constants, np.random.default_rng(1))
    targets = [("cartesian object", (*nine_of_pose(pose), 1.0)) for pose in brute.seen[:150]]
    refused = [reason for reason in why_not(constants, targets) if reason is not None]
    assert refused == []


@pytest.mark.parametrize("count", [12, pytest.param(150, marks=pytest.mark.slow)])
@ARMS
def test_what_pre_flight_lets_go_a_posture_within_the_limits_does_and_what_it_refuses_none(
    constants, count
):  # law 26, R-X19
    rng = np.random.default_rng(2)
    brute = BruteForce(constants, rng)
    is_upright = len(brute.low) < 6
    counts = {True: 0, False: 0}
    confirmed = 0
    for _ in range(count):
        pose = np.eye(4)
        around = rng.uniform(-np.pi, np.pi, 3)
        pose[:3, :3] = rotation_of_rpy(np.pi, 0.0, around[2]) if is_upright else rotation_of_rpy(*around)
        pose[:3, 3] = rng.uniform([-0.9, -0.9, -0.4], [0.9, 0.9, 0.9])
        nine = nine_of_pose(pose)
        (reason,) = why_not(constants, [("cartesian object", (*nine, 1.0))])
        if reason is None:
            (q,) = postures(constants, [nine])
            assert (q >= brute.low - 1e-9).all() and (q <= brute.high + 1e-9).all()
            assert brute.arm.forward(q) == pytest.approx(pose_of_nine(nine), abs=1e-6)
            confirmed += brute.comes_to(pose)
        else:
            assert not brute.comes_to(pose), (nine, reason)
        counts[reason is None] += 1
    assert min(counts.values()) >= 2
    assert confirmed >= 0.8 * counts[True]  # brute force finds what there is, so that its no means something
