import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.frames import nine_of_pose
from onika.laws.textbook import serial_arm


def test_the_dissertations_joint_target_has_the_dissertations_approach_and_normal():  # R-K01, reading 44
    arm = serial_arm(puma560.DH, tool=puma560.TOOL)
    nine = nine_of_pose(arm.forward([0.0114, -0.226, 2.35, -0.0371, 1.06, 1.61]))
    assert np.allclose(nine[:3], (-0.0417, -0.0328, -0.999), atol=5e-4)
    assert np.allclose(nine[3:6], (0.00829, 0.999, -0.0332), atol=5e-4)


def test_above_the_triangle_is_above_the_triangle():
    arm = serial_arm(puma560.DH, tool=puma560.TOOL)
    nine = nine_of_pose(arm.forward([0.1814, -0.6254, 2.7006, 0.0, 1.0664, 1.7522]))
    assert np.allclose(nine, (0, 0, -1, 0, 1, 0, 0.70, 0.28, -0.125), atol=2e-4)


def test_every_link_is_a_possible_rigid_body():
    for mass, _, _, _, x, two, three, armature, viscous in puma560.DYN:
        assert min(mass, x, two, three, armature, viscous) > 0.0
        assert x + two > three
        assert two + three > x
        assert three + x > two


def test_every_constant_has_a_row_for_each_joint():
    for name in ("DH", "DYN", "QMIN", "QMAX", "QDMAX", "TAUMAX", "KP", "KD", "HOME"):
        assert len(getattr(puma560, name)) == puma560.NDOF
    assert (puma560.QMIN < puma560.HOME).all()
    assert (puma560.HOME < puma560.QMAX).all()


def test_the_motors_are_strong_enough_to_hold_the_arm_anywhere():
    arm = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD)
    random = np.random.default_rng(2)
    for _ in range(200):
        torque = arm.bias(random.uniform(puma560.QMIN, puma560.QMAX), np.zeros(6))
        assert (np.abs(torque) < 0.6 * puma560.TAUMAX).all()


def test_the_constants_cannot_be_written():
    with pytest.raises(ValueError, match="read-only"):
        puma560.KP[0] = 1.0
