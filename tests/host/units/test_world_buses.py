import pytest

from kit.worlds.eyed_world import EyedWorld
from kit.worlds.mass_world import MassWorld
from onika.host.units.world_buses import Buses
from onika.ring.device import DeviceOrder, DriveState, MishapEvent
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.runtime.bus import SEGMENT_SIZE
from onika.wire import event
from onika.wire.world_source import WorldSource
from onika.words.reason import NOTHING, Reason

MS = 1_000_000
TAKES = {"key": "workcell.button_takes", "text": "1 pressed, 0 let go"}


@pytest.fixture
def messages():
    return []


@pytest.fixture
def buses(messages):
    return Buses({}, lambda _name: MassWorld(), messages.append)


def test_a_world_is_opened_with_its_first_device_and_stands_where_the_others_stand(buses):  # laws 17, 18
    assert buses.names == ()
    buses.grant("yard:m0", 20 * MS)
    buses.grant("yard:m1", 40 * MS)
    assert buses.names == ("yard",)
    assert [world.now_ns for world in buses.worlds] == [20 * MS]


def test_the_open_worlds_that_are_simulated_are_told_and_no_others(messages):  # R-E09
    def open_world(name):
        world = MassWorld()
        world.is_simulated = {"yard": True, "odd": "yes"}.get(name, False)
        return world

    buses = Buses({}, open_world, messages.append)
    assert buses.simulated == ()
    for name in ("cell", "yard", "odd"):
        buses.grant(f"{name}:m0", 0)
    assert (buses.names, buses.simulated) == (("cell", "yard", "odd"), ("yard",))


def test_what_drives_a_device_in_one_world_moves_nothing_in_another(messages):  # R-E09, law 18
    worlds = {}
    buses = Buses({}, lambda name: worlds.setdefault(name, MassWorld()), messages.append)
    buses.grant("cell:m0", 0)
    buses.grant("yard:m0", 0)
    worlds["yard"].command("m0", 2, DeviceOrder.DRIVE, [1.0])
    buses.step(30 * MS)
    assert (worlds["yard"].state("m0")[2] > 0.0, worlds["cell"].state("m0")[2]) == (True, 0.0)
    buses.touch("yard", "panic", 1.0)
    assert buses.modes() == {
        "cell:m0": DriveMode.HELD,
        "cell:m1": DriveMode.HELD,
        "yard:m0": DriveMode.PRESSED,
        "yard:m1": DriveMode.PRESSED,
    }


def test_a_device_is_claimed_once_until_it_is_given_back(buses):  # law 18
    buses.grant("yard:m0", 0)
    with pytest.raises(ValueError, match="m0"):
        buses.grant("yard:m0", 0)
    buses.release("yard:m0")
    assert buses.grant("yard:m0", 0)


def test_what_is_no_device_of_a_world_is_refused(buses):
    with pytest.raises(ValueError, match="expected WORLD:DEVICE, found 'm0'"):
        buses.grant("m0", 0)


def test_a_world_that_is_not_open_shows_nothing_and_cannot_be_touched(buses):  # R-K06
    assert (buses.scene("yard"), buses.poses("yard"), buses.snapshots()) == (None, None, {})
    with pytest.raises(ValueError, match="none is open"):
        buses.touch("yard", "panic", 1.0)


def test_what_a_touch_does_to_a_drive_is_told_at_once(buses, messages):  # R-K06
    buses.grant("yard:m0", 0)
    buses.touch("yard", "panic", 1.0)
    assert [(message.device, message.state) for message in messages] == [("yard:m0", "PRESSED"), ("yard:m1", "PRESSED")]


def test_what_a_drive_does_is_told_with_its_instants_and_its_cause(buses, messages):  # R-X06
    buses.grant("yard:m0", 0)
    buses.step(20 * MS)
    buses.touch("yard", "panic", 1.0)
    assert messages[0] == event.Drive("yard:m0", "PRESSED", 20 * MS, 19 * MS, -1, Reason.plain("pressed"))


@pytest.mark.parametrize("step", [lambda buses: buses.step(1 * MS), lambda buses: buses.step_once()])
def test_what_a_step_does_to_a_drive_is_told(buses, messages, step):  # R-X06
    grant = buses.grant("yard:m0", 0)
    (world,) = buses.worlds
    world.command("m0", grant.epoch, DeviceOrder.DRIVE, [1.0])
    step(buses)
    assert [(message.device, message.state) for message in messages] == [("yard:m0", "DRIVEN")]


def test_a_world_whose_files_came_is_made_of_them_and_what_names_them_is_known(messages):  # R-X19
    opened = []

    def open_world(name, files=None):
        opened.append((name, files))
        return MassWorld()

    buses = Buses({}, open_world, messages.append)
    files = WorldSource("cell", "abc", ())
    buses.sources.take([files])
    buses.grant("cell:m0", 0)
    buses.grant("yard:m0", 0)
    assert opened == [("cell", files), ("yard", None)]
    assert buses.opened == {"cell": "abc", "yard": ""}


