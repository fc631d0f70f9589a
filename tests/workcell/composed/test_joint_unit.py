"""Arms from files as devices: how they follow, run on, and hold."""

import numpy as np
import pytest

from kit.worlds.file_cells import CELL, files_of
from onika.ring.device import DeviceOrder, DriveState
from onika.workcell.cell.file_world import FileWorld

HOME = np.array([0.2, 0.3, 0.0])
WAY = np.array([0.8, -0.6, 0.05])


def quintic(t):
    x = min(t, 1.0)
    return x**3 * (10 - 15 * x + 6 * x * x), 30 * x**2 - 60 * x**3 + 30 * x**4


def follow(world, device, every):
    """A motion of a second, commanded at every so many steps; the greatest error on the way."""
    worst = 0.0
    for k in range(700):
        share, speed = quintic(k * 0.002)
        if k % every == 0:
            world.command(device, 1, DeviceOrder.DRIVE, [*(HOME + WAY * share), *(WAY * speed * (k < 500))])
        worst = max(worst, float(np.abs(world.state(device)[2:5] - HOME - WAY * share).max()))
        world.step(world.now_ns + world.step_ns)
    return worst


@pytest.mark.parametrize("every", [1, 10])
def test_a_position_device_follows_at_500_and_at_50_hz(every):  # R-X19
    world = FileWorld(files_of())
    world.claim("elbow_left", 1)
    assert follow(world, "elbow_left", every) < 4e-3
    assert world.state("elbow_left")[2:5] == pytest.approx(HOME + WAY, abs=1e-4)


def test_it_bears_its_weight_and_stays_where_it_was_told_to_be():
    world = FileWorld(files_of())
    world.claim("elbow_left", 1)
    world.command("elbow_left", 1, DeviceOrder.DRIVE, [*HOME, 0.5, 0.5, 0.0])
    world.step(600_000_000)
    told = world.state("elbow_left")[2:5].copy()
    assert world.state("elbow_left")[1] == DriveState.TRIPPED
    assert 0.02 < told[0] - HOME[0] < 0.03  # it ran on for the 50 ms of silence
    world.step(1_600_000_000)
    assert world.state("elbow_left")[2:5] == pytest.approx(told, abs=1e-6)


def test_a_torque_device_falls_while_it_is_driven_and_is_a_servo_while_it_holds():  # R-X19
    world = FileWorld(files_of())
    world.claim("stiff_left", 1)
    for _ in range(50):
        world.command("stiff_left", 1, DeviceOrder.DRIVE, [0.0, 0.0, 0.0])
        world.step(world.now_ns + world.step_ns)
    fallen = world.state("stiff_left")[3]
    assert fallen > HOME[1] + 0.02
    world.command("stiff_left", 1, DeviceOrder.HOLD, [0.0, 0.0, 0.0])
    world.step(world.now_ns + 1_000_000_000)
    held = world.state("stiff_left").copy()
    world.step(world.now_ns + 1_000_000_000)
    assert world.state("stiff_left")[2:5] == pytest.approx(held[2:5], abs=1e-6)
    world.command("stiff_left", 1, DeviceOrder.DRIVE, [0.0, 0.0, 0.0])
    world.step(world.now_ns + 50 * world.step_ns)
    assert world.state("stiff_left")[3] > held[3] + 1e-4


def pushed(*commands):
    """What a torque device says after these commands, one in each step."""
    world = FileWorld(files_of())
    world.claim("stiff_left", 1)
    for values in commands:
        world.command("stiff_left", 1, DeviceOrder.DRIVE, values)
        world.step(world.now_ns + world.step_ns)
    return world.state("stiff_left").tolist()


def test_torques_come_as_memory_or_as_a_list_and_do_the_same():  # law 16
    torques = [np.array([0.1 * k, -0.2, 0.3]) for k in range(20)]
    assert pushed(*[values.data for values in torques]) == pushed(*[values.tolist() for values in torques])


def test_torques_in_memory_that_are_no_numbers_trip_it():  # R-F01
    still, spoilt = np.zeros(3).data, np.array([0.0, np.inf, -np.inf]).data
    assert pushed(still, spoilt)[1] == DriveState.TRIPPED
    assert pushed(still, np.full(3, 1e308).data)[1] == DriveState.DRIVEN  # their sum is no number, each of them is


def test_a_velocity_device_adds_up_its_speeds():  # R-X19
    robot = CELL["robot/elbow.robot"].replace("HOME", "DRIVE velocity\nHOME")
    world = FileWorld(files_of({**CELL, "robot/elbow.robot": robot}))
    world.claim("elbow_left", 1)
    for _ in range(250):
        world.command("elbow_left", 1, DeviceOrder.DRIVE, [0.4, 0.0, 0.0])
        world.step(world.now_ns + world.step_ns)
    assert world.state("elbow_left")[2] == pytest.approx(HOME[0] + 0.2, abs=2e-3)


def test_what_is_not_finite_trips_it_and_changes_nothing():  # R-F01
    world = FileWorld(files_of())
    world.claim("elbow_left", 1)
    world.command("elbow_left", 1, DeviceOrder.DRIVE, [*HOME, 0.0, 0.0, 0.0])
    world.command("elbow_left", 1, DeviceOrder.DRIVE, [np.nan] * 6)
    world.step(world.now_ns + 500_000_000)
    assert world.state("elbow_left")[1] == DriveState.TRIPPED
    assert world.state("elbow_left")[2:5] == pytest.approx(HOME, abs=1e-6)


def test_without_forces_it_is_where_it_is_told_to_be():  # R-K03
    world = FileWorld(files_of())
    world.claim("elbow_left_kin", 1)
    for k in range(100):
        world.command("elbow_left_kin", 1, DeviceOrder.DRIVE, [0.2 + 0.002 * k, 9.0, 0.0])
        world.step(world.now_ns + world.step_ns)
    assert world.state("elbow_left_kin")[2] == pytest.approx(0.2 + 0.002 * 99)
    assert world.state("elbow_left_kin")[3] == pytest.approx(0.3 + 3.0 * 0.2)
