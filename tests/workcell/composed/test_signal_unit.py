"""Grippers that one signal opens or closes."""

import math

import pytest

from kit.worlds.file_cells import CELL, files_of
from onika.ring.device import DeviceOrder, DriveState
from onika.workcell.cell.file_world import FileWorld

SIGNAL = CELL["robot/elbow.robot"].replace("MOVES squeeze\n", "MOVES squeeze\nDRIVE signal\n")


@pytest.fixture
def world():
    world = FileWorld(files_of({**CELL, "robot/elbow.robot": SIGNAL}))
    world.claim("elbow_gripper_left", 1)
    return world


def told(world, signal):
    for _ in range(300):
        world.command("elbow_gripper_left", 1, DeviceOrder.DRIVE, [signal])
        world.step(world.now_ns + world.step_ns)
    return world.state("elbow_gripper_left")[2]


def test_one_signal_opens_and_closes_it_and_0_changes_nothing(world):  # R-X19
    assert told(world, 1.0) == pytest.approx(0.06, abs=1e-3)
    assert told(world, 0.0) == pytest.approx(0.06, abs=1e-3)
    assert told(world, -0.5) == pytest.approx(0.0, abs=1e-3)


def test_a_signal_that_is_no_number_trips_it(world):
    world.command("elbow_gripper_left", 1, DeviceOrder.DRIVE, [math.inf])
    assert world.state("elbow_gripper_left")[1] == DriveState.TRIPPED