def test_at_the_end_no_world_is_open_and_its_memory_is_given_back(messages):  # R-X23
    views = {}
    buses = Buses(views, lambda _name: MassWorld(), messages.append)
    buses.grant("yard:m0", 0)
    buses.close()
    assert buses.names == ()
    with pytest.raises(ValueError, match="released"):
        views["bus:yard"].tobytes()


def test_every_grant_has_an_epoch_of_its_own(buses):  # law 17
    assert [buses.grant(device, 0).epoch for device in ("yard:m0", "yard:m1", "field:m0")] == [1, 2, 3]


def test_a_world_is_opened_by_its_name_and_its_memory_found_by_it(messages):  # law 16
    views, opened = {}, []

    def open_world(name):
        opened.append(name)
        return MassWorld()

    buses = Buses(views, open_world, messages.append)
    assert buses.grant("yard:m0", 0).segment == "bus:yard"
    assert (list(views), opened) == (["bus:yard"], ["yard"])
    assert len(views["bus:yard"]) == SEGMENT_SIZE
    with pytest.raises(ValueError, match="of world yard"):
        buses.grant("yard:m9", 0)


def test_an_open_world_shows_what_it_is_and_where(buses):  # R-K06
    buses.grant("yard:m0", 20 * MS)
    (world,) = buses.worlds
    assert buses.scene("yard") == {"shapes": [], "parts": {"panic": TAKES}}
    assert buses.poses("yard") == (20 * MS, world.poses().tobytes(), ())
    assert buses.snapshots() == {"yard": world.snapshot()}


class Obedient(MassWorld):
    """A world that says what it was told."""

    order = ""

    def stop(self):
        self.order = "stop"

    def go_on(self):
        self.order = "go on"


def test_a_world_that_is_opened_after_a_stop_is_stopped_too():  # law 27
    buses = Buses({}, lambda _name: Obedient(), lambda _event: None)
    buses.stop()
    buses.grant("yard:m0", 0)
    (world,) = buses.worlds
    assert world.order == "stop"
    buses.go_on()
    assert world.order == "go on"
    buses.grant("field:m0", 0)
    assert [world.order for world in buses.worlds] == ["go on", ""]


def test_a_stop_stops_every_world_that_is_open():  # law 27
    buses = Buses({}, lambda _name: Obedient(), lambda _event: None)
    buses.grant("yard:m0", 0)
    buses.grant("field:m0", 0)
    assert [world.order for world in buses.worlds] == ["", ""]
    buses.stop()
    assert [world.order for world in buses.worlds] == ["stop", "stop"]


def test_one_step_moves_every_world_on(buses):
    buses.grant("yard:m0", 0)
    buses.step_once()
    buses.step_once()
    assert [world.now_ns for world in buses.worlds] == [2 * MassWorld.step_ns]


def test_drives_say_how_they_stand_by_world_and_device(buses):  # R-X24, law 17
    buses.grant("yard:m0", 0)
    buses.touch("yard", "panic", 1.0)
    assert buses.modes() == {"yard:m0": DriveMode.PRESSED, "yard:m1": DriveMode.PRESSED}
    buses.touch("yard", "panic", 0.0)
    assert buses.modes()["yard:m0"] is DriveMode.TRIPPED


class Stage(MassWorld):
    """A world that is put back: its drives hold then, and a stop is forgotten."""

    is_simulated = True
    is_as_it_was = False

    def reset(self):
        self.is_as_it_was = True
        self.go_on()
        for mass in self._masses.values():
            self._turn(mass, DriveState.HELD, "reset")

    def places(self):
        return ()

    def displaced(self):
        return () if self.is_as_it_was else (Displacement(Reason.plain("away")),)


def test_a_world_is_put_back_what_its_drives_do_is_told_and_a_stop_stays(messages):  # laws 18, 27
    worlds = {}
    buses = Buses({}, lambda name: worlds.setdefault(name, Stage()), messages.append)
    for name in ("cell", "yard"):
        buses.grant(f"{name}:m0", 0)
    worlds["yard"].command("m0", 2, DeviceOrder.DRIVE, [1.0])
    buses.step(MS)
    messages.clear()
    buses.put_back("yard")
    assert buses.displaced() == {"cell": (Displacement(Reason.plain("away")),), "yard": ()}
    assert [(drive.device, drive.state) for drive in messages] == [("yard:m0", "HELD")]
    assert buses.modes()["yard:m0"] is DriveMode.HELD
    buses.stop()
    buses.put_back("yard")
    assert buses.modes()["yard:m0"] is DriveMode.STOPPED


def test_where_a_drive_holds_and_what_is_in_its_way_is_told(buses, messages, monkeypatch):  # R-X06
    stands, touches = Reason.plain("m0 stands at 1 m"), (Reason.plain("m0 touches m1"),)
    monkeypatch.setattr(MassWorld, "halt", (stands, touches))
    epoch = buses.grant("yard:m0", 0).epoch
    world = next(buses.worlds)
    for order in (DeviceOrder.DRIVE, DeviceOrder.HOLD):
        world.command("m0", epoch, order, [1.0])
    buses.step(MS)
    assert [(drive.state, drive.stands, drive.touches) for drive in messages] == [
        ("DRIVEN", NOTHING, ()),
        ("HELD", stands, touches),
    ]


