"""What is asked of the virtual clock: to let time pass, or to begin again at 0 with everything new (X08, X23)."""

from onika.host.driver import Driver
from onika.host.renewal import Renewal, refusal
from onika.host.sessions.request_backlog import Answer, Backlog
from onika.host.sessions.request_server import RequestServer, SessionRequest
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.wire import live, request
from onika.words.reason import Reason

_LONGEST_S = 1e6


class ClockRequests:
    """Answers them; `renewal` is what a new program is to begin with, in place of this one."""

    def __init__(self, subsystems: Subsystems, driver: Driver, server: RequestServer, backlog: Backlog) -> None:
        self._subsystems = subsystems
        self._driver = driver
        self._server = server
        self._backlog = backlog
        self.renewal: Renewal | None = None

    def ask(self, call: SessionRequest, message: live.Advance | live.Renew, answer: Answer) -> None:
        """Carry it out, or refuse it."""
        if isinstance(message, live.Advance):
            self._advance(message, answer)
        else:
            self._renew(call, message, answer)

    def _advance(self, message: live.Advance, answer: Answer) -> None:
        """Answered when the time has passed."""
        seconds = message.seconds
        if not self._driver.is_virtual:
            answer(request.Refused(Reason.of("host.wall_passes")))
        elif not 0 <= seconds <= _LONGEST_S:
            answer(request.Refused(Reason.of("host.advance_range", seconds=seconds)))
        elif round(seconds * 1e9) == 0:  # the clock need not move, and perhaps does not
            answer(request.Done())
        else:
            until_ns = self._driver.now + round(seconds * 1e9)
            self._subsystems.when(until_ns, lambda: answer(request.Done()))

    def _renew(self, call: SessionRequest, message: live.Renew, answer: Answer) -> None:
        """Answered by the program that is new then, but where something speaks against it."""
        why_not = refusal(
            call.session,
            self._subsystems,
            self._server.sessions(),
            is_virtual=self._driver.is_virtual,
            is_waiting=self._backlog.is_waiting,
        )
        if why_not:
            answer(request.Refused(why_not))
        else:
            self.renewal = Renewal(call, message)
