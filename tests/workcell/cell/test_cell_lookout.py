import numpy as np
import pytest

from kit.worlds.file_cells import CELL, files_of
from onika.workcell.cell.file_world import FileWorld

LOW = (
    CELL["world/cell.world"].replace("AT 0.6 -0.9 0.02 0", "AT 0.4 0.6 0.4 0").replace("0.6 -0.9 0.06", "0.4 0.6 0.44")
)
"""The table stands beside the arm, as high as its shoulder, with the cube on it."""


def watched(world_text=CELL["world/cell.world"]):
    world = FileWorld(files_of({**CELL, "world/cell.world": world_text}))
    world.watch_mishaps()
    return world


def drive(world, device, goal, seconds=1.2):
    """Lead an arm to joint values, as a trajectory does."""
    start = np.array(world.state(device)[2:5])
    is_kinematic = device.endswith("_kin")
    for k in range(1, 101):
        wanted = start + (np.array(goal) - start) * k / 100
        world.command(device, 1, 1, wanted if is_kinematic else [*wanted, 0.0, 0.0, 0.0])
        world.step(world.now_ns + round(seconds * 1e7))


def said(world):
    return [str(mishap.text) for mishap in world.take_mishaps()]


@pytest.mark.parametrize("device", ["elbow_left", "elbow_left_kin"])
def test_an_arm_that_reaches_a_table_is_told_once_with_its_device(device):  # R-E16, R-X19
    world = watched(LOW)
    world.claim(device, 1)
    drive(world, device, (1.0, 0.0, 0.0))
    first, *others = world.take_mishaps()
    assert str(first.text) in (
        "elbow_left touches table",
        "the hand of elbow_left touches table",
        f"{device} touches table",
        f"the hand of {device} touches table",
    )
    assert first.devices == (device,)
    assert 0 < first.at_ns <= world.now_ns
    assert len(first.poses) == world.poses().nbytes
    assert len(others) <= 3


def test_a_motion_that_touches_nothing_is_none():  # R-E16, R-X19
    world = watched()
    world.claim("elbow_left", 1)
    drive(world, "elbow_left", (-1.0, 0.0, 0.05))
    assert said(world) == []


def test_arms_that_meet_are_told_with_both():  # R-E16, R-X19
    world = watched(CELL["world/cell.world"].replace("AT 2 0 0 180", "AT 0.8 0 0 180"))
    world.claim("elbow_left", 1)
    drive(world, "elbow_left", (0.0, 0.0, 0.0))
    assert any("meets" in sentence and "elbow_right" in sentence for sentence in said(world))


def test_a_part_that_comes_to_lie_on_the_floor_is_told():  # R-E16, R-X19
    world = watched()
    world._plant.data.joint("cube.free").qpos[:3] = -0.5, -0.9, 0.3
    world.step(500_000_000)
    assert [(str(mishap.text), mishap.devices) for mishap in world.take_mishaps()] == [("cube falls to the floor", ())]


def test_who_watches_changes_nothing():  # R-E16, law 14
    ends = []
    for is_watched in (False, True):
        world = FileWorld(files_of())
        if is_watched:
            world.watch_mishaps()
        world.claim("elbow_left", 1)
        drive(world, "elbow_left", (1.0, 0.5, 0.05))
        ends.append(world.poses().tobytes())
    assert ends[0] == ends[1]
