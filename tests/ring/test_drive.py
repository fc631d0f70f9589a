import pytest

from onika.ring.device import DeviceOrder, DriveState
from onika.ring.drive import NEVER_NS, SILENCE_NS, TABLE, TRIP_NS, DriveInput, DriveMode, DriveUnit, input_of

D, H, S, T, P, X = (
    DriveMode.DRIVEN,
    DriveMode.HELD,
    DriveMode.SILENT,
    DriveMode.TRIPPED,
    DriveMode.PRESSED,
    DriveMode.STOPPED,
)

# law 17 said a second time, by rule instead of by row
LATCHED = {
    T: {DriveInput.CLEAR: H, DriveInput.STOP: X, DriveInput.RESET: H, DriveInput.PRESS: P},
    P: {DriveInput.STOP: X, DriveInput.LET_GO: T},
    X: {DriveInput.RESET: H},
}
ANYWHERE = {
    DriveInput.DRIVE: D,
    DriveInput.HOLD: H,
    DriveInput.UNSOUND: T,
    DriveInput.FENCE: T,
    DriveInput.RELEASE: H,
    DriveInput.STOP: X,
    DriveInput.RESET: H,
    DriveInput.PRESS: P,
}
OWN = {
    (D, DriveInput.CLEAR): D,
    (D, DriveInput.SILENCE): S,
    (D, DriveInput.LONG_SILENCE): S,
    (S, DriveInput.CLEAR): H,
    (S, DriveInput.LONG_SILENCE): T,
}


@pytest.mark.parametrize("mode", DriveMode)
@pytest.mark.parametrize("drive_input", DriveInput)
def test_every_input_in_every_mode(mode, drive_input):  # law 17
    if mode in LATCHED:
        expected = LATCHED[mode].get(drive_input, mode)
    else:
        expected = OWN.get((mode, drive_input), ANYWHERE.get(drive_input, mode))
    drive = DriveUnit()
    drive.mode = mode
    drive.feed(drive_input)
    assert drive.mode is expected


def test_the_table_is_complete():
    assert set(TABLE) == set(DriveMode)
    assert all(set(row) == set(DriveInput) for row in TABLE.values())


@pytest.mark.parametrize(
    ("mode", "shown"),
    [
        (D, DriveState.DRIVEN),
        (H, DriveState.HELD),
        (S, DriveState.HELD),
        (T, DriveState.TRIPPED),
        (P, DriveState.PRESSED),
        (X, DriveState.HELD),
    ],
)
def test_others_see_four_states(mode, shown):
    drive = DriveUnit()
    drive.mode = mode
    assert drive.shown is shown


def test_a_drive_starts_in_hold_and_never_trips_by_waiting():
    drive = DriveUnit()
    assert drive.mode is H
    assert drive.silence(10**15) is None


def test_silence_is_judged_just_beyond_fifty_milliseconds():
    drive = DriveUnit()
    drive.feed(DriveInput.DRIVE)
    drive.last_ns = 1000
    assert drive.silence(1000 + SILENCE_NS) is None
    assert drive.silence(1000 + SILENCE_NS + 1) is DriveInput.SILENCE
    assert drive.due_ns == 1000 + SILENCE_NS


def test_after_silence_it_trips_just_beyond_two_hundred_and_fifty():
    drive = DriveUnit()
    drive.last_ns, drive.mode = 1000, S
    assert drive.silence(1000 + TRIP_NS) is None
    assert drive.silence(1000 + TRIP_NS + 1) is DriveInput.LONG_SILENCE
    drive.feed(DriveInput.LONG_SILENCE)
    assert drive.due_ns == NEVER_NS


def test_an_order_is_an_input_and_anything_else_a_fault():
    assert [input_of(order) for order in DeviceOrder] == [DriveInput.HOLD, DriveInput.DRIVE, DriveInput.CLEAR]
    with pytest.raises(ValueError, match="7"):
        input_of(7)
