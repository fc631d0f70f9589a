import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.frames import pose_of_nine
from onika.laws.inverse import serial_inverse
from onika.laws.textbook import serial_arm
from onika.workcell.box import SIGNS, SIZE_M
from onika.workcell.circuit import Circuit
from onika.workcell.kinematic_unit import KinematicUnit
from onika.workcell.kinematics import Kinematics
from onika.workcell.layout import LAYOUT_M, base, boxes, text
from onika.workcell.plant import Plant
from onika.workcell.table import TOP_M

NEAR = [0.0, -0.7, 2.9, 0.0, 1.0, 1.4]


def _world(sides=("left",)):
    plant = Plant(text(boxes(0, 0.0), sides, drawn=False))
    arms = [KinematicUnit(side, base(side)) for side in sides]
    for arm in arms:
        arm.bind(plant)
        arm.restart()
    return plant, arms, lambda: Kinematics(plant, arms, [f"gripper_{side}" for side in sides])


def _go(plant, kinematics, arm, place, signal):
    """Bring the hand to a place, then open or close it."""
    inverse = serial_inverse(puma560.DH, base(arm.side), puma560.TOOL, puma560.QMIN, puma560.QMAX)
    arm.follow(inverse.nearest(pose_of_nine([0.0, 0.0, -1.0, 0.0, 1.0, 0.0, *place]), NEAR))
    for _ in range(1500):
        kinematics.step(plant.model, plant.data)
    plant.data.ctrl[plant.signals([f"gripper_{arm.side}.valve{k}" for k in (1, 2)])] = signal
    for _ in range(200):
        kinematics.step(plant.model, plant.data)


def test_boxes_piled_by_the_hand_light_the_lamp():  # R-K03
    plant, (arm,), make = _world()
    kinematics, flags = make(), np.zeros(6)
    _go(plant, kinematics, arm, (0.5, 0.3, 0.0), 1.0)
    for level, sign in enumerate(SIGNS[1:], 1):
        _go(plant, kinematics, arm, (*LAYOUT_M[sign], TOP_M + SIZE_M[2] / 2), -1.0)
        place = (*LAYOUT_M["waves"], TOP_M + SIZE_M[2] * (level + 0.5) + 0.0008)
        _go(plant, kinematics, arm, (*place[:2], 0.0), -1.0)
        _go(plant, kinematics, arm, place, -1.0)
        kinematics.feel()
        Circuit(plant).scan(flags)
        assert flags.tolist() == [1.0] * 2 * (level - 1) + [0.0] * (8 - 2 * level), "not lit while it is in the hand"
        _go(plant, kinematics, arm, place, 1.0)
    kinematics.feel()
    Circuit(plant).scan(flags)
    assert flags.tolist() == [1.0] * 6


def test_nothing_moves_unless_it_is_moved():
    plant, (arm,), make = _world()
    kinematics = make()
    arm.capture()
    before = plant.data.qpos.copy()
    for _ in range(500):
        kinematics.step(plant.model, plant.data)
    assert np.array_equal(plant.data.qpos, before)


def test_a_world_that_is_taken_over_stands_still_and_nothing_hangs_in_the_air():  # law 18
    plant, _, make = _world()
    plant.data.qvel[:] = 1.0
    plant.data.joint("box_cross").qpos[:3] = 0.5, 0.3, 0.1
    make()
    assert not plant.data.qvel.any()
    assert plant.data.joint("box_cross").qpos[2] == pytest.approx(TOP_M + SIZE_M[2] / 2)


def test_what_a_hand_holds_it_keeps_when_the_world_is_taken_over_again():
    plant, (arm,), make = _world()
    kinematics = make()
    _go(plant, kinematics, arm, (0.5, 0.3, 0.0), 1.0)
    _go(plant, kinematics, arm, (*LAYOUT_M["triangle"], TOP_M + SIZE_M[2] / 2), -1.0)
    _go(plant, kinematics, arm, (0.6, 0.1, 0.0), -1.0)
    _go(plant, make(), arm, (0.55, 0.2, 0.1), -1.0)
    assert plant.data.joint("box_triangle").qpos[:3] == pytest.approx([0.55, 0.2, 0.1], abs=1e-6)


def test_poses_are_those_of_the_joints_after_the_step():
    plant, (arm,), make = _world()
    kinematics = make()
    arm.follow(puma560.HOME + 0.001)
    kinematics.step(plant.model, plant.data)
    tip = serial_arm(puma560.DH, tool=puma560.TOOL).forward(arm._q)[:3, 3]
    hand = plant.body("gripper_left.hand")
    reached = plant.data.xpos[hand] + plant.data.xmat[hand].reshape(3, 3) @ puma560.TOOL[:3, 3]
    assert np.allclose(reached, tip, atol=1e-12)
