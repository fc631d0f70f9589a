"""What is asked about the times for which a robot is booked (requirement F09). Times are seconds of UTC since 1970."""

from math import ceil

from msgspec import Struct

STEP_S = 300
"""Bookings begin and end at such steps, but for one that begins now."""


class Booking(Struct, frozen=True):
    """A robot belongs to a user from `begin_s` up to, not including, `end_s`, as the clock of its own site goes.

    late    what becomes of a run of the user's that is still going when another user's time begins: `finish` its
            current actions and pause, or `stop`
    """

    number: int
    user: str
    begin_s: int
    end_s: int
    late: str = "stop"
    note: str = ""


class Book(Struct, frozen=True, tag=True):
    """Book the robot for oneself; replied by Booked, or Refused."""

    begin_s: int
    end_s: int
    late: str = "stop"
    note: str = ""


class ExtendBooking(Struct, frozen=True, tag=True):
    """Let a booking of one's own end later, or sooner; replied by Booked, or Refused."""

    number: int
    end_s: int


class CancelBooking(Struct, frozen=True, tag=True):
    """Take back a booking of one's own; the owner may take back everybody's. Replied by Done, or Refused."""

    number: int


class Bookings(Struct, frozen=True, tag=True):
    """Ask for what is booked from now on; replied by BookingList."""


class Booked(Struct, frozen=True, tag=True):
    """It is booked."""

    booking: Booking


class BookingList(Struct, frozen=True, tag=True):
    """What is booked, earliest first, and what the time is there: whoever reads it has a clock of his own.

    you         the user who asks
    is_needed   whether only who has booked may move the robot
    """

    robot: str
    now_s: float
    you: str
    bookings: tuple[Booking, ...] = ()
    is_needed: bool = False


def step_after(at_s: float) -> int:
    """The first step that is not before a time."""
    return ceil(at_s / STEP_S) * STEP_S


BookingRequest = Book | ExtendBooking | CancelBooking | Bookings
BookingResponse = Booked | BookingList
