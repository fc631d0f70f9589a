import pytest

from onika.ring.device import Drive, Order
from onika.workcell.drive import NEVER_NS, SILENCE_NS, TABLE, TRIP_NS, DriveUnit, Happening, Mode, happening_of

D, H, S, T, P, X = Mode.DRIVEN, Mode.HELD, Mode.SILENT, Mode.TRIPPED, Mode.PRESSED, Mode.STOPPED

# law 17 said a second time, by rule instead of by row
LATCHED = {
    T: {Happening.CLEAR: H, Happening.STOP: X, Happening.RESET: H, Happening.PRESS: P},
    P: {Happening.STOP: X, Happening.LET_GO: T},
    X: {Happening.RESET: H},
}
ANYWHERE = {
    Happening.DRIVE: D,
    Happening.HOLD: H,
    Happening.UNSOUND: T,
    Happening.FENCE: T,
    Happening.RELEASE: H,
    Happening.STOP: X,
    Happening.RESET: H,
    Happening.PRESS: P,
}
OWN = {
    (D, Happening.CLEAR): D,
    (D, Happening.SILENCE): S,
    (D, Happening.LONG_SILENCE): S,
    (S, Happening.CLEAR): H,
    (S, Happening.LONG_SILENCE): T,
}


@pytest.mark.parametrize("mode", Mode)
@pytest.mark.parametrize("happening", Happening)
def test_every_happening_in_every_mode(mode, happening):  # law 17
    if mode in LATCHED:
        expected = LATCHED[mode].get(happening, mode)
    else:
        expected = OWN.get((mode, happening), ANYWHERE.get(happening, mode))
    drive = DriveUnit()
    drive.mode = mode
    drive.feed(happening)
    assert drive.mode is expected


def test_the_table_is_complete():
    assert set(TABLE) == set(Mode)
    assert all(set(row) == set(Happening) for row in TABLE.values())


@pytest.mark.parametrize(
    ("mode", "shown"),
    [
        (D, Drive.DRIVEN),
        (H, Drive.HELD),
        (S, Drive.HELD),
        (T, Drive.TRIPPED),
        (P, Drive.PRESSED),
        (X, Drive.HELD),
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
    drive.feed(Happening.DRIVE)
    drive.last_ns = 1000
    assert drive.silence(1000 + SILENCE_NS) is None
    assert drive.silence(1000 + SILENCE_NS + 1) is Happening.SILENCE
    assert drive.due_ns == 1000 + SILENCE_NS


def test_after_silence_it_trips_just_beyond_two_hundred_and_fifty():
    drive = DriveUnit()
    drive.last_ns, drive.mode = 1000, S
    assert drive.silence(1000 + TRIP_NS) is None
    assert drive.silence(1000 + TRIP_NS + 1) is Happening.LONG_SILENCE
    drive.feed(Happening.LONG_SILENCE)
    assert drive.due_ns == NEVER_NS


def test_an_order_is_a_happening_and_anything_else_a_fault():
    assert [happening_of(order) for order in Order] == [Happening.HOLD, Happening.DRIVE, Happening.CLEAR]
    with pytest.raises(ValueError, match="7"):
        happening_of(7)
