"""Grippers from files as devices."""

import pytest

from kit.worlds.file_cells import files_of
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
