"""What is in the way of an arm that begins to hold."""

import pytest

from kit.worlds.file_cells import CELL, changed, files_of
from onika.ring.device import DeviceOrder
from onika.workcell.cell.file_world import FileWorld

BESIDE = (
    CELL["world/cell.world"].replace("AT 0.6 -0.9 0.02 0", "AT 0.4 0.6 0.4 0").replace("0.6 -0.9 0.06", "0.4 0.6 0.44")
)
"""The table stands beside the arm, as high as its shoulder."""


def held(world, device, goal):
    """What is told of an arm that was driven for a second, and then held."""
    world.claim(device, 1)
    for k in range(1, 101):
        part = k / 100
        wanted = [0.2 + part * (goal[0] - 0.2), 0.3 + part * (goal[1] - 0.3), 0.0]
        world.command(
            device, 1, int(DeviceOrder.DRIVE), wanted if device.endswith("_kin") else [*wanted, 0.0, 0.0, 0.0]
        )
        world.step(world.now_ns + 10_000_000)
    world.take_events()
    world.command(device, 1, int(DeviceOrder.HOLD), [])
    (event,) = [event for event in world.take_events() if event.device == device]
    return str(event.stands), [str(reason) for reason in event.touches]


@pytest.mark.parametrize("device", ["elbow_left", "elbow_left_kin"])
def test_an_arm_that_presses_against_a_table_says_so_and_where_it_is(device):  # R-X19
    stands, touches = held(FileWorld(files_of({**CELL, "world/cell.world": BESIDE})), device, (1.2, 0.0))
    assert stands.startswith(f"{device} stands at x = ")
    assert any("touches table" in sentence for sentence in touches)


def test_an_arm_in_the_air_touches_nothing():  # R-X19
    stands, touches = held(FileWorld(files_of()), "elbow_left", (-1.0, 0.0))
    assert "stands at" in stands and touches == []


@pytest.mark.parametrize(("device", "told"), [("elbow_left", ["elbow_left meets itself"]), ("elbow_left_kin", [])])
def test_an_arm_that_presses_against_itself_says_so_where_there_are_forces(device, told):  # R-X19, R-X06
    post = '<geom type="box" size="0.02 0.1 0.05" pos="0.36 0 0.22"/><body name="lower"'
    world = FileWorld(changed("robot/elbow.xml", '<body name="lower"', post))
    assert held(world, device, (0.2, -1.4))[1] == told


def test_an_arm_that_presses_against_its_own_foot_meets_itself():  # R-X19, R-X06
    post = '<geom type="box" size="0.03 0.03 0.4" pos="0.15 0.25 0.4"/><body name="upper"'
    world = FileWorld(changed("robot/elbow.xml", '<body name="upper"', post))
    assert held(world, "elbow_left", (1.4, 0.0))[1] == ["elbow_left meets itself"]
