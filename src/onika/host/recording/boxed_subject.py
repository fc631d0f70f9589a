"""What a black box is of: a run of an application, or a subsystem that is held by hand (requirement X05)."""

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple, Protocol

from onika.wire import event
from onika.words.reason import Reason

_TRIPPED = ("TRIPPED", "PRESSED")
_HARMLESS = ("asking", "user")
"""Kinds of standstills in which nothing has gone wrong."""


class Incident(NamedTuple):
    """Something that has gone wrong in what goes on: in which subsystem, why, and when in seconds of its events."""

    subsystem: str
    cause: Reason
    at_s: float


class BoxedSubject(Protocol):
    """Whatever has its last seconds held."""

    @property
    def application(self) -> str:
        """What its files are called by."""
        ...

    @property
    def names(self) -> tuple[str, ...]:
        """Its subsystems."""
        ...

    @property
    def variable_units(self) -> Mapping[str, Mapping[str, str]]:
        """By subsystem, the units of its variables by name."""
        ...

    @property
    def is_ended_at_wish(self) -> bool:
        """Whether it ends because somebody who may end it has said so."""
        ...

    def warn(self, text: Reason, at_s: float) -> None:
        """Tell whoever watches what is worth knowing of it as a whole."""
        ...

    def name_black_box(self, subsystem: str, at_s: float, path: Path) -> None:
        """Tell where the last seconds before an incident stand, by its subsystem and its time."""
        ...


def incident_of(message: event.Event) -> Incident | None:
    """The standstill of a run, if something has gone wrong with it and somebody is to choose how to go on."""
    if isinstance(message, event.Explained) and message.choices and is_fault(message):
        return Incident(message.subsystem, message.text, message.at_s)
    return None


def is_fault(message: event.Event) -> bool:
    """Whether a run that has known this ends badly whoever ends it."""
    match message:
        case event.Failed() | event.Lost():
            return True
        case event.Stopped():
            return message.is_stopped
        case event.Explained():
            return message.kind not in _HARMLESS
        case event.Drive():
            return message.state in _TRIPPED
    return False


def standing_of(message: event.Event) -> str:
    """What an event says something about that holds until another one says otherwise; empty: it passes."""
    match message:
        case event.TaskState():
            return f"task {message.subsystem}/{message.task}"
        case event.Moved():
            return f"flow {message.subsystem}"
        case event.Began() | event.Done():
            return f"action {message.flow}"
        case event.Drive():
            return f"drive {message.device}"
        case event.Failed():
            return f"failure {message.subsystem}/{message.task}"
        case event.Lost():
            return f"loss {message.name}"
    return ""
