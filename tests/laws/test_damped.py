import math

import numpy as np
import pytest

from kit.examples import examples
from kit.worlds.mjcf_arms import ARMS
from onika.laws import puma560
from onika.laws.arm import ArmModel
from onika.laws.damped import DampedInverse
from onika.laws.textbook import serial_arm

# shoulder, elbow, quill, roll: four joints, approach always straight down
DH = np.array([[0.425, 0.0, 0.3, 0.0], [0.375, math.pi, 0.0, 0.0], [0.0, 0.0, 0.24, 0.0], [0.0, 0.0, 0.0, 0.0]])
KIND = np.array([0.0, 0.0, 1.0, 0.0])
LOW, HIGH = np.array([-2.4, -2.4, 0.0, -4.0]), np.array([2.4, 2.4, 0.295, 4.0])
SCARA = serial_arm(DH, kind=KIND)
INVERSE = DampedInverse(SCARA, LOW, HIGH)


def test_an_arm_of_four_joints_reaches_what_its_joints_allow():  # R-K03, R-E09
    random = np.random.default_rng(3)
    for _ in range(30):
        q = random.uniform(LOW, HIGH)
        pose = SCARA.forward(q)
        solution = INVERSE.nearest(pose, np.clip(q + 0.2, LOW, HIGH))
        assert not isinstance(solution, str)
        assert np.abs(SCARA.forward(solution) - pose).max() < 1e-7
        assert ((solution >= LOW) & (solution <= HIGH)).all()


def test_an_orientation_that_its_joints_do_not_allow_is_out_of_reach():  # R-E09
    pose = SCARA.forward([0.3, 0.4, 0.1, 0.2])
    pose[:3, :3] = np.eye(3)
    reason = INVERSE.nearest(pose, np.zeros(4))
    assert isinstance(reason, str)
    assert "rad away" in reason


def test_a_place_too_far_says_how_far():
    pose = SCARA.forward([0.0, 0.0, 0.1, 0.0])
    pose[0, 3] += 0.25
    reason = INVERSE.nearest(pose, np.zeros(4))
    assert isinstance(reason, str)
    assert "is 0.25" in reason


def test_the_way_is_found_from_a_posture_that_leads_nowhere():
    arm = serial_arm(puma560.DH, tool=puma560.TOOL)
    inverse = DampedInverse(arm, puma560.QMIN, puma560.QMAX)
    pose = arm.forward([0.1814, -0.6254, 2.7006, 0.0, 1.0664, 1.7522])
    solution = inverse.nearest(pose, [0.0, 0.5, 0.0, -1.5, -1.0, -3.0])
    assert not isinstance(solution, str)
    assert np.abs(arm.forward(solution) - pose).max() < 1e-7


def test_equal_questions_have_equal_answers():
    pose, far = SCARA.forward([0.9, -1.2, 0.2, 0.5]), np.array([-2.0, 2.0, 0.0, -3.0])
    assert np.array_equal(INVERSE.nearest(pose, far), INVERSE.nearest(pose, far))


def test_a_pose_that_is_not_finite_is_refused():
    assert INVERSE.nearest(np.full((4, 4), math.nan), np.zeros(4)) == "the pose is not finite"


def test_a_joint_is_never_taken_beyond_its_limits():
    reason = INVERSE.nearest(SCARA.forward([0.3, 0.4, 0.40, 0.2]), np.zeros(4))
    assert isinstance(reason, str)
    assert "0.1050 m" in reason  # the quill ends at 0.295 m


@pytest.mark.parametrize("name", sorted(ARMS))
def test_poses_of_any_arm_are_reached_and_those_beyond_are_not(name):  # R-X19, R-E09
    arm = ARMS[name]
    constants, random = arm.constants, np.random.default_rng(11)
    names = ("SCREW", "LINK", "PARENT")
    law = ArmModel(*(constants[key] for key in names), None, constants["BASE"], constants["TOOL"])
    inverse = DampedInverse(law, constants["QMIN"], constants["QMAX"])
    for q in random.uniform(constants["QMIN"], constants["QMAX"], (examples(15), arm.n)):
        pose = arm.pose(q)
        solution = inverse.nearest(pose, constants["HOME"])
        assert not isinstance(solution, str), solution
        assert np.abs(arm.pose(solution) - pose).max() < 1e-7
        assert ((solution >= constants["QMIN"]) & (solution <= constants["QMAX"])).all()
        pose[2, 3] += 3.0
        assert isinstance(inverse.nearest(pose, constants["HOME"]), str)


def test_who_looks_nearby_alone_finds_no_posture_far_away():
    arm = ARMS["six"]
    screw, base, tool, low, high = (arm.constants[key] for key in ("SCREW", "BASE", "TOOL", "QMIN", "QMAX"))
    law = ArmModel(screw, base=base, tool=tool)
    near, anywhere = DampedInverse(law, low, high, starts=0), DampedInverse(law, low, high)
    missed = 0
    for q in np.random.default_rng(3).uniform(low, high, (10, 6)):
        assert np.allclose(near.nearest(arm.pose(q), np.clip(q + 0.02, low, high)), q, atol=1e-5)
        missed += isinstance(near.nearest(arm.pose(q), arm.constants["HOME"]), str)
        assert not isinstance(anywhere.nearest(arm.pose(q), arm.constants["HOME"]), str)
    assert missed > 0


# six parallel axes: the arm stays in a plane, and its axes are as straight as a file with four digits makes them
PLANAR_DH = np.array([[0.2, 1e-5 * (-1) ** k, 0.0, 0.0] for k in range(6)])
FLAT = serial_arm(PLANAR_DH)
FLAT_LIMITS = np.full(6, -2.0), np.full(6, 2.0)


def test_a_pose_of_four_digits_is_reached_where_the_joints_leave_no_more():  # R-E09, R-X19
    random = np.random.default_rng(2)
    anywhere, near = DampedInverse(FLAT, *FLAT_LIMITS), DampedInverse(FLAT, *FLAT_LIMITS, starts=0)
    for _ in range(examples(5)):
        q = random.uniform(-1.0, 1.0, 6)
        pose = FLAT.forward(q)
        pose[:3, 3] = np.round(pose[:3, 3], 4)
        for inverse in (anywhere, near):
            solution = inverse.nearest(pose, q)
            assert not isinstance(solution, str), solution
            assert np.abs(FLAT.forward(solution) - pose).max() < 1e-4
        assert np.abs(solution - q).max() < 0.01  # who follows does not fly to where the pose would be a hair nearer


def test_who_follows_a_way_is_told_what_ends_it():  # R-E09, R-F03
    near = DampedInverse(SCARA, LOW, HIGH, starts=0)
    down = SCARA.forward([0.3, 0.4, 0.30, 0.2])
    assert near.nearest(down, [0.3, 0.4, 0.294, 0.2]) == "the way leads out of reach: joint 3 stands at its limit"
    aside = SCARA.forward([0.3, 0.02, 0.1, 0.2])
    aside[:2, 3] *= 1.001
    assert near.nearest(aside, [0.3, 0.02, 0.1, 0.2]).startswith("the way leads out of reach: no posture beside")
