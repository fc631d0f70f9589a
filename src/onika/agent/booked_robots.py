"""What is booked at a site, read from its book; whoever may book asks the robot's own runtime (requirement F09)."""

from collections.abc import Sequence

from onika.booking.book import BookingBook
from onika.host.sessions.site_clock import SiteClock
from onika.wire.booking import Booking


class BookedRobots:
    """The bookings of all robots of a site."""

    def __init__(self, book: BookingBook, clock: SiteClock) -> None:
        self._book = book
        self._clock = clock

    def now_s(self) -> float:
        """The time here, in seconds of UTC since 1970."""
        self._clock.look(is_kept=False)
        return self._clock.now_s()

    def of(self, robot: str) -> Sequence[Booking]:
        """Those of a robot that are not over; none where the book cannot be read now."""
        try:
            return self._book.bookings(robot, self.now_s())
        except OSError:
            return ()
