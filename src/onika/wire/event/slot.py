"""What is told about the times for which a robot is booked (F09)."""

from msgspec import Struct


class SlotEnds(Struct, frozen=True, tag=True):
    """A user's time ends in `left_s` seconds, and another one follows; 0: it is over."""

    user: str
    left_s: float
    follower: str


class ClockSet(Struct, frozen=True, tag=True):
    """The clock of the runtime's machine was set by so many seconds; the time that somebody has booked goes on by the
    old one.
    """

    by_s: float
