"""The call watchdog: in virtual time a call of module code that does not return is interrupted (law 15)."""

import signal
from types import FrameType

from onika.runtime.error import ModuleError
from onika.runtime.execution.whereabouts import Whereabouts
from onika.words.reason import Reason

PATIENCE_S = 5.0


class CallWatchdog:
    """A timer of the operating system that interrupts a call in which nothing has come back for two of its rounds.

    The clock of the run stands still meanwhile, so this changes no run whose modules return.
    """

    def __init__(self, patience_s: float = PATIENCE_S) -> None:
        self.watch = Whereabouts()
        """Is told whose code runs."""
        self._seen = ("", -1)
        self._patience_s = patience_s
        signal.signal(signal.SIGALRM, self._look)
        signal.setitimer(signal.ITIMER_REAL, patience_s, patience_s)

    @property
    def task(self) -> str:
        """Whose code runs."""
        return self.watch.task

    @property
    def calls(self) -> int:
        """How often somebody's code began or ended."""
        return self.watch.calls

    def _look(self, _signal: int, _frame: FrameType | None) -> None:
        seen = self.watch.task, self.watch.calls
        if seen[0] and seen == self._seen:
            raise ModuleError(Reason.of("host.call_has_not_returned", task=seen[0], seconds=self._patience_s))
        self._seen = seen
