"""Grippers from files as devices."""

import pytest

from kit.worlds.file_cells import files_of
from kit.worlds.robot_models import HOIST
from onika.ring.device import DeviceOrder
from onika.workcell.cell.file_world import FileWorld


def squeeze(world, opening, force, steps=300):
    for _ in range(steps):
        world.command("elbow_gripper_left", 1, DeviceOrder.DRIVE, [opening, force])
        world.step(world.now_ns + world.step_ns)
    return world.state("elbow_gripper_left")


@pytest.fixture
def world():
    world = FileWorld(files_of())
    world.claim("elbow_gripper_left", 1)
    return world


def test_it_opens_as_far_as_it_is_told(world):  # R-X19
    assert squeeze(world, 0.05, 10.0)[2] == pytest.approx(0.05, abs=1e-3)
    assert squeeze(world, 9.0, 10.0)[2] == pytest.approx(0.06, abs=1e-3)
    assert squeeze(world, 0.0, 0.0)[2] == pytest.approx(0.0, abs=1e-3)


def test_it_presses_as_hard_as_it_is_told(world):
    squeeze(world, 0.06, 0.0)
    world._plant.model.jnt_range[world._plant.model.joint("left.finger1").id] = 0.025, 0.03  # something is between
    assert squeeze(world, 0.0, 2.0)[4] == pytest.approx(2.0, abs=0.1)


def test_holding_it_keeps_its_last_command(world):
    squeeze(world, 0.05, 10.0)
    world.release("elbow_gripper_left", 1)
    world.step(world.now_ns + 1_000_000_000)
    assert world.state("elbow_gripper_left")[2] == pytest.approx(0.05, abs=1e-3)


HELD = """VERSION 2.0
CONTACT elliptic 100
FLOOR 0
PART crate
FILE crate.xml
AT 0 0 0 0
FREE
PLACE left
ROBOTS hoist
EOF
"""
CRATE = """<mujoco><worldbody><body name="crate" pos="0 0 0.02">
<geom type="box" size="0.02 0.03 0.02" mass="0.3"/></body></worldbody></mujoco>"""
ROBOT = """VERSION 2.0
FILE hoist.urdf
ARM arm
TOOL quill 0 0 -0.13
SPEED 0.5
GRIPPER gripper
MOVES finger_left
OPEN 30 0.08
CLOSED -30 0
EOF
"""


@pytest.fixture
def hoist():
    files = {"world/cell.world": HELD, "world/crate.xml": CRATE, "robot/hoist.robot": ROBOT, "robot/hoist.urdf": HOIST}
    world = FileWorld(files_of(files))
    world.claim("hoist_left", 1)
    world.claim("gripper_left", 2)

    def led(height, opening, seconds):
        """How far the gripper is open, and where the crate is, when slide and fingers were led there."""
        start, steps = world.state("hoist_left")[2], round(seconds / 0.002)
        for k in range(1, steps + 1):
            wanted = start + (height - start) * min(2.0 * k / steps, 1.0)
            world.command("hoist_left", 1, DeviceOrder.DRIVE, [wanted, 0.0])
            world.command("gripper_left", 2, DeviceOrder.DRIVE, [opening, 20.0])
            world.step(world.now_ns + world.step_ns)
        return world.state("gripper_left")[2], float(world._plant.data.body("crate.crate").xpos[2])

    return led


def test_fingers_that_motors_move_open_as_far_as_they_are_told(hoist):  # R-X19
    for opening in (0.02, 0.06, 0.08, 0.035, 0.0):
        assert hoist(0.0, opening, 1.0)[0] == pytest.approx(opening, abs=1e-3)


def test_fingers_that_motors_move_hold_what_they_lift(hoist):  # R-X19
    hoist(-0.225, 0.07, 2.0)
    opening, _ = hoist(-0.225, 0.0, 1.0)
    assert opening == pytest.approx(0.04, abs=0.003)
    _, lifted = hoist(-0.025, 0.0, 2.0)
    assert lifted == pytest.approx(0.22, abs=2e-3)
    assert hoist(-0.025, 0.0, 5.0)[1] == pytest.approx(lifted, abs=3e-4)
