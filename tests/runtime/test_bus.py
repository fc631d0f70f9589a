"""The device bus, between shared memory and a world."""

import itertools

import numpy as np
import pytest

from kit.mass_world import MassWorld
from onika.ring.device import DeviceOrder, DriveState
from onika.ring.segment import Segment
from onika.ring.slots import Ring
from onika.runtime.bus import SEGMENT_SIZE, Bus
from onika.runtime.modules.binding import attach
from onika.workcell.boxes import BoxesWorld

MS = 1_000_000


@pytest.fixture
def segment():
    segment = Segment.create("test", SEGMENT_SIZE)
    yield segment
    segment.close()


@pytest.fixture
def bus(segment):
    bus = Bus("masses", MassWorld(), segment)
    bus.step(0)
    return bus


def device(bus, segment, name="m0", epoch=1):
    return attach(bus.grant(name, epoch), {"bus:masses": segment.view})


def test_a_grant_says_where_a_device_lies_and_who_it_is(bus):  # law 16
    grant = bus.grant("m1", 4)
    assert (grant.segment, grant.name, grant.epoch) == ("bus:masses", "m1", 4)
    assert grant.state == ("time", "drive", "x", "v")
    assert grant.command == ("force",)
    assert grant.identity == {"KIND": "mass"}


def test_a_device_that_takes_commands_is_granted_once(bus):  # law 9
    bus.grant("m0", 1)
    with pytest.raises(ValueError, match="'m0' claimed already"):
        bus.grant("m0", 2)
    bus.release("m0", 1)
    assert bus.grant("m0", 3).epoch == 3


def test_a_device_that_only_publishes_is_shared(bus, segment):  # law 16
    first, other = device(bus, segment, "scale", 1), device(bus, segment, "scale", 2)
    assert bus.grant("scale", 3).command_offset is None
    bus.step(5 * MS)
    assert first.read().tolist() == other.read().tolist() == [0.0]


def test_an_unknown_device_is_denied_with_the_known_ones(bus):
    with pytest.raises(ValueError, match=r"of world masses \(m0, m1, scale\), found 'm9'"):
        bus.grant("m9", 1)


@pytest.mark.parametrize("world", [MassWorld, BoxesWorld])
def test_the_rings_of_a_world_do_not_overlap_and_fit(world, segment):  # law 16
    bus, spans = Bus("w", world(), segment), []
    for number, sheet in enumerate(bus.world.devices(), 1):
        grant = bus.grant(sheet.name, number)
        spans.append((grant.state_offset, grant.state_offset + Ring.footprint(8 * len(sheet.state))))
        if grant.command_offset is not None:
            spans.append((grant.command_offset, grant.command_offset + Ring.footprint(8 * (2 + len(sheet.command)))))
        bus.release(sheet.name, number)  # of devices that stand at one place only one is granted at a time
    spans.sort()
    assert all(earlier[1] <= other[0] for earlier, other in itertools.pairwise(spans))
    assert spans[-1][1] <= SEGMENT_SIZE


def test_the_layout_is_that_of_the_world_and_not_of_the_order_of_claims(segment):
    first, other = (Bus("w", MassWorld(), segment) for _ in range(2))
    first = {name: first.grant(name, 1).state_offset for name in ("m0", "m1", "scale")}
    assert {name: other.grant(name, 1).state_offset for name in ("scale", "m1", "m0")} == first


def test_a_command_acts_from_the_next_step_on_and_its_state_is_published(bus, segment):  # law 1
    claimed_device = device(bus, segment)
    claimed_device.write([2.0])
    assert claimed_device.read().tolist() == [0.0, 0.0]
    bus.step(1 * MS)
    x, v = claimed_device.read()
    assert (x, v) == (pytest.approx(2e-6), pytest.approx(2e-3))


def test_a_granted_device_shows_its_state_at_once(bus, segment):
    claimed_device = device(bus, segment)
    claimed_device.read()
    assert claimed_device.is_held


def test_the_newest_command_is_delivered_once(bus, segment):
    results = []
    claimed_device = device(bus, segment)
    bus.world.command = lambda *given: results.append((given[0], given[1], given[2], list(given[3])))
    claimed_device.write([1.0])
    claimed_device.write([2.0])
    bus.deliver()
    bus.deliver()
    assert results == [("m0", 1, DeviceOrder.DRIVE, [2.0])]


def test_a_command_from_before_the_claim_is_not_delivered(bus, segment):
    claimed_device = device(bus, segment, epoch=1)
    bus.release("m0", 1)
    claimed_device.write([9.0])
    results = []
    bus.world.command = lambda *given: results.append(given)
    bus.grant("m0", 2)
    bus.deliver()
    assert results == []


def test_a_release_delivers_the_last_command_and_leaves_the_drive_in_hold(bus, segment):  # law 18
    claimed_device = device(bus, segment)
    claimed_device.write([1.0])
    bus.release("m0", 1)
    claimed_device.write([1.0])
    bus.step(2 * MS)
    assert claimed_device.read().tolist() == [0.0, 0.0]
    assert bus.world.state("m0")[1] == DriveState.HELD


def test_a_late_release_of_a_dead_writer_leaves_its_heir_alone(bus, segment):  # law 17
    bus.grant("m0", 1)
    bus.world.fence(1)
    heir = device(bus, segment, epoch=2)
    bus.release("m0", 1)
    heir.clear()
    for now in (1, 2, 3):
        bus.step(now * MS)
        heir.write([1.0])
    bus.step(20 * MS)
    assert heir.read()[1] > 0.0


def test_a_touch_is_seen_at_once(bus, segment):  # R-K06
    claimed_device = device(bus, segment)
    bus.touch("panic", 1.0)
    claimed_device.read()
    assert claimed_device.is_pressed
    with pytest.raises(ValueError, match="bell"):
        bus.touch("bell", 1.0)


def test_only_granted_devices_are_published(bus):
    before = bytes(bus._view)
    bus.step(3 * MS)
    assert bytes(bus._view) == before


def test_the_published_state_is_a_copy_of_that_instant(bus, segment):
    claimed_device = device(bus, segment, "scale")
    np.asarray(bus.world.state("scale"))[2] = 5.0
    assert claimed_device.read().tolist() == [0.0]
