"""The device bus, between shared memory and a world."""

import itertools

import numpy as np
import pytest
from msgspec import convert

from kit.worlds.box_cells import boxes_world
from kit.worlds.eyed_world import EyedWorld
from kit.worlds.mass_world import MassWorld
from kit.worlds.resettable_masses import ResettableMasses
from onika.ring.device import DeviceOrder, DeviceSheet, DriveState
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.ring.slots import Ring
from onika.runtime.bus import SEGMENT_SIZE, Bus
from onika.runtime.modules.binding import attach
from onika.words.reason import Reason

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


def test_it_says_how_the_drives_of_its_world_stand(bus, segment):  # law 17
    device(bus, segment).write([1.0])
    bus.step(1 * MS)
    assert bus.modes() == {"masses:m0": DriveMode.DRIVEN, "masses:m1": DriveMode.HELD}


def test_a_world_is_drawn_and_touched_by_plain_values(segment):  # R-K06
    bus = Bus("w", boxes_world(), segment)
    scene = bus.scene()
    assert {shape["name"] for shape in scene["shapes"]} >= {shape.name for shape in bus.world.scene()}
    assert convert(scene["parts"], dict[str, Reason]) == dict(bus.world.parts())
    assert scene["buttons"] == {name: list(place) for name, place in bus.world.button_places().items()}
    assert set(scene["buttons"]) == set(scene["parts"]) == {"panic_left", "panic_right"} and "pressed" not in scene
    bus.touch("panic_right", 1.0)
    assert bus.scene()["pressed"] == ("panic_right",)
    assert bus.poses() == (bus.world.now_ns, bus.world.poses().tobytes(), bus.world.lit)


def test_what_is_a_switch_among_the_buttons_is_told_to_whoever_draws_it(segment, monkeypatch):  # R-X19
    assert "switches" not in Bus("w", MassWorld(), segment).scene()
    monkeypatch.setattr(MassWorld, "switches", ("door",), raising=False)
    assert Bus("w", MassWorld(), segment).scene()["switches"] == ("door",)


def test_devices_lie_one_behind_the_other_from_the_beginning(segment):  # law 16
    bus = Bus("w", MassWorld(), segment)
    grants = [bus.grant(name, number) for number, name in enumerate(("m0", "m1", "scale"), 1)]
    state, command = Ring.footprint(8 * 4), Ring.footprint(8 * 3)
    assert [grant.state_offset for grant in grants] == [0, state + command, 2 * (state + command)]
    assert [grant.command_offset for grant in grants] == [state, 2 * state + command, None]
    assert SEGMENT_SIZE == 67_108_864


class Store:
    """A world of devices of all sizes, which only lie there."""

    def __init__(self, *sizes):
        self.sheets = [DeviceSheet(f"d{k}", ("x",) * state, ("c",) * command, {}) for k, (state, command) in sizes]

    def devices(self):
        return tuple(self.sheets)

    def claim(self, device, epoch):
        return next(sheet for sheet in self.sheets if sheet.name == device)

    def state(self, device):
        return np.zeros(len(self.claim(device, 0).state))


def test_each_device_has_as_much_room_as_its_values_take(segment):  # law 16
    sizes = [(state, command) for state in (2, 7, 8, 9, 15, 16, 17) for command in (1, 5, 6, 7, 13, 14, 15)]
    bus, end = Bus("w", Store(*enumerate(sizes)), segment), 0
    for number, (state, command) in enumerate(sizes):
        grant = bus.grant(f"d{number}", number)
        assert (grant.state_offset, grant.command_offset) == (end, end + Ring.footprint(8 * state))
        end = grant.command_offset + Ring.footprint(8 * (2 + command))


@pytest.mark.parametrize("world", [MassWorld, boxes_world])
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


def commands_of(bus):
    """What the bus delivers to its world from now on."""
    delivered = []
    command = bus.world.command

    def note(device, epoch, order, values):
        delivered.append((device, epoch, order, list(values)))
        command(device, epoch, order, values)

    bus.world.command = note
    return delivered


def test_a_step_delivers_what_is_new_and_nothing_twice(bus, segment):  # law 1
    claimed_device, delivered = device(bus, segment), commands_of(bus)
    bus.step(1 * MS)
    claimed_device.write([1.0])
    bus.step(2 * MS)
    bus.step(3 * MS)
    assert delivered == [("m0", 1, DeviceOrder.DRIVE, [1.0])]