def test_a_world_that_is_not_open_or_that_nobody_can_move_is_not_put_back(buses):  # law 18
    with pytest.raises(ValueError, match="yard"):
        buses.put_back("yard")
    buses.grant("yard:m0", 0)
    with pytest.raises(ValueError, match="by hand"):
        buses.put_back("yard")
    assert buses.displaced() == {"yard": ()}


class Witness(MassWorld):
    """A world that knows what goes wrong in it, and what it says of how it stands."""

    def __init__(self, *mishaps, standing=()):
        super().__init__()
        self.mishaps = list(mishaps)
        self.is_watched = False
        self._sentences = standing

    def watch_mishaps(self):
        self.is_watched = True

    def take_mishaps(self):
        taken, self.mishaps = self.mishaps, []
        return taken

    def standing(self):
        return self._sentences


FALL = MishapEvent(Reason.plain("m0 falls"), 3 * MS, ("m0",), b"fallen", ("lamp",))
CRASH = MishapEvent(Reason.plain("m0 hits m1"), 5 * MS, ("m0", "m1"), b"crashed")


def mishap_buses(worlds, mishaps):
    """Buses of worlds by name, which note each mishap with its time."""
    return Buses({}, worlds.__getitem__, lambda _drive: None, lambda *mishap: mishaps.append(mishap))


def test_mishaps_are_watched_from_the_opening_where_somebody_wants_them_and_the_world_knows_them():  # R-E16
    yard = Witness()
    buses = mishap_buses({"yard": yard, "plain": MassWorld()}, [])
    assert not yard.is_watched
    buses.grant("yard:m0", 0)
    assert yard.is_watched
    assert buses.grant("plain:m0", 0).epoch == 2, "a world that knows of no mishaps is opened all the same"
    assert buses.watched() == {"yard": True, "plain": False}


def test_each_mishap_is_told_once_after_a_step_with_its_world_devices_and_time():  # R-E16
    mishaps = []
    buses = mishap_buses({"plain": MassWorld(), "yard": Witness(FALL, CRASH), "field": Witness(FALL)}, mishaps)
    for name in ("plain", "yard", "field"):
        buses.grant(f"{name}:m0", 0)
    assert mishaps == []
    buses.step(20 * MS)
    assert mishaps == [
        (event.Mishap("yard", Reason.plain("m0 falls"), ("yard:m0",), 0.0, b"fallen", ("lamp",)), 3 * MS),
        (event.Mishap("yard", Reason.plain("m0 hits m1"), ("yard:m0", "yard:m1"), 0.0, b"crashed", ()), 5 * MS),
        (event.Mishap("field", Reason.plain("m0 falls"), ("field:m0",), 0.0, b"fallen", ("lamp",)), 3 * MS),
    ]
    buses.step(40 * MS)
    assert len(mishaps) == 3


def test_a_mishap_of_the_very_last_step_is_told_too():  # R-E16
    mishaps = []
    buses = mishap_buses({"yard": Witness(FALL)}, mishaps)
    buses.grant("yard:m0", 0)
    buses.step_once()
    assert [at_ns for _, at_ns in mishaps] == [3 * MS]


def test_where_nobody_wants_mishaps_none_is_watched_or_taken(messages):  # R-E16
    yard = Witness(FALL)
    buses = Buses({}, lambda _name: yard, messages.append)
    buses.grant("yard:m0", 0)
    buses.step(20 * MS)
    assert (yard.is_watched, yard.mishaps, messages) == (False, [FALL], [])
    assert buses.watched() == {"yard": False}


def test_how_worlds_stand_is_told_of_those_that_know_how():  # R-E16
    lamp, door = Reason.plain("the lamp is lit"), Reason.plain("the door is shut")
    worlds = {"plain": MassWorld(), "yard": Witness(standing=[lamp, door]), "mute": Witness()}
    buses = mishap_buses(worlds, [])
    assert buses.standings() == {}
    for name in worlds:
        buses.grant(f"{name}:m0", 0)
    assert buses.standings() == {"yard": (lamp, door)}


def test_pictures_are_told_while_somebody_looks_and_a_camera_is_shared(messages):  # R-F05, R-F08
    worlds = {}
    buses = Buses({}, lambda name: worlds.setdefault(name, EyedWorld()), messages.append)
    assert buses.picture("yard:eye") is None
    buses.grant("yard:eye", 0)
    buses.grant("yard:eye", 0)
    eye = worlds["yard"]
    assert (eye.used, eye.shown) == (True, False)
    number, _, file = buses.picture("yard:eye")
    assert (eye.shown, file) == (True, b"file")
    buses.step(20 * MS)
    assert buses.picture("yard:eye")[0] == number + 1
    assert buses.picture("yard:m0") is None
    buses.look_only_at(["yard:eye", "elsewhere:eye"])
    assert eye.shown
    buses.look_only_at([])
    assert not eye.shown
    buses.release("yard:eye")
    assert eye.used
    buses.release("yard:eye")
    assert not eye.used
