"""A task's end of a device."""

import re

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.ring import drive
from onika.ring.device import DeviceOrder, DeviceSheet, DriveState
from onika.ring.slots import Ring
from onika.runtime.device import SILENCE_NS, Device
from onika.runtime.modules.binding import attach
from onika.testing.bench_device import SEGMENT, BenchDevice


@pytest.fixture
def far():
    return BenchDevice(("x", "v"), ("force", "brake"), {"KIND": "mass"})


@pytest.fixture
def near(far):
    return attach(far.grant(), {SEGMENT: far.view})


def test_the_newest_values_are_read_without_time_and_drive(far, near):  # law 16
    far.state[:] = 1.0, 2.0
    far.publish(0)
    assert near.read().tolist() == [1.0, 2.0]
    far.state[:] = 3.0, 4.0
    assert near.read().tolist() == [1.0, 2.0]
    far.publish(1)
    assert near.read().tolist() == [3.0, 4.0]


def test_what_is_read_cannot_be_written(near):
    with pytest.raises(ValueError, match="read-only"):
        near.read()[0] = 1.0


def test_a_device_says_who_it_is(near):
    assert near.identity == {"KIND": "mass"}


@given(st.lists(st.floats(-1e9, 1e9), min_size=2, max_size=2))
def test_a_command_arrives_as_it_was_written(values):  # law 16
    far = BenchDevice(("x",), ("force", "brake"))
    attach(far.grant(), {SEGMENT: far.view}).write(values)
    assert (far.order, far.commands.tolist()) == (DeviceOrder.DRIVE, values)


@pytest.mark.parametrize("bad", [float("nan"), float("inf"), float("-inf")])
@pytest.mark.parametrize("place", [0, 1])
def test_nan_and_infinity_never_reach_an_actuator_and_the_drive_holds(far, near, bad, place):  # law 5
    near.write([1.0, 1.0])
    values = [0.5, 0.5]
    values[place] = bad
    with pytest.raises(ValueError, match=re.escape(f"expected finite commands for bench, found {values}")):
        near.write(values)
    assert (far.order, far.commands.tolist()) == (DeviceOrder.HOLD, [0.0, 0.0])


def test_infinities_that_would_cancel_are_found_too(far, near):  # law 5
    with pytest.raises(ValueError, match="finite"):
        near.write([float("inf"), float("-inf")])
    assert far.order == DeviceOrder.HOLD


def test_a_command_of_another_length_is_refused(near):
    with pytest.raises(ValueError, match=r"broadcast|shape"):
        near.write([1.0, 2.0, 3.0])


def test_while_inputs_are_not_fresh_every_command_is_a_hold(far, near):  # law 4
    near.holding(True)
    near.write([1.0, float("nan")])
    assert (far.order, far.commands.tolist()) == (DeviceOrder.HOLD, [0.0, 0.0])
    near.holding(False)
    near.write([1.0, 2.0])
    assert far.order == DeviceOrder.DRIVE


def test_what_was_commanded_is_over_when_the_task_waits_for_fresh_inputs_again(far, near):  # law 4
    near.write([1.0, 2.0])
    near.holding(True)
    near.write([3.0, 4.0])
    assert (far.order, far.commands.tolist()) == (DeviceOrder.HOLD, [0.0, 0.0])


def test_every_command_says_whose_it_is(far, near):  # law 17
    near.write([1.0, 2.0])
    assert far.epoch == far.grant().epoch
    near.hold()
    assert far.epoch == far.grant().epoch


def test_the_drive_is_seen_as_of_the_last_read(far, near):  # law 17
    seen = []
    for state in (DriveState.DRIVEN, DriveState.HELD, DriveState.TRIPPED, DriveState.PRESSED):
        far.values[1] = state
        far.publish(0)
        near.read()
        seen.append((near.is_held, near.is_tripped, near.is_pressed))
    assert seen == [(False, False, False), (True, False, False), (True, True, False), (True, False, True)]


def tripped(far, near):
    far.values[1] = DriveState.TRIPPED
    far.publish(0)
    near.read()


def test_a_clear_stays_the_newest_command_until_the_device_has_heard_it(far, near):  # law 17
    """Only the newest command arrives: a hold or a drive right after would undo the clear."""
    tripped(far, near)
    near.clear()
    for later in (near.hold, lambda: near.write([1.0, 1.0])):
        later()
        assert far.order == DeviceOrder.CLEAR
        assert not near.is_tripped
    far.values[1] = DriveState.HELD
    far.publish(1)
    far.publish(2)
    near.hold()
    assert far.order == DeviceOrder.HOLD
    near.write([1.0, 1.0])
    assert far.order == DeviceOrder.DRIVE


