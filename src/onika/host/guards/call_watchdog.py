"""The call watchdog: in virtual time a call of module code that does not return is interrupted (law 15)."""

import signal
from types import FrameType

from onika.runtime.error import ModuleError
from onika.words.reason import Reason

PATIENCE_S = 5.0


class CallWatchdog:
    """A timer of the operating system that interrupts a call in which nothing has come back for two of its rounds.

    The clock of the run stands still meanwhile, so this changes no run whose modules return.
    """

    def __init__(self, patience_s: float = PATIENCE_S) -> None:
        self.task = ""
        """Whose code runs."""
        self.calls = 0
        """How often somebody's code began or ended."""
        self._seen = -1
        self._patience_s = patience_s
        signal.signal(signal.SIGALRM, self._look)
        signal.setitimer(signal.ITIMER_REAL, patience_s, patience_s)

    def watch(self, task: str) -> None:
        """Whose code runs from now on; "" for the executive's own."""
        self.task = task
        self.calls += 1

    def _look(self, _signal: int, _frame: FrameType | None) -> None:
        if self.task and self.calls == self._seen:
            reason = Reason.of("host.call_has_not_returned", task=self.task, seconds=self._patience_s)
            raise ModuleError(reason)
        self._seen = self.calls
