"""Who may move a robot at a moment, by what is booked. No I/O, no clock."""

from collections.abc import Sequence
from dataclasses import dataclass

from onika.wire.booking import Booking
from onika.words.reason import NOTHING, Reason
from onika.words.utc import utc

CHANGE_S = 60
"""Before another user's time the robot is left alone for so long: it is parked, and people change places."""
NO_SHOW_S = 600
"""Who has not come so long after the begin of his time has given it away."""


@dataclass(frozen=True, slots=True)
class Slots:
    """The bookings of booking robot, none of which overlap; those that were given away count no more."""

    bookings: Sequence[Booking] = ()
    given_away: frozenset[int] = frozenset()

    def current(self, now_s: float) -> Booking | None:
        """Whose time it is, up to the pause before another user's."""
        return next((booking for booking in self._valid() if booking.begin_s <= now_s < self.ends_s(booking)), None)

    def coming(self, now_s: float) -> Booking | None:
        """Who comes next, while the robot is left alone for him already."""
        ending = (booking for booking in self._valid() if self.ends_s(booking) <= now_s < booking.end_s)
        return next(filter(None, map(self.follower, ending)), None)

    def follower(self, booking: Booking) -> Booking | None:
        """The booking of another user for the time directly behind this one."""
        behind = (other for other in self._valid() if booking.end_s <= other.begin_s < booking.end_s + CHANGE_S)
        return next((other for other in behind if other.user != booking.user), None)

    def next_after(self, now_s: float) -> Booking | None:
        """The first one that begins later."""
        return next((booking for booking in self._valid() if booking.begin_s > now_s), None)

    def ends_s(self, booking: Booking) -> int:
        """When a user has to be done."""
        return booking.end_s if self.follower(booking) is None else booking.end_s - CHANGE_S

    def refusal(self, user: str, now_s: float, *, is_needed: bool) -> Reason:
        """Why this user may not move the robot now; NOTHING: he may."""
        current = self.current(now_s)
        if current is not None:
            if current.user == user:
                return NOTHING
            return Reason.of("booking.is_anothers", user=current.user, until=utc(current.end_s))
        coming = self.coming(now_s)
        if coming is not None:
            return Reason.of("booking.comes", user=coming.user, begin=utc(coming.begin_s))
        return Reason.of("booking.needed") if is_needed else NOTHING

    def _valid(self) -> list[Booking]:
        valid = [booking for booking in self.bookings if booking.number not in self.given_away]
        return sorted(valid, key=lambda booking: booking.begin_s)
