"""What is left of a run or a recording when it ends."""

from typing import Any

from msgspec import Struct

from onika.wire.figures import TaskFigures, VariableSteps
from onika.words.reason import NOTHING, Reason


class Recording(Struct, frozen=True, tag=True):
    """A subsystem that is held by hand is recorded from now on, or no more (X05)."""

    subsystem: str
    at_s: float
    path: str
    """The file on the runtime's machine."""
    is_on: bool
    cause: Reason = NOTHING
    """Why it has ended, where nobody asked for that."""
    lasted_s: float = 0.0
    """How much of the time of the subsystem is in it, where it has ended."""


class Result(Struct, frozen=True, tag=True):
    """The end of a run: always the last event."""

    completed: bool
    cause: Reason
    done: int
    of: int
    runtime_s: float
    wall_s: float
    values: dict[str, Any]
    tasks: tuple[TaskFigures, ...]
    hash: str
    """Of a virtual run: everything that happened and the worlds every 50 ms, as SHA-256; else empty."""
    skews_us: tuple[float, ...] = ()
    """At each meeting of flows, between the first cycles of the first and the last of them."""
    switches_us: tuple[float, ...] = ()
    """From each trigger's finish to the first cycle of the next action's tasks, in the runtime's time."""
    outside: tuple[str, ...] = ()
    """Of a virtual run: the tasks, SUBSYSTEM/TASK, that had to do with the outside, so that it may not repeat."""
    steps: tuple[VariableSteps, ...] = ()
    """What the inputs of hardware tasks have stepped by where what drives them was exchanged (X04)."""
    black_box: str = ""
    """The file on the runtime's machine in which the last seconds of a run stand that ended badly; empty: none."""
    remarks: tuple[Reason, ...] = ()
    """Of a completed run: what went wrong while its tasks were being ended, after its last action."""
    run: str = ""
    """As in `Began`."""
