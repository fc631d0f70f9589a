"""The small world of masses."""

import pytest

from kit.worlds.mass_world import HOLD_NS, TRIP_NS, MassWorld
from onika.ring.device import DeviceOrder, DriveState
from onika.ring.drive import TABLE, DriveInput, DriveMode
from onika.runtime.bus import World

MS = 1_000_000
EPOCH = 7


@pytest.fixture
def world():
    world: World = MassWorld()
    world.claim("m0", 1)
    return world


def drive(world):
    return world.state("m0")[1]


def test_a_constant_force_moves_a_mass(world):
    for now in range(0, 1000, 10):
        world.command("m0", 1, DeviceOrder.DRIVE, [2.0])
        world.step((now + 10) * MS)
    _, _, x, v = world.state("m0")
    assert v == pytest.approx(2.0)
    assert x == pytest.approx(1.0, rel=2e-3)


def test_time_goes_on_in_whole_steps(world):
    world.step(2_700_000)
    assert world.now_ns == 2 * MS
    assert world.state("m0")[0] == pytest.approx(0.002)


def test_a_drive_holds_after_50_ms_without_a_command_and_trips_after_250(world):  # law 17
    world.command("m0", 1, DeviceOrder.DRIVE, [1.0])
    world.step(HOLD_NS)
    assert drive(world) == DriveState.DRIVEN
    world.step(HOLD_NS + 2 * MS)
    assert drive(world) == DriveState.HELD
    world.step(TRIP_NS + 2 * MS)
    assert drive(world) == DriveState.TRIPPED
    assert [str(event.cause) for event in world.take_events()] == ["DRIVE", "silence", "long silence"]


def test_a_hold_that_was_commanded_lasts(world):  # law 17
    world.command("m0", 1, DeviceOrder.HOLD, [0.0])
    world.step(TRIP_NS * 2)
    assert drive(world) == DriveState.HELD


def test_a_tripped_drive_comes_back_by_clear_only(world):  # law 17
    world.fence(1)
    world.claim("m0", 2)
    for order, expected in [
        (DeviceOrder.DRIVE, DriveState.TRIPPED), (DeviceOrder.HOLD, DriveState.TRIPPED),
        (DeviceOrder.CLEAR, DriveState.HELD), (DeviceOrder.DRIVE, DriveState.DRIVEN),
    ]:  # fmt: skip
        world.command("m0", 2, order, [1.0])
        assert drive(world) == expected


def test_a_mass_that_holds_stands_still(world):
    world.command("m0", 1, DeviceOrder.DRIVE, [1.0])
    world.step(10 * MS)
    world.command("m0", 1, DeviceOrder.HOLD, [0.0])
    before = world.state("m0")[2]
    world.step(20 * MS)
    assert world.state("m0")[2:].tolist() == [before, 0.0]


def test_claims_are_for_one_living_writer_and_end_in_hold(world):  # laws 9, 17
    with pytest.raises(ValueError, match="claimed already"):
        world.claim("m0", 2)
    with pytest.raises(ValueError, match="expected a mass"):
        world.claim("scale", 2)
    world.command("m0", 1, DeviceOrder.DRIVE, [1.0])
    world.release("m0", 2)
    assert drive(world) == DriveState.DRIVEN
    world.release("m0", 1)
    assert drive(world) == DriveState.HELD
    world.command("m0", 1, DeviceOrder.DRIVE, [1.0])
    assert drive(world) == DriveState.HELD


def test_a_stop_is_latched(world):  # law 27
    world.command("m0", 1, DeviceOrder.DRIVE, [1.0])
    world.stop()
    world.command("m0", 1, DeviceOrder.DRIVE, [1.0])
    assert drive(world) == DriveState.HELD


def test_the_button_holds_all_masses_until_it_is_let_go_and_they_are_cleared(world):  # R-K06
    assert list(world.parts()) == ["panic"]
    world.command("m0", 1, DeviceOrder.DRIVE, [1.0])
    world.touch("panic", 1.0)
    for order in (DeviceOrder.CLEAR, DeviceOrder.DRIVE):
        world.command("m0", 1, order, [1.0])
        assert drive(world) == DriveState.PRESSED
    world.touch("panic", 0.0)
    assert drive(world) == DriveState.TRIPPED
    world.command("m0", 1, DeviceOrder.CLEAR, [0.0])
    assert drive(world) == DriveState.HELD
    for part, value in (("m0", 1.0), ("panic", 2.0)):
        with pytest.raises(ValueError, match="expected 1 or 0 for panic"):
            world.touch(part, value)


def test_the_scale_adds_up_and_the_fingerprint_tells_two_worlds_apart(world):
    other = MassWorld()
    world.command("m0", 1, DeviceOrder.DRIVE, [1.0])
    for yard in (world, other):
        yard.step(10 * MS)
    assert world.state("scale")[2] == world.state("m0")[2] > 0.0
    assert world.fingerprint() == world.snapshot() != other.fingerprint()


def ordered(order, *values):
    return lambda world: world.command("m0", EPOCH, order, values)


def passed(lasts_ms):
    return lambda world: world.step(world.now_ns + lasts_ms * MS)


DRIVE = ordered(DeviceOrder.DRIVE, 1.0)
WAYS = {
    DriveMode.HELD: (),
    DriveMode.DRIVEN: (DRIVE,),
    DriveMode.SILENT: (DRIVE, passed(60)),
    DriveMode.TRIPPED: (DRIVE, passed(60), passed(250)),
    DriveMode.PRESSED: (lambda world: world.touch("panic", 1.0),),
    DriveMode.STOPPED: (lambda world: world.stop(),),
}
INPUTS = {
    DriveInput.DRIVE: DRIVE,
    DriveInput.HOLD: ordered(DeviceOrder.HOLD),
    DriveInput.CLEAR: ordered(DeviceOrder.CLEAR),
    DriveInput.FENCE: lambda world: world.fence(EPOCH),
    DriveInput.RELEASE: lambda world: world.release("m0", EPOCH),
    DriveInput.STOP: lambda world: world.stop(),
    DriveInput.PRESS: lambda world: world.touch("panic", 1.0),
    DriveInput.LET_GO: lambda world: world.touch("panic", 0.0),
}


@pytest.mark.parametrize("happening", INPUTS, ids=lambda happening: happening.name)
@pytest.mark.parametrize("state", WAYS, ids=lambda state: state.name)
def test_a_mass_does_what_the_table_of_drives_says(state, happening):  # law 17
    world = MassWorld(1)
    world.claim("m0", EPOCH)
    for step in WAYS[state]:
        step(world)
    assert world.modes() == {"m0": state}
    INPUTS[happening](world)
    assert world.modes() == {"m0": TABLE[state][happening]}
