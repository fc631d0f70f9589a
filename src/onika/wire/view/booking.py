"""The times for which the robot of a runtime is booked, as a page shows them (F09). Seconds of UTC since 1970."""

from onika.wire.view.view import View


class BookingView(View, frozen=True):
    """A robot belongs to a user from a begin up to, not including, an end."""

    number: int
    user: str
    begin_s: int
    end_s: int
    late: str = "stop"
    """What becomes of a run of the user's that is late: `stop`, or `finish`."""
    note: str = ""


class BookView(View, frozen=True):
    """What is booked of a robot, earliest first; whose clock counts is that of the robot's own site."""

    robot: str
    you: str
    """The user whom that site knows this environment as."""
    now_s: float
    """What the time was there when it was asked."""
    asked_s: float
    """The same moment by the clock of this environment."""
    is_needed: bool = False
    """Whether only who has booked may move the robot."""
    bookings: tuple[BookingView, ...] = ()


class SlotEndView(View, frozen=True):
    """A user's time ends, and another one follows."""

    user: str
    follower: str
    at_s: float
    """When, by the clock of this environment."""
