"""What tasks come to, ask for and signal; times are seconds since the start in the runtime's own time."""

from typing import Any

from msgspec import Struct

from onika.words.reason import Reason


class TaskState(Struct, frozen=True, tag=True):
    """A task's state has changed."""

    subsystem: str
    task: str
    state: str
    at_s: float


class Warned(Struct, frozen=True, tag=True):
    """A warning of a task, or something worth knowing about the run (task empty)."""

    subsystem: str
    task: str
    text: Reason
    at_s: float


class Failed(Struct, frozen=True, tag=True):
    """A task is in ERROR: what its code said and where."""

    subsystem: str
    task: str
    text: Reason
    path: str
    line: int
    traceback: str
    at_s: float
    entry: str = ""
    """The entry point that failed."""
    values: dict[str, Any] = {}
    """The task's ports at that moment, arrays as lists (A18)."""


class Signalled(Struct, frozen=True, tag=True):
    """An ILLEGAL, LEGAL, SHUTDOWN, FINISH or user signal of a task that no application answers (Table 9)."""

    subsystem: str
    task: str
    kind: str
    number: int
    text: Reason
    at_s: float
