"""What a user does about who may move the robots (X12, law 27): of a document, or of a subsystem by its name.

A subsystem that is named, and whatever is about a whole runtime, is that of `station`; empty: of the first one.
"""

from typing import Literal

from onika.wire.act.act import Act


class Take(Act, frozen=True):
    """Become the holder of a subsystem: of one that nobody holds, or that is offered here.

    Of a run that is nobody's all flows are taken, which is asked back first: it was begun by somebody else.
    """

    doc: str = ""
    """The document that is connected with it; empty: it is named."""
    subsystem: str = ""
    station: str = ""
    confirmed: bool = False


class Release(Act, frozen=True):
    """Let another become the holder."""

    doc: str = ""
    subsystem: str = ""
    station: str = ""


class Hand(Act, frozen=True):
    """Offer a subsystem to another session, which takes it or not; to nobody: offer it no more."""

    doc: str = ""
    to: str = ""
    subsystem: str = ""
    station: str = ""


class Decline(Act, frozen=True):
    """Say no to what is offered; a yes is Take."""

    doc: str = ""
    subsystem: str = ""
    station: str = ""


class OnlyWatch(Act, frozen=True):
    """From now on this environment changes nothing in the runtime that it is connected with; stopping stays."""

    station: str = ""


class WatchNoMore(Act, frozen=True):
    """Come anew, as somebody who may change something: the promise only to watch lasts as long as the session."""

    station: str = ""


class Company(Act, frozen=True):
    """Ask the runtime anew who is there, who holds what, and where the flows of applications are."""

    station: str = ""


class SteerTaken(Act, frozen=True):
    """Steer the run of an application that another began and that is held here now; what moves is asked back first."""

    subsystem: str
    """One of its flows; all of them are meant."""
    wish: Literal["pause", "resume", "clear", "abort"]
    confirmed: bool = False
    station: str = ""
