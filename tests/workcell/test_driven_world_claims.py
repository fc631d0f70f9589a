"""Whom a device follows: claims, writers that die, strangers, and what a command has to be (laws 5, 9, 17)."""

import math

import numpy as np
import pytest

from kit.worlds.box_cells import boxes_world
from onika.ring.device import DeviceOrder
from onika.ring.drive import DriveInput, DriveMode
from onika.words.reason import Reason

MS = 1_000_000
ARM, OTHER, HAND, LAMP = "arm_left", "arm_right", "gripper_left", "lamp"
PUSH = np.array([0.0, 0.0, 0.0, 20.0, 0.0, 0.0])


@pytest.fixture
def world():
    world = boxes_world()
    world.claim(ARM, 1)
    world.claim(OTHER, 2)
    world.step(10 * MS)
    return world


def drive(world, device=ARM, epoch=1, values=PUSH):
    world.command(device, epoch, DeviceOrder.DRIVE, values)
    return world.modes()[device]


def moves(world, device=ARM):
    """Whether a joint turns in the next steps."""
    before = world.state(device)[2:8].copy()
    world.step(world.now_ns + 10 * MS)
    return bool(np.abs(world.state(device)[2:8] - before).max() > 1e-3)


def test_a_device_that_one_has_another_cannot_have(world):  # law 9
    with pytest.raises(ValueError, match=ARM) as refused:
        world.claim(ARM, 3)
    assert refused.value.args[0] == Reason.of("workcell.device_claimed", device=ARM)
    assert drive(world, epoch=3) is DriveMode.HELD
    assert drive(world) is DriveMode.DRIVEN


def test_a_command_is_followed_from_the_first_one_on(world):  # law 1
    assert drive(world) is DriveMode.DRIVEN
    assert moves(world)


def test_a_claim_that_is_given_back_is_free_and_its_drive_holds(world):  # law 18
    drive(world)
    world.release(ARM, 1)
    assert world.modes()[ARM] is DriveMode.HELD
    assert drive(world) is DriveMode.HELD
    world.claim(ARM, 3)
    assert drive(world, epoch=3) is DriveMode.DRIVEN


def test_nobody_gives_back_what_another_has(world):  # law 17
    drive(world)
    world.release(ARM, 2)
    assert drive(world) is DriveMode.DRIVEN


def test_what_a_dead_writer_drove_trips_is_free_and_hears_it_no_more(world):  # law 17
    drive(world), drive(world, OTHER, 2)
    world.take_events()
    world.fence(1)
    (event,) = world.take_events()
    assert (event.device, event.cause) == (ARM, DriveInput.FENCE.value)
    assert world.modes()[ARM] is DriveMode.TRIPPED
    assert world.modes()[OTHER] is DriveMode.DRIVEN
    assert drive(world) is DriveMode.TRIPPED
    world.claim(ARM, 3)
    world.command(ARM, 3, DeviceOrder.CLEAR, ())
    assert drive(world) is DriveMode.HELD
    assert drive(world, epoch=3) is DriveMode.DRIVEN


def test_a_writer_that_has_died_claims_nothing_any_more(world):  # law 17
    world.fence(1)
    with pytest.raises(ValueError, match="1") as refused:
        world.claim(ARM, 1)
    assert refused.value.args[0] == Reason.of("workcell.writer_died", epoch=1)


@pytest.mark.parametrize("place", range(6))
@pytest.mark.parametrize("was_driven", [False, True])
def test_one_value_that_is_no_number_trips_and_nothing_of_it_is_done(world, place, was_driven):  # law 5
    values = PUSH.copy()
    values[place] = np.nan
    if was_driven:
        drive(world)
    assert drive(world, values=values) is DriveMode.TRIPPED
    assert world.take_events()[-1].cause == DriveInput.UNSOUND.value


