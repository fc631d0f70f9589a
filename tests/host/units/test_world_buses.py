import pytest

from kit.mass_world import MassWorld
from onika.host.units.world_buses import Buses
from onika.ring.drive import DriveMode

MS = 1_000_000


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


class Obedient(MassWorld):
    """A world that says what it was told."""

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


def test_one_step_moves_every_world_on(buses):
    buses.grant("yard:m0", 0)
    buses.step_once()
    assert [world.now_ns for world in buses.worlds] == [MassWorld.step_ns]


def test_drives_say_how_they_stand_by_world_and_device(buses):  # R-X24, law 17
    buses.grant("yard:m0", 0)
    buses.touch("yard", "panic", 1.0)
    assert buses.modes() == {"yard:m0": DriveMode.PRESSED, "yard:m1": DriveMode.PRESSED}
    buses.touch("yard", "panic", 0.0)
    assert buses.modes()["yard:m0"] is DriveMode.TRIPPED