@pytest.mark.parametrize("published", [1, 2, 3, 4, 5])
def test_a_clear_waits_for_two_publications_however_many_there_were(far, near, published):  # law 17
    for _ in range(published):
        tripped(far, near)
    near.clear()
    seen = []
    for _ in range(3):
        seen.append(near.is_tripped)
        tripped(far, near)
    assert seen == [False, False, True]


def test_a_drive_whose_button_is_pressed_is_not_cleared(far, near):  # law 17
    far.values[1] = DriveState.PRESSED
    far.publish(0)
    near.clear()
    assert far.order == DeviceOrder.HOLD


@pytest.mark.parametrize("commands", [("force",), ("force", "brake", "lamp")])
def test_a_command_has_as_many_numbers_as_the_device_takes(commands):  # law 16
    far = BenchDevice(("x",), commands)
    near = attach(far.grant(), {SEGMENT: far.view})
    near.write([float(number) for number in range(len(commands))])
    assert far.commands.tolist() == [float(number) for number in range(len(commands))]
    with pytest.raises(ValueError, match=r"broadcast|shape"):
        near.write([1.0] * (len(commands) + 1))


def test_a_device_that_does_not_come_back_is_tripped_again(far, near):  # law 17
    tripped(far, near)
    near.clear()
    far.publish(1)
    near.read()
    assert not near.is_tripped
    far.publish(2)
    near.read()
    assert near.is_tripped


def test_a_clear_looks_at_the_drive_itself_not_at_what_was_read_before(far, near):  # law 17
    near.read()
    far.values[1] = DriveState.TRIPPED
    far.publish(0)
    near.clear()
    assert far.order == DeviceOrder.CLEAR


def test_nobody_clears_a_tripped_drive_by_holding(far, near):  # law 17
    tripped(far, near)
    near.hold()
    assert far.order == DeviceOrder.HOLD


def test_a_clear_of_a_drive_that_has_not_tripped_holds(far, near):
    near.write([1.0, 1.0])
    near.clear()
    assert far.order == DeviceOrder.HOLD


def test_a_device_that_only_publishes_takes_no_commands(far):  # law 16
    mute = BenchDevice(("x",))
    near = attach(mute.grant(), {SEGMENT: mute.view})
    with pytest.raises(ValueError, match="bench takes no commands from this task"):
        near.write([])
    near.hold()
    near.clear()


def test_silence_is_counted_from_the_last_thing_that_was_new(far, near):  # law 17
    near.listen_from(0)
    far.publish(0)
    assert near.silent_ns(10) == 0
    assert near.silent_ns(25) == 15
    far.publish(30)
    assert near.silent_ns(30) == 0


def test_a_device_that_has_published_nothing_yet_is_silent_from_the_first_look_on(near):  # law 17
    assert [near.silent_ns(now) for now in (100, 130)] == [0, 30]


def test_a_device_is_taken_for_dead_after_its_drive_holds():  # law 17
    assert SILENCE_NS == 60_000_000 > drive.SILENCE_NS


def test_silence_before_the_task_came_on_does_not_count(far, near):
    far.publish(0)
    near.silent_ns(0)
    near.listen_from(500)
    assert near.silent_ns(510) == 10


@pytest.mark.parametrize("use", ["read", "write", "identity", "is_held", "hold", "clear"])
def test_a_task_without_a_device_is_told_so_at_every_use(use):
    with pytest.raises(AttributeError, match="this task has no device: its LOCAL block names none"):
        getattr(Device.absent(), use)


def test_what_stands_for_no_device_can_be_looked_at():
    assert Device.absent().__class__ is type(Device.absent())


def test_a_camera_gives_its_newest_picture_and_no_other_device_has_any():  # R-F05
    sheet = DeviceSheet("eye", ("time", "drive", "number", "age"), (), {}, (2, 3))
    view = memoryview(bytearray(Ring.footprint(32) + Ring.footprint(18)))
    state, pictures = Ring(view, 0, 32), Ring(view, Ring.footprint(32), 18)
    camera = Device(sheet, 1, state, None, pictures)
    assert camera.picture().tolist() == np.zeros((2, 3, 3)).tolist()
    pictures.write(bytes(range(18)))
    assert camera.picture().tolist() == np.arange(18).reshape(2, 3, 3).tolist()
    with pytest.raises(ValueError, match="eye is no camera: it takes no pictures"):
        Device(sheet, 1, state, None).picture()