def test_values_count_with_a_command_to_drive_alone(world):  # law 17
    world.command(ARM, 1, DeviceOrder.HOLD, np.full(6, np.nan))
    assert world.modes()[ARM] is DriveMode.HELD
    drive(world)
    world.command(ARM, 1, DeviceOrder.CLEAR, np.full(6, np.nan))
    assert world.modes()[ARM] is DriveMode.DRIVEN


def test_what_is_no_command_is_a_fault_that_says_what_was_expected(world):
    with pytest.raises(ValueError, match=ARM) as refused:
        drive(world, values=PUSH[:5])
    assert refused.value.args[0] == Reason.of("workcell.values", count=6, device=ARM, found=5)
    world.claim(LAMP, 4)
    with pytest.raises(ValueError, match=LAMP) as refused:
        world.command(LAMP, 4, DeviceOrder.DRIVE, [1.0])
    assert refused.value.args[0] == Reason.of("workcell.no_commands", device=LAMP)


def test_a_tripped_drive_follows_nothing(world):  # law 17
    drive(world, values=np.full(6, np.nan))
    assert drive(world) is DriveMode.TRIPPED
    assert not moves(world)


def test_a_clear_of_a_driven_drive_leaves_it_what_it_follows(world):  # law 17
    drive(world)
    world.command(ARM, 1, DeviceOrder.CLEAR, np.zeros(6))
    assert moves(world)


def test_a_driven_arm_is_not_held_besides(world):  # law 17
    drive(world)
    assert [unit.sheet.name for unit in world._holding] == [OTHER]
    world.command(ARM, 1, DeviceOrder.HOLD, ())
    assert {unit.sheet.name for unit in world._holding} == {ARM, OTHER}


def test_an_arm_holds_where_it_was_when_it_was_last_driven(world, monkeypatch):  # law 17
    (unit,) = [unit for unit in world._holding if unit.sheet.name == ARM]
    captured = []
    monkeypatch.setattr(unit, "capture", lambda: captured.append(unit.drive.mode))
    world.command(ARM, 1, DeviceOrder.HOLD, ())
    drive(world), drive(world)
    world.command(ARM, 1, DeviceOrder.CLEAR, ())
    assert captured == []
    world.command(ARM, 1, DeviceOrder.HOLD, ())
    world.stop()
    assert captured == [DriveMode.HELD]


def test_leaving_a_stop_changes_nothing_for_what_was_not_stopped(world):  # law 27
    drive(world)
    world.go_on()
    assert world.modes()[ARM] is DriveMode.DRIVEN
    world.stop()
    assert set(world.modes().values()) == {DriveMode.STOPPED}
    world.go_on()
    assert {world.modes()[ARM], world.modes()[OTHER]} == {DriveMode.HELD}


@pytest.mark.parametrize("prevent", ["stop", "trip"])
def test_a_hand_that_must_not_move_takes_no_new_pressure(world, prevent):  # law 27
    world.claim(HAND, 5)
    world.step(world.now_ns + 10 * MS)
    if prevent == "stop":
        world.stop()
    else:
        world.command(HAND, 5, DeviceOrder.DRIVE, [math.inf])
    before = world._plant.data.ctrl.copy()
    world.command(HAND, 5, DeviceOrder.DRIVE, [0.5])
    assert world._plant.data.ctrl.tolist() == before.tolist()
    world.step(world.now_ns + 10 * MS)
    assert world.modes()[HAND] in (DriveMode.STOPPED, DriveMode.TRIPPED)


def test_a_lamp_has_no_drive_that_anything_happens_to(world):
    world.claim(LAMP, 4)
    world.fence(4)
    world.stop()
    assert LAMP not in {event.device for event in world.take_events()}


def test_what_happens_before_the_first_step_has_no_step_before():  # law 17
    world = boxes_world()
    world.claim(ARM, 1)
    drive(world)
    (event,) = world.take_events()
    assert (event.at_ns, event.previous_step_ns, event.last_command_ns) == (0, 0, -1)
