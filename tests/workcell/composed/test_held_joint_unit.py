"""An arm of a file that takes torques and holds by gains of its own."""

import numpy as np
import pytest

from kit.worlds.file_cells import CELL, files_of
from onika.ring.device import DeviceOrder, DriveState
from onika.workcell.cell.file_world import FileWorld

GAINS = "DRIVE torque\nHOME 0.2 0.3 0\nSPEED 3 3 0.5\nKP 2000 2000 4000\nKD 60 60 120\n"
HELD = CELL["robot/elbow.robot"].replace("HOME 0.2 0.3 0\nSPEED 3 3 0.5\n", GAINS)


@pytest.fixture
def world():
    world = FileWorld(files_of({**CELL, "robot/elbow.robot": HELD}))
    world.claim("elbow_left", 1)
    return world


def test_it_says_its_gains_and_publishes_its_joint_values_alone(world):  # R-X19
    sheet = next(sheet for sheet in world.devices() if sheet.name == "elbow_left")
    assert (sheet.identity["KP"], sheet.identity["KD"]) == ((2000.0, 2000.0, 4000.0), (60.0, 60.0, 120.0))
    assert (sheet.state, sheet.command) == (("time", "drive", "q1", "q2", "q3"), ("tau1", "tau2", "tau3"))


def test_it_holds_where_it_is_and_bears_its_weight(world):
    world.step(1_000_000_000)
    assert world.state("elbow_left")[2:] == pytest.approx([0.2, 0.3, 0.0], abs=1e-3)
    world._plant.data.joint("left.turn").qpos[0] += 0.05
    world.step(2_000_000_000)
    assert world.state("elbow_left")[2] == pytest.approx(0.2, abs=1e-3)


def test_it_follows_torques_and_holds_where_it_then_is(world):
    for _ in range(100):
        world.command("elbow_left", 1, DeviceOrder.DRIVE, [5.0, 0.0, 0.0])
        world.step(world.now_ns + world.step_ns)
    there = world.state("elbow_left")[2]
    assert there > 0.25
    world.command("elbow_left", 1, DeviceOrder.HOLD, ())
    world.step(world.now_ns + 1_000_000_000)
    assert world.state("elbow_left")[2] == pytest.approx(there, abs=0.1)
    world.command("elbow_left", 1, DeviceOrder.DRIVE, [np.nan, 0.0, 0.0])
    assert world.state("elbow_left")[1] == DriveState.TRIPPED


def test_as_many_gains_as_joints():  # R-B07, R-X19
    world = FileWorld(files_of({**CELL, "robot/elbow.robot": HELD.replace("KD 60 60 120", "KD 60 60")}))
    assert [(fault.reason.key, fault.place.line) for fault in world.faults] == [("workcell.joint_count", 9)]
