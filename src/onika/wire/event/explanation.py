"""Why something stands still: the chain of causes, what can be done, the seconds before (X06)."""

from typing import Any

from msgspec import Struct

from onika.words.reason import Reason


class Course(Struct, frozen=True):
    """The last seconds of one variable, oldest first."""

    variable: str
    unit: str
    at_s: tuple[float, ...]
    values: tuple[Any, ...]


class Explained(Struct, frozen=True, tag=True):
    """Why a flow stands still or the run ends: the chain from the task to whoever waits, and what can be done (X06)."""

    subsystem: str
    task: str
    """Empty where no task is the cause."""
    action: str
    index: int
    place: str
    """The application's file and line."""
    text: Reason
    path: str
    """The module's file and line, where its code raised; else empty and 0."""
    line: int
    waiting: tuple[tuple[str, str], ...]
    """The flows that wait for this one, each with its tag."""
    courses: tuple[Course, ...]
    choices: tuple[tuple[str, Reason], ...]
    """What can be done safely: the command, and what it does."""
    at_s: float
    kind: str = ""
    """What sort of cause it is: a word of `host.diagnosis.stop_cause.Kind`."""
    suspect: str = ""
    """The task upstream from which the trouble likely comes; empty: from nobody else."""
    run: str = ""
    """As in `Began`."""


class LastSecondsKept(Struct, frozen=True, tag=True):
    """The last seconds before what an `Explained` of a run that goes on has told are written (X05)."""

    subsystem: str
    at_s: float
    """Both as in that `Explained`."""
    path: str
    """The file on the runtime's machine."""
    run: str = ""
    """As in `Began`."""
