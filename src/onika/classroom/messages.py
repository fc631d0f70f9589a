"""What a class and the process of a seat tell each other, as lines of JSON (requirement X25)."""

import msgspec
from msgspec import Struct

from onika.wire.view import ClassSeatView
from onika.words.reason import NOTHING, Reason

LONGEST = 64 * 1024
"""Bytes of a line."""


class SeatOrder(Struct, frozen=True, tag_field="t", tag=True, omit_defaults=True):
    """From the class to a seat."""


class Admit(SeatOrder, frozen=True):
    """Whoever comes with this key is let in, once."""

    key: str
    is_teacher: bool = False


class ShutOut(SeatOrder, frozen=True):
    """Whoever came in as the learner has to go: the seat is another browser's from now on."""


class ShowSeat(SeatOrder, frozen=True):
    """The seat stands so from now on."""

    seat: ClassSeatView


class Collect(SeatOrder, frozen=True):
    """Hand in what there is."""


class LeaveClass(SeatOrder, frozen=True):
    """End, and keep what is not saved."""


class News(Struct, frozen=True, tag_field="t", tag=True, omit_defaults=True):
    """From a seat to its class."""


class Opened(News, frozen=True):
    """The page is served."""


class SeatStanding(News, frozen=True):
    """How its learner gets on; all ages in seconds.

    steps        acts that changed something since the process began
    idle_s       since the last step forward: such an act, or an action that was done
    run          `starting` while its runtime does, `running`, `stopped`, `completed`, `aborted`; empty: nothing was run
    done, of     actions of that run
    course       of the help, where its learner is in one; empty: in none
    lessons, lessons_of  how many of its lessons are done
    """

    pages: int = 0
    teachers: int = 0
    program: str = ""
    icons: int = 0
    steps: int = 0
    idle_s: float = 0.0
    run: str = ""
    done: int = 0
    of: int = 0
    why: Reason = NOTHING
    refusal: Reason = NOTHING
    refusal_s: float = 0.0
    course: str = ""
    lessons: int = 0
    lessons_of: int = 0


class HandedIn(News, frozen=True):
    """A folder below that of the seat holds what is handed in; empty: it could not be, and why."""

    folder: str = ""
    why: Reason = NOTHING


_ORDERS = msgspec.json.Decoder(Admit | ShutOut | ShowSeat | Collect | LeaveClass)
_NEWS = msgspec.json.Decoder(Opened | SeatStanding | HandedIn)
_ENCODER = msgspec.json.Encoder()


def line(message: SeatOrder | News) -> bytes:
    """A message as a line."""
    return _ENCODER.encode(message) + b"\n"


def order(text: bytes) -> SeatOrder:
    """An order of a line; raises ValueError for anything else."""
    read: SeatOrder = _ORDERS.decode(text)
    return read


def news(text: bytes) -> News:
    """News of a line; raises ValueError for anything else: a seat is believed nothing that is not of this form."""
    read: News = _NEWS.decode(text)
    return read
