from pathlib import Path

import pytest

from onika.ring.device import DeviceOrder, DriveState
from onika.ring.drive import NEVER_NS, TABLE, DriveInput, DriveMode, DriveUnit, input_of

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

CAUSES = {
    DriveInput.DRIVE: "workcell.drive_commanded",
    DriveInput.HOLD: "workcell.hold_commanded",
    DriveInput.CLEAR: "workcell.cleared",
    DriveInput.UNSOUND: "workcell.command_not_finite",
    DriveInput.SILENCE: "workcell.short_silence",
    DriveInput.LONG_SILENCE: "workcell.long_silence",
    DriveInput.FENCE: "workcell.writer_gone",
    DriveInput.RELEASE: "workcell.released",
    DriveInput.STOP: "workcell.stop",
    DriveInput.RESET: "workcell.reset",
    DriveInput.PRESS: "workcell.button_pressed",
    DriveInput.LET_GO: "workcell.button_let_go",
}
DOCUMENTED = {
    "on DRIVE": {DriveInput.DRIVE},
    "on HOLD": {DriveInput.HOLD},
    "on CLEAR": {DriveInput.CLEAR},
    "50 ms silent": {DriveInput.SILENCE},
    "250 ms silent": {DriveInput.LONG_SILENCE},
    "writer dies, command no number": {DriveInput.FENCE, DriveInput.UNSOUND},
    "released": {DriveInput.RELEASE},
    "stop": {DriveInput.STOP},
    "button pressed": {DriveInput.PRESS},
    "let go": {DriveInput.LET_GO},
}
MS = 1_000_000
YEAR_NS = 365 * 24 * 3600 * 1000 * MS


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


def test_the_table_in_the_document_is_the_table():  # R-X24
    text = (Path(__file__).parents[2] / "docs" / "safety.md").read_text(encoding="utf-8")
    rows = [[cell.strip() for cell in line.strip("| \n").split("|")] for line in text.splitlines() if "|" in line]
    at = next(at for at, row in enumerate(rows) if row[0] == "it is")
    documented = {row[0]: dict(zip(rows[at][1:], row[1:], strict=True)) for row in rows[at + 2 : at + 2 + len(TABLE)]}
    assert documented == {
        mode.value: {
            column: {row[drive_input].value for drive_input in drive_inputs}.pop()
            for column, drive_inputs in DOCUMENTED.items()
        }
        for mode, row in TABLE.items()
    }


@pytest.mark.parametrize("drive_input", DriveInput)
def test_what_happens_to_a_drive_is_told_as_the_cause(drive_input):  # R-X06
    assert drive_input.value.key == CAUSES[drive_input]


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
    assert (drive.mode, drive.last_ns) == (H, -1)
    assert drive.silence(10**15) is None


@pytest.mark.parametrize("mode", [H, T, P, X])
def test_what_waits_for_no_command_has_no_last_instant(mode):  # law 17
    drive = DriveUnit()
    drive.mode = mode
    assert drive.due_ns == NEVER_NS
    assert 100 * YEAR_NS < NEVER_NS < 2**63


def test_silence_is_judged_just_beyond_fifty_milliseconds():  # law 17
    drive = DriveUnit()
    drive.feed(DriveInput.DRIVE)
    drive.last_ns = 1000
    assert drive.silence(1000 + 50 * MS) is None
    assert drive.silence(1000 + 50 * MS + 1) is DriveInput.SILENCE
    assert drive.due_ns == 1000 + 50 * MS


def test_after_silence_it_trips_just_beyond_two_hundred_and_fifty():  # law 17
    drive = DriveUnit()
    drive.last_ns, drive.mode = 1000, S
    assert drive.silence(1000 + 250 * MS) is None
    assert drive.silence(1000 + 250 * MS + 1) is DriveInput.LONG_SILENCE
    drive.feed(DriveInput.LONG_SILENCE)
    assert drive.due_ns == NEVER_NS


def test_an_order_is_an_input_and_anything_else_a_fault():
    assert [input_of(order) for order in DeviceOrder] == [DriveInput.HOLD, DriveInput.DRIVE, DriveInput.CLEAR]
    with pytest.raises(ValueError, match="7"):
        input_of(7)