def test_a_release_delivers_what_was_still_to_come_and_nothing_after_it(bus, segment):  # law 18
    claimed_device, delivered = device(bus, segment), commands_of(bus)
    claimed_device.write([1.0])
    bus.release("m0", 1)
    claimed_device.write([2.0])
    bus.step(1 * MS)
    bus.deliver()
    assert delivered == [("m0", 1, DeviceOrder.DRIVE, [1.0])]


def test_a_release_by_somebody_else_takes_nothing_from_who_holds_it(bus, segment):  # law 17
    claimed_device, delivered = device(bus, segment, epoch=2), commands_of(bus)
    claimed_device.write([1.0])
    for other in (1, 3):
        bus.release("m0", other)
        bus.release("scale", other)
    assert delivered == []
    bus.step(1 * MS)
    assert delivered == [("m0", 2, DeviceOrder.DRIVE, [1.0])]


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


def test_a_world_is_simulated_only_where_it_says_so(segment):  # R-E09
    world = MassWorld()
    kinds = []
    for word in (True, False, "yes", None):
        world.is_simulated = word
        kinds.append(Bus("yard", world, segment).is_simulated)
    assert (kinds, Bus("yard", MassWorld(), segment).is_simulated) == ([True, False, False, False], False)
    assert Bus("boxes", boxes_world(), segment).is_simulated


@pytest.mark.parametrize("is_stopped", [False, True])
def test_what_is_put_back_is_published_at_once_and_stays_stopped_where_it_was(segment, is_stopped):  # laws 18, 27
    bus = Bus("masses", ResettableMasses(), segment)
    mass = device(bus, segment)
    bus.world.state("m0")[2] = 3.0
    bus.step(MS)
    assert (mass.read()[0], bus.displaced()) == (3.0, (Displacement(Reason.plain("m0 is away")),))
    bus.put_back(is_stopped=is_stopped)
    assert (mass.read()[0], bus.displaced()) == (0.0, ())
    assert (bus.modes()["masses:m0"] is DriveMode.STOPPED) is is_stopped


def test_a_world_that_only_a_person_can_put_back_is_refused_by_its_name(segment):  # law 18
    with pytest.raises(ValueError, match="masses") as refusal:
        Bus("masses", MassWorld(), segment).put_back(is_stopped=False)
    assert refusal.value.args == (Reason.of("runtime.put_all_back_by_hand", world="masses"),)


class Teller(MassWorld):
    """Masses of which each has a sentence of how it stands."""

    def standing(self):
        return [Reason.plain(f"{name} rests") for name in self._masses]


def test_how_a_world_stands_is_told_in_its_sentences_and_nothing_where_it_knows_none(segment):  # R-E16
    assert Bus("masses", Teller(), segment).standing() == (Reason.plain("m0 rests"), Reason.plain("m1 rests"))
    assert Bus("masses", MassWorld(), segment).standing() == ()


def test_a_camera_is_granted_with_its_ring_and_taken_pictures_are_there_with_their_number(segment):  # R-F05
    world = EyedWorld()
    bus = Bus("w", world, segment)
    ends = [bus.grant(name, number).command_offset for number, name in enumerate(("m0", "m1"), 1)]
    grant = bus.grant("eye", 3)
    ring = Ring(segment.view, grant.picture_offset, 18)
    assert (grant.picture, grant.command_offset, world.used) == ((2, 3), None, True)
    assert grant.picture_offset > max(*ends, grant.state_offset)
    bus.step(world.step_ns)
    state = np.frombuffer(Ring(segment.view, grant.state_offset, 32).read())
    assert (state[2], ring.read(), ring.count) == (1.0, bytes([1]) * 18, 1)
    bus.release("eye", 3)
    assert not world.used
    assert bus.grant("scale", 4).picture == ()


def test_who_looks_is_shown_the_pictures_of_a_camera_and_nothing_else(segment):  # R-F08
    world = EyedWorld()
    bus = Bus("w", world, segment)
    for device in ("m0", "nothing"):
        bus.show(device, True)
    assert (world.shown, bus.take_small()) == (False, {})
    bus.show("eye", True)
    assert bus.take_small() == {"eye": (0, 0, b"file")}
    bus.show("eye", False)
    assert (world.shown, bus.take_small()) == (False, {})


def test_a_scene_names_cameras_where_there_are_any(segment):  # R-F08
    eyed, plain = Bus("w", EyedWorld(), segment).scene(), Bus("w", MassWorld(), segment).scene()
    assert "cameras" not in plain
    assert eyed == plain | {"cameras": [{"name": "eye", "width": 3, "height": 2, "rate": 10.0}]}
