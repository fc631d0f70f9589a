"""The code watch: each second a process looks at its own code, and ends itself where a module has replaced it (law 30).

It does so from the handler of a signal, for the loop itself may be what was replaced; and from the loop, where a module
has taken the signal away. Where both are gone, whoever supervises the process finds that nobody has looked.
"""

import os
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic_ns
from types import FrameType

from onika.host.guards.code_guard import CodeGuard, Replaced
from onika.words.reason import Reason

GAVE_UP = 70
"""The code with which a process ends itself that cannot rely on its own code any more."""

EVERY_S = 1.0
_DUE_NS = 2_000_000_000


class CodeWatch:
    """`leave` is told why the process ends, `note` that all was well."""

    def __init__(
        self,
        guard: CodeGuard,
        leave: Callable[[Reason], None],
        note: Callable[[], None] = lambda: None,
        end: Callable[[int], object] = os._exit,
    ) -> None:
        self._guard = guard
        self._leave = leave
        self._note = note
        self._end = end
        self._looked_ns = monotonic_ns()

    def begin(self) -> None:
        """Look each second from now on, in this thread, which is the first one of the process."""
        self._note()
        signal.signal(signal.SIGALRM, self._ring)
        signal.siginterrupt(signal.SIGALRM, False)
        signal.setitimer(signal.ITIMER_REAL, EVERY_S, EVERY_S)

    def look_if_due(self) -> None:
        """Look where the signal has not come for two seconds."""
        if monotonic_ns() - self._looked_ns > _DUE_NS:
            self.look()

    def look(self) -> None:
        """Look now; where something was replaced, say it and end at once: nothing here can be relied on."""
        replaced = self._guard.replaced()
        if replaced is not None:
            self._leave(_sentence(replaced))
            self._end(GAVE_UP)
        self._looked_ns = monotonic_ns()
        self._note()

    @contextmanager
    def blaming(self) -> Iterator[None]:
        """Where a fault ends what is within, it is said at once if code of ours was replaced: that is its cause."""
        try:
            yield
        except Exception:
            self.look()
            raise

    def _ring(self, _signal: int, _frame: FrameType | None) -> None:
        self.look()


def _sentence(replaced: Replaced) -> Reason:
    if replaced.module:
        return Reason.of("host.code_replaced", module=replaced.module, what=replaced.what)
    return Reason.of("host.code_replaced_by_somebody", what=replaced.what)
