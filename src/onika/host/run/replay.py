"""The repetition of a run: what was asked in it once is asked again at the same instants of virtual time (law 29).

As the clock of virtual time has nothing to do with that of the wall, and stands while anything is asked, the same
requests at the same instants make the same run, bit for bit.
"""

from collections import deque
from collections.abc import Collection

from onika.wire import request, steer
from onika.words.reason import NOTHING, Reason

_STEERING = (
    request.Reply,
    steer.Pause,
    steer.Resume,
    steer.Step,
    steer.Skip,
    steer.Pass,
    steer.Leave,
    steer.Mark,
    steer.Recover,
)


class Replay:
    """At most one run is repeated at a time; others may go on beside it.

    `now` is the runtime's time, `turn` the driver's count at that instant.
    """

    def __init__(self) -> None:
        self.session = ""
        """Who began the run; empty: none is repeated."""
        self._subsystems: frozenset[str] = frozenset()
        """Those of its flows."""
        self._left: deque[request.Recorded] = deque()
        self._began = 0
        self._until = 0
        self._is_answer = False

    def objection(self, begin_request: request.Begin, now: int) -> Reason:
        """Why a run may not begin so: two cannot be repeated at once, as each has the clock go its own way."""
        if _is_wanted(begin_request) and self.is_on(now):
            return Reason.of("host.repeats_another")
        return NOTHING

    def begin(self, session: str, begin_request: request.Begin, now: int, subsystems: Collection[str]) -> None:
        """A run begins in these subsystems, to be repeated as far as it says; one that is not leaves another alone."""
        if not _is_wanted(begin_request):
            return
        self.session, self._subsystems = session, frozenset(subsystems)
        self._left = deque(begin_request.repeat)
        self._began, self._until = now, begin_request.repeat_until_ns
        self._look_ahead()

    def end(self, subsystems: Collection[str]) -> None:
        """The run of these subsystems is over."""
        if not self._subsystems.isdisjoint(subsystems):
            self._forget()

    def lost(self, session: str) -> None:
        """A session is gone: nothing is repeated in its name."""
        if session == self.session:
            self._forget()

    def _forget(self) -> None:
        self.session, self._subsystems = "", frozenset()
        self._left.clear()

    def is_on(self, now: int) -> bool:
        """Whether it is still being repeated."""
        if not self.session:
            return False
        return bool(self._left) or self._until < 0 or now - self._began < self._until

    def is_due(self, now: int, turn: int, is_asking: bool) -> bool:
        """Whether the next request is due.

        While a task asks the clock stands, so that whatever comes next comes now; an answer waits for its question.
        """
        if not self._left:
            return False
        recorded, at = self._left[0], now - self._began
        if self._is_answer:
            return is_asking or at > recorded.at_ns
        return is_asking or (at, turn) >= (recorded.at_ns, recorded.turn)

    def take(self, now: int, turn: int, is_asking: bool) -> request.Request | None:
        """The next request, if it is due."""
        if not self.is_due(now, turn, is_asking):
            return None
        message: request.Request = request.decode_request(self._left.popleft().body)
        self._look_ahead()
        return message

    def _look_ahead(self) -> None:
        self._is_answer = bool(self._left) and isinstance(request.decode_request(self._left[0].body), request.Reply)

    def wake_at(self, now: int) -> int | None:
        """The next instant after this one up to which the clock goes on by itself."""
        if not self.session:
            return None
        at = self._began + (self._left[0].at_ns if self._left else self._until)
        return at if at > now else None

    def refusal(self, session: str, message: request.Request, now: int) -> Reason:
        """Why this may not be asked meanwhile; empty: it may. The run of other subsystems is steered as ever."""
        if not isinstance(message, _STEERING) or not self.is_on(now):
            return NOTHING
        if message.subsystem and message.subsystem not in self._subsystems:
            return NOTHING
        return Reason.of("host.is_repeated")


def _is_wanted(begin_request: request.Begin) -> bool:
    """Whether a run is to repeat one that was recorded."""
    return bool(begin_request.repeat) or begin_request.repeat_until_ns != 0
