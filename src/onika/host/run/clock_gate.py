"""The hold: a run whose virtual clock goes on only while the one who began it lets it (requirement E07, law 15).

Whoever steers by a script, or from a program, hears what happens too late to act at that instant: the clock of virtual
time has gone on meanwhile. Therefore such a run stands still after everything that steering may wait for, and at
times that were asked for; then it says `Stood`. What is asked of it meanwhile is carried out before anything moves
again. So the same words lead to the same run, bit for bit.
"""

from collections.abc import Callable

from onika.wire import event, request, steer
from onika.words.reason import Reason

Tell = Callable[[event.Event, str, str], None]

_TELLING = (event.Began, event.Done, event.Failed, event.Asked, event.Moved, event.Met, event.Explained)
"""What steering may wait for."""


class ClockGate:
    """At most one run is held at a time; where none is, the clock goes on."""

    def __init__(self, tell: Tell) -> None:
        self._tell = tell
        self._session = ""
        self._subsystem = ""
        self._began = 0
        self._until: int | None = None
        self._is_let = False
        self._has_news = False

    def begin(self, session: str, subsystem: str, now: int) -> Tell:
        """Hold the run that this session begins now; what it tells is to be told through the function given back."""
        self._session, self._subsystem, self._began = session, subsystem, now
        self._is_let, self._has_news, self._until = False, False, None
        return self._told

    def onward(self, session: str, command: steer.Onward) -> request.Response:
        """Let the clock go on, to the next thing that happens or to a time."""
        if not self._session or session != self._session:
            return request.Refused(Reason.of("host.not_held"))
        self._is_let = True
        self._until = None if command.until_s is None else self._began + round(command.until_s * 1e9)
        return request.Done()

    def release(self, session: str | None = None) -> None:
        """The run is over, or the session that held it is lost: nobody holds the clock."""
        if session in (None, self._session):
            self._session, self._until = "", None

    def stands(self, now: int) -> bool:
        """Whether the clock stands still."""
        if not self._session:
            return False
        return not self._is_let or self._has_news or (self._until is not None and now >= self._until)

    def wake_at(self) -> int | None:
        """The time up to which it was let go on."""
        if self._session and self._is_let:
            return self._until
        return None

    def say(self, now: int) -> None:
        """Say that it stands, once everything has been carried out that was asked."""
        if self._session and self._is_let and self.stands(now):
            self._is_let = self._has_news = False
            self._until = None
            self._tell(event.Stood(round((now - self._began) * 1e-9, 9)), self._subsystem, self._session)

    def _told(self, message: event.Event, subsystem: str, session: str) -> None:
        self._has_news = self._has_news or isinstance(message, _TELLING)
        self._tell(message, subsystem, session)
