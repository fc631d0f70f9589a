"""The watchman: a thread that ends a program in which a module has replaced code of ours, or lets nobody interrupt it.

In virtual time modules run in the runtime program itself, where nobody supervises it from outside (law 15).
"""

import os
from collections.abc import Callable
from threading import Thread
from time import sleep

from onika.host.guards.call_watchdog import CallWatchdog
from onika.host.guards.code_watch import EVERY_S, GAVE_UP, CodeWatch
from onika.words.reason import Reason

ROUNDS = 20
"""So many looks in a row may find one and the same call: twice as long as the watchdog needs to interrupt it.

What counts are looks, not time: a program that the system holds for hours is none that hangs.
"""


class Watchman:
    """Needs Python's lock to look: code in C that keeps it is beyond his reach."""

    def __init__(
        self,
        code_watch: CodeWatch,
        call_watchdog: CallWatchdog,
        leave: Callable[[Reason], None],
        end: Callable[[int], object] = os._exit,
    ) -> None:
        self._code_watch = code_watch
        self._call_watchdog = call_watchdog
        self._leave = leave
        self._end = end
        self._seen = ("", -1)
        self._rounds = 0

    def begin(self) -> None:
        """Look each second from now on, as long as the program lives."""
        Thread(target=self._walk, name="onika watchman", daemon=True).start()

    def look(self) -> None:
        """Once: is our code ours, and has the call that runs begun since?"""
        self._code_watch.look()
        seen = task, _ = self._call_watchdog.task, self._call_watchdog.calls
        self._rounds = self._rounds + 1 if task and seen == self._seen else 0
        self._seen = seen
        if self._rounds >= ROUNDS:
            self._leave(Reason.of("host.call_never_returns", task=task, seconds=ROUNDS * EVERY_S))
            self._end(GAVE_UP)

    def _walk(self) -> None:
        while True:
            sleep(EVERY_S)
            self.look()
