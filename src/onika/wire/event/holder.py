"""Who holds what, who is there, and what comes of changes by hand (law 27)."""

from msgspec import Struct

from onika.wire.holding import SessionStanding
from onika.words.reason import NOTHING, Reason


class Edited(Struct, frozen=True, tag=True):
    """The outcome of an accepted change of a subsystem; no cause: it is done."""

    subsystem: str
    number: int
    cause: Reason
    at_s: float


class Held(Struct, frozen=True, tag=True):
    """The holder of a subsystem has changed; empty: nobody holds it."""

    subsystem: str
    holder: str
    cause: Reason = NOTHING
    """Why, where that is worth a word: it was handed over, or the holder is not heard any more."""


class Offered(Struct, frozen=True, tag=True):
    """A holder offers a subsystem to another session; with an outcome the offer is over."""

    subsystem: str
    holder: str
    to: str
    outcome: Reason = NOTHING


class Company(Struct, frozen=True, tag=True):
    """Who is there now; told to those who attend to `holding.COMPANY`."""

    sessions: tuple[SessionStanding, ...]


class Stopped(Struct, frozen=True, tag=True):
    """Everything was stopped, by whom and why; or may move again (is_stopped false)."""

    is_stopped: bool
    cause: Reason
