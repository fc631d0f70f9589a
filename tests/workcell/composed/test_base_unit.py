"""Bases from files as devices: on wheels, on slides, and without forces."""

import math

import numpy as np
import pytest

from kit.worlds.driving_bases import FILES
from kit.worlds.file_cells import files_of
from onika.ring.device import DeviceOrder, DriveState
from onika.workcell.cell.file_world import FileWorld

START = (1.0, 2.0, math.pi / 2)


@pytest.fixture
def world():
    return FileWorld(files_of(FILES, "floor"))


def drive(world, device, twist, seconds):
    for _ in range(round(seconds / 0.02)):
        world.command(device, 1, DeviceOrder.DRIVE, twist)
        world.step(world.now_ns + 20_000_000)
    return world.state(device)[2:].copy()


@pytest.mark.parametrize("device", ["rover_base_bay", "rover_base_bay_kin", "cross_base_bay", "cross_base_bay_kin"])
def test_it_goes_ahead_and_turns_to_the_left(world, device):  # R-K04, R-K03
    world.claim(device, 1)
    assert world.state(device)[2:5] == pytest.approx(START, abs=1e-6)
    ahead = drive(world, device, (0.5, 0.0, 0.0), 2.0)
    assert ahead == pytest.approx((1.0, 3.0, math.pi / 2, 0.5, 0.0, 0.0), abs=0.03)
    turned = drive(world, device, (0.0, 0.0, 1.0), 1.0)
    assert turned[2] == pytest.approx(math.pi / 2 + 1.0, abs=0.1)  # tyres slip where the speed jumps
    assert turned[3:] == pytest.approx((0.0, 0.0, 1.0), abs=0.02)
    assert turned[:2] == pytest.approx(ahead[:2], abs=0.03)


@pytest.mark.parametrize(("device", "left"), [("cross_base_bay", 1.0), ("rover_base_bay", 0.0)])
def test_slides_go_aside_and_wheels_do_not(world, device, left):  # R-K04
    world.claim(device, 1)
    drive(world, device, (0.0, 0.0, 0.5), 1.0)
    before = world.state(device)[2:4].copy()
    turn = float(world.state(device)[4])
    way = drive(world, device, (0.0, 0.5, 0.0), 2.0)[:2] - before
    assert way == pytest.approx(left * np.array((-math.sin(turn), math.cos(turn))), abs=0.05)


def test_it_is_no_faster_than_it_may_be(world):
    world.claim("rover_base_bay", 1)
    assert drive(world, "rover_base_bay", (9.0, 9.0, -9.0), 1.0)[3:] == pytest.approx((1.0, 0.0, -2.0), abs=0.05)


def test_holding_it_stands(world):  # R-F01
    world.claim("rover_base_bay", 1)
    drive(world, "rover_base_bay", (0.5, 0.0, 0.5), 1.0)
    world.step(world.now_ns + 1_000_000_000)
    assert world.state("rover_base_bay")[1] == DriveState.TRIPPED
    held = world.state("rover_base_bay")[2:].copy()
    assert held[3:] == pytest.approx((0.0, 0.0, 0.0), abs=1e-3)
    world.step(world.now_ns + 1_000_000_000)
    assert world.state("rover_base_bay")[2:5] == pytest.approx(held[:3], abs=1e-3)


def test_what_is_not_finite_trips_it(world):  # R-F01
    world.claim("rover_base_bay", 1)
    drive(world, "rover_base_bay", (0.0, 0.0, 0.0), 0.1)
    world.command("rover_base_bay", 1, DeviceOrder.DRIVE, [math.nan, 0.0, 0.0])
    world.step(world.now_ns + 100_000_000)
    assert world.state("rover_base_bay")[1] == DriveState.TRIPPED
    assert world.state("rover_base_bay")[2:5] == pytest.approx(START, abs=1e-3)


def test_a_panic_button_stops_it_and_a_reset_brings_it_back(world):
    world.claim("cross_base_bay", 1)
    drive(world, "cross_base_bay", (0.5, 0.0, 0.0), 1.0)
    assert [str(away.text) for away in world.displaced()] == [
        "cross_base_bay stands at x = 1.00 m, y = 2.50 m, turned by 90 degrees"
    ]
    world.touch("panic", 1.0)
    stopped = drive(world, "cross_base_bay", (0.5, 0.0, 0.0), 0.5)
    assert stopped[3:] == pytest.approx((0.0, 0.0, 0.0), abs=1e-3)
    world.reset()
    world.step(world.now_ns + 20_000_000)
    assert world.state("cross_base_bay")[2:5] == pytest.approx(START, abs=1e-3)
    assert world.displaced() == ()


def test_its_arm_bears_its_weight_while_it_drives(world):
    world.claim("cross_base_bay", 1)
    world.claim("cross_bay", 2)
    for _ in range(50):
        world.command("cross_bay", 2, DeviceOrder.DRIVE, [0.5, 0.0])
        drive(world, "cross_base_bay", (0.3, 0.3, 0.5), 0.02)
    assert world.state("cross_bay")[2] == pytest.approx(0.5, abs=0.01)
