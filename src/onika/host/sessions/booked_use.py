"""The robot is moved by whom it is booked for (F09): judged here, at its own runtime, whoever else may be away.

Stop is for everybody, as always. When a user's time is over and another one follows, what he drives comes to rest as
that of a holder who is lost; his run ends, or finishes its actions and pauses, as he has chosen with his booking.
"""

from collections.abc import Callable, Sequence
from typing import Protocol, get_args

from onika.booking.book import BookingBook, BookRefused
from onika.booking.slots import NO_SHOW_S, Slots
from onika.host.sessions.site_clock import SiteClock
from onika.link.caller import Role
from onika.wire import booking, event, holding, live, request, steer
from onika.words.reason import NOTHING, Reason, reason_of

EVERY_S = 1.0
"""How often it is looked whose time it is."""
TOLD_S = (600, 60)
"""So long before its end a user is told of it."""
_MOVING = (
    *(live.Change, live.Clear, live.Reinit, live.Swap, live.Set, live.Write, live.Close, live.Take, live.Reset),
    *(live.Touch, live.PutBack, live.Push, request.Begin, request.Reply),
    *(one for one in get_args(steer.Steering) if one is not steer.Pause),
)
"""What moves something, or makes that it moves."""


class Leaving(Protocol):
    """Whoever can take from a user what he holds."""

    def end_use(self, user: str, late: str, cause: Reason, now: int) -> None:
        """Everything that the sessions of a user hold."""
        ...

    def users(self) -> set[str]:
        """Those who hold something."""
        ...


class BookedUse:
    """The bookings of one robot, at the runtime that drives it."""

    def __init__(
        self,
        robot: str,
        book: BookingBook,
        clock: SiteClock,
        tell: Callable[[event.Event], None],
        *,
        is_needed: bool = False,
    ) -> None:
        self._robot = robot
        self._book = book
        self._clock = clock
        self._tell = tell
        self._is_needed = is_needed
        self._stamp = (0, 0)
        self._slots = Slots()
        self._come: set[int] = set()
        self._told: set[tuple[int, int]] = set()
        self._judged_s = 0.0

    def refusal(self, session: str, message: request.Request) -> Reason:
        """Why this session may not move the robot now; NOTHING: it may, or does not want to."""
        if not isinstance(message, _MOVING):
            return NOTHING
        self._read()
        return self._slots.refusal(user_of(session), self._clock.now_s(), is_needed=self._is_needed)

    def due_ns(self) -> int:
        """How long until `judge` has something to do."""
        return max(0, round((self._judged_s + EVERY_S - self._clock.now_s()) * 1e9))

    def judge(self, sessions: Sequence[holding.SessionStanding], leaving: Leaving, now: int) -> None:
        """Let the time pass: tell whose ends, and end it where another one follows. `now` is the runtime's time."""
        if 0.0 <= self._clock.now_s() - self._judged_s < EVERY_S:
            return
        set_by_s = self._clock.look(is_kept=self._slots.current(self._clock.now_s()) is not None)
        if set_by_s:
            self._tell(event.ClockSet(set_by_s))
        now_s = self._judged_s = self._clock.now_s()
        self._read()
        self._note_who_came(sessions, now_s)
        self._announce(now_s)
        current = self._slots.current(now_s) or self._slots.coming(now_s)
        if current is None:
            return
        for user in sorted(leaving.users()):
            if user != current.user or self._slots.coming(now_s) is not None:
                cause = Reason.of("booking.over", user=user, follower=current.user)
                leaving.end_use(user, self._late(user), cause, now)
                self._tell(event.SlotEnds(user, 0.0, current.user))

    def answer(self, session: str, role: Role, message: booking.BookingRequest) -> request.Response:
        """Book, or say what is booked."""
        user, now_s = user_of(session), self._clock.now_s()
        try:
            match message:
                case booking.Book():
                    wanted = booking.Booking(0, user, message.begin_s, message.end_s, message.late, message.note)
                    return booking.Booked(self._book.book(self._robot, wanted, now_s))
                case booking.ExtendBooking():
                    return booking.Booked(self._book.extend(self._robot, message.number, message.end_s, user, now_s))
                case booking.CancelBooking():
                    self._book.cancel(self._robot, message.number, user, now_s, is_owner=role is Role.OWNER)
                    return request.Done()
                case booking.Bookings():
                    known = self._book.bookings(self._robot, now_s)
                    return booking.BookingList(self._robot, now_s, user, known, self._is_needed)
        except BookRefused as refused:
            return request.Refused(refused.reason)
        except OSError as wrong:
            return request.Refused(reason_of(wrong))

    # Inner

    def _read(self) -> None:
        """What is booked, where somebody has written since; where the book cannot be read, what was known holds on."""
        try:
            stamp = self._book.stamp()
            if stamp == self._stamp:
                return
            bookings = self._book.bookings(self._robot, self._clock.now_s() - EVERY_S)
        except OSError:
            return
        self._stamp = stamp
        self._slots = Slots(bookings, self._slots.given_away)

    def _note_who_came(self, sessions: Sequence[holding.SessionStanding], now_s: float) -> None:
        """Who does not come has given his time away."""
        current = self._slots.current(now_s)
        if current is None or current.number in self._come:
            return
        if any(user_of(standing.name) == current.user and standing.is_here for standing in sessions):
            self._come.add(current.number)
        elif now_s >= current.begin_s + NO_SHOW_S:
            self._slots = Slots(self._slots.bookings, self._slots.given_away | {current.number})

    def _announce(self, now_s: float) -> None:
        current = self._slots.current(now_s)
        follower = None if current is None else self._slots.follower(current)
        if current is None or follower is None:
            return
        left_s = self._slots.ends_s(current) - now_s
        due = [before for before in TOLD_S if left_s <= before and (current.number, before) not in self._told]
        if due:
            self._told |= {(current.number, before) for before in due}
            self._tell(event.SlotEnds(current.user, left_s, follower.user))

    def _late(self, user: str) -> str:
        """What is to become of a run of this user that is late."""
        own = [one for one in self._slots.bookings if one.user == user and one.begin_s <= self._clock.now_s()]
        return own[-1].late if own else "stop"


def user_of(session: str) -> str:
    """Whose session it is."""
    return session.partition("#")[0]
