"""What the board of a class is shown, and what its teacher asks for, as JSON (requirement X25)."""

from typing import Literal

from msgspec import Struct

from onika.wire.view import SeatState
from onika.words.reason import Reason


class ExpectationRow(Struct, frozen=True):
    """Something that was expected of a hand-in, whether it holds, and why not."""

    text: str
    holds: bool
    why: Reason


class SeatRow(Struct, frozen=True):
    """A seat; ages in seconds, memory in bytes."""

    seat: int
    learner: str
    state: SeatState
    process: Literal["off", "starting", "there", "silent"]
    pages: int
    """How many of its learner's browsers look at it."""
    program: str
    icons: int
    steps: int
    """Acts of its learner that changed something."""
    idle_s: float
    """Since the last step forward."""
    is_stuck: bool
    run: str
    """`starting`, `running`, `stopped`, `completed`, `aborted`; empty: nothing was run."""
    done: int
    of: int
    why: Reason
    """Why a run stands, or ended before its time."""
    refusal: Reason
    refusal_s: float
    ended: Reason
    """Why its process was ended."""
    note: str
    handed_in: int
    expectations: tuple[ExpectationRow, ...]
    grade_why: Reason
    """Why nothing could be tried."""
    may_return: bool
    bytes: int
    processes: int
    course: str = ""
    """Of the help, where the learner is in one; empty: in none."""
    lessons: int = 0
    lessons_of: int = 0
    """How many of its lessons are done, of all."""


class ClassBoard(Struct, frozen=True):
    """The whole class."""

    code: str
    address: str
    """Where learners come in."""
    seats: int
    rows: tuple[SeatRow, ...]
    trouble: Reason
    """What could not be kept, or started."""


class TeacherAct(Struct, frozen=True, forbid_unknown_fields=True):
    """What the board asks for: of which seats, and with which words."""

    act: Literal["freeze", "release", "take", "tell", "collect", "return", "restart"]
    seats: tuple[int, ...]
    text: str = ""
