"""The box assembly as files beside the class that it was first: the same models, the same runs to the last bit."""

import numpy as np
import pytest

from kit.worlds.assembler import GRASP_M, Assembler, pose_at
from kit.worlds.box_cells import boxes_world
from onika.laws import puma560
from onika.laws.inverse import serial_inverse
from onika.ring.device import DeviceOrder
from onika.workcell.boxes import BoxesWorld
from onika.workcell.layout import LAYOUT_M

MS = 1_000_000
EQUAL = (
    *(
        "body_pos",
        "body_quat",
        "body_mass",
        "body_inertia",
        "body_parentid",
        "jnt_pos",
        "jnt_axis",
        "jnt_range",
        "qpos0",
    ),
    *("qpos0", "dof_armature", "dof_damping", "dof_invweight0", "geom_pos", "geom_quat", "geom_size", "geom_friction"),
    *("geom_solref", "geom_solimp", "geom_bodyid", "actuator_gainprm", "actuator_dynprm", "eq_data"),
)


def both(*devices):
    worlds = BoxesWorld(), boxes_world()
    for world in worlds:
        for device in devices:
            world.claim(device, 1)
    return worlds


def test_it_has_the_same_devices_and_no_fault():  # R-X19
    coded, composed = both()
    assert composed.faults == ()
    assert {sheet.name for sheet in coded.devices()} == {sheet.name for sheet in composed.devices()}
    states = {sheet.name: (sheet.state[:2], len(sheet.state), sheet.command) for sheet in coded.devices()}
    assert {sheet.name: (sheet.state[:2], len(sheet.state), sheet.command) for sheet in composed.devices()} == states
    assert set(coded.parts()) == set(composed.parts())


@pytest.mark.parametrize("devices", [("arm_left",), ("gripper_left", "scara_right"), ("scara_left", "arm_right")])
def test_it_is_the_same_model(devices):  # R-X19
    coded, composed = both(*devices)
    for name in EQUAL:
        first, other = (getattr(world._plant.model, name) for world in (coded, composed))
        assert np.array_equal(first, other), name
    assert coded.fingerprint() == composed.fingerprint()


def test_the_assembly_is_the_same_to_the_last_bit_and_lights_the_lamp():  # R-K01, R-X19
    prints = []
    for world in (BoxesWorld(), boxes_world()):
        Assembler(world).assemble()
        assert world.state("lamp")[2:].tolist() == [1.0] * 6
        prints.append(world.fingerprint())
    assert prints[0] == prints[1]


def test_held_stopped_pressed_and_exchanged_it_is_the_same_to_the_last_bit():  # law 17, R-X19
    worlds = both("arm_left", "gripper_left")
    for world in worlds:
        world.command("arm_left", 1, DeviceOrder.DRIVE, np.array([0.0, 0.0, 0.0, 20.0, 0.0, 0.0]))
        world.command("gripper_left", 1, DeviceOrder.DRIVE, [1.0])
        world.step(40 * MS)
        world.touch("panic_left", 1)
        world.step(200 * MS)
        world.claim("arm_right", 2)
        world.touch("panic_left", 0)
        world.step(300 * MS)
        world.release("arm_left", 1)
        world.claim("scara_left", 3)
        world.step(400 * MS)
        world.stop()
        world.go_on()
        world.reset()
        world.step(500 * MS)
    coded, composed = worlds
    assert coded.fingerprint() == composed.fingerprint()
    assert [event.device for event in coded.take_events()] == [event.device for event in composed.take_events()]


def test_without_forces_boxes_go_with_the_hand_as_in_the_class():  # law 18, R-X19
    worlds = both("arm_left_kin", "gripper_left")
    inverse = serial_inverse(puma560.DH, np.eye(4), puma560.TOOL, puma560.QMIN, puma560.QMAX)
    over = inverse.nearest(pose_at(*LAYOUT_M["triangle"], -0.125), np.array((0.0, -0.7, 2.9, 0.0, 1.0, 1.36)))
    at = inverse.nearest(pose_at(*LAYOUT_M["triangle"], GRASP_M), over)
    beside = inverse.nearest(pose_at(0.60, 0.10, -0.125), over)
    for world in worlds:
        for posture, signal in ((over, 1.0), (at, 1.0), (at, -1.0), (over, -1.0), (beside, -1.0), (beside, 1.0)):
            for _ in range(600):
                world.command("arm_left_kin", 1, DeviceOrder.DRIVE, posture)
                world.command("gripper_left", 1, DeviceOrder.DRIVE, [signal])
                world.step(world.now_ns + world.step_ns)
    coded, composed = worlds
    assert composed.poses() == pytest.approx(coded.poses(), abs=1e-9)
    assert composed.poses()[2, 2] == pytest.approx(-0.36 + 0.0254, abs=1e-6)
    assert composed.state("gripper_left") == pytest.approx(coded.state("gripper_left"), abs=1e-9)


def test_shaken_its_boxes_stand_where_those_of_the_class_do():  # R-X14, R-X19
    for seed in (3, 57):
        coded, composed = BoxesWorld.shaken(seed), boxes_world(seed)
        assert coded.fingerprint() == composed.fingerprint()


def test_what_is_odd_and_what_cannot_be_is_told_of_both_alike():  # law 18
    for devices in (["arm_left", "gripper_right"], ["arm_left", "scara_left"], ["arm_left", "arm_right_kin"]):
        coded, composed = both()
        assert list(map(str, coded.remarks(devices))) == list(map(str, composed.remarks(devices)))
        assert list(map(str, coded.objections(devices))) == list(map(str, composed.objections(devices)))
