"""A drive: whether a device follows its commands, holds by itself or has tripped; counted in the world's own time.

    DRIVEN   follows the last command
    HELD     holds because it was told to, or was never told anything
    SILENT   holds because no command came for 50 ms; the next one is followed again
    TRIPPED  holds and stays so until it is cleared: 250 ms of silence, a dead writer, a command that is no number
    PRESSED  holds as long as its panic button is pressed; let go, it has tripped
    STOPPED  holds and stays so until the world is reset or goes on

Everything that can happen in every state stands in TABLE. A device reports four states: SILENT and STOPPED are HELD.
"""

from enum import Enum

from onika.ring.device import DeviceOrder, DriveState
from onika.words.reason import Reason

SILENCE_NS = 50_000_000
"""Longer than this without a command, a driven device holds by itself."""

TRIP_NS = 250_000_000
"""Longer than this without a command, a device that holds by silence trips."""

NEVER_NS = 1 << 62
"""An instant that does not come."""


class DriveMode(Enum):
    """The six states of a drive from within."""

    DRIVEN = "driven"
    HELD = "held"
    SILENT = "silent"
    TRIPPED = "tripped"
    PRESSED = "pressed"
    STOPPED = "stopped"


class DriveInput(Enum):
    """What can happen to a drive; the value is the cause that is reported."""

    DRIVE = Reason.of("workcell.drive_commanded")
    HOLD = Reason.of("workcell.hold_commanded")
    CLEAR = Reason.of("workcell.cleared")
    UNSOUND = Reason.of("workcell.command_not_finite")
    SILENCE = Reason.of("workcell.short_silence")
    LONG_SILENCE = Reason.of("workcell.long_silence")
    FENCE = Reason.of("workcell.writer_gone")
    RELEASE = Reason.of("workcell.released")
    STOP = Reason.of("workcell.stop")
    RESET = Reason.of("workcell.reset")
    PRESS = Reason.of("workcell.button_pressed")
    LET_GO = Reason.of("workcell.button_let_go")


_ORDERS = {DeviceOrder.DRIVE: DriveInput.DRIVE, DeviceOrder.HOLD: DriveInput.HOLD, DeviceOrder.CLEAR: DriveInput.CLEAR}

_SHOWN = {
    DriveMode.DRIVEN: DriveState.DRIVEN,
    DriveMode.HELD: DriveState.HELD,
    DriveMode.SILENT: DriveState.HELD,
    DriveMode.TRIPPED: DriveState.TRIPPED,
    DriveMode.PRESSED: DriveState.PRESSED,
    DriveMode.STOPPED: DriveState.HELD,
}

_D, _H, _S, _T, _P, _X = (
    DriveMode.DRIVEN,
    DriveMode.HELD,
    DriveMode.SILENT,
    DriveMode.TRIPPED,
    DriveMode.PRESSED,
    DriveMode.STOPPED,
)

TABLE: dict[DriveMode, dict[DriveInput, DriveMode]] = {
    state: dict(zip(DriveInput, row, strict=True))
    for state, row in {
        #   DRIVE HOLD CLEAR UNSOUND SILENCE LONG FENCE RELEASE STOP RESET PRESS LET_GO
        _D: (_D, _H, _D, _T, _S, _S, _T, _H, _X, _H, _P, _D),
        _H: (_D, _H, _H, _T, _H, _H, _T, _H, _X, _H, _P, _H),
        _S: (_D, _H, _H, _T, _S, _T, _T, _H, _X, _H, _P, _S),
        _T: (_T, _T, _H, _T, _T, _T, _T, _T, _X, _H, _P, _T),
        _P: (_P, _P, _P, _P, _P, _P, _P, _P, _X, _P, _P, _T),
        _X: (_X, _X, _X, _X, _X, _X, _X, _X, _X, _H, _X, _X),
    }.items()
}


class DriveUnit:
    """The drive of one device: its mode and the instant of its last command (-1: none yet)."""

    __slots__ = ("last_ns", "mode")

    def __init__(self) -> None:
        self.mode = DriveMode.HELD
        self.last_ns = -1

    @property
    def shown(self) -> DriveState:
        """The state that the device reports."""
        return _SHOWN[self.mode]

    @property
    def due_ns(self) -> int:
        """The last instant at which silence is still allowed."""
        if self.mode is DriveMode.DRIVEN:
            return self.last_ns + SILENCE_NS
        if self.mode is DriveMode.SILENT:
            return self.last_ns + TRIP_NS
        return NEVER_NS

    def silence(self, now_ns: int) -> DriveInput | None:
        """What silence makes happen at a step at `now_ns`, or None; changes nothing."""
        if now_ns <= self.due_ns:
            return None
        if self.mode is DriveMode.DRIVEN:
            return DriveInput.SILENCE
        return DriveInput.LONG_SILENCE

    def feed(self, drive_input: DriveInput) -> None:
        """Move as the table says."""
        self.mode = TABLE[self.mode][drive_input]


def input_of(order: int) -> DriveInput:
    """What a command with finite numbers is; raises ValueError for an unknown order."""
    return _ORDERS[DeviceOrder(order)]
