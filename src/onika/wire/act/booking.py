"""What a user does about the times for which robots are booked (requirement F09). Times are seconds of UTC since 1970.

Whom a time belongs to is judged by the robot's own runtime, at the station that is named; empty: the first one.
"""

from onika.wire.act.act import Act


class LookAtBookings(Act, frozen=True):
    """Ask anew what is booked there; it is shown with the runtime."""

    station: str = ""


class BookRobot(Act, frozen=True):
    """Book the robot for oneself.

    begin_s   0: from now on
    length_s  rounded up to the next step at which a booking may end
    late      what becomes of a run that is late: `stop`, or `finish` its actions and pause
    """

    length_s: int
    begin_s: int = 0
    late: str = "stop"
    note: str = ""
    station: str = ""


class ProlongBooking(Act, frozen=True):
    """Let a booking of one's own end at another time."""

    number: int
    end_s: int
    station: str = ""


class TakeBackBooking(Act, frozen=True):
    """Give a time back; the owner may take back everybody's."""

    number: int
    station: str = ""
