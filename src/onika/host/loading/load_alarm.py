"""The load alarm interrupts module code that does not return while it is loaded to be looked at (law 21)."""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from onika.runtime.error import ModuleError
from onika.words.reason import Reason

PATIENCE_S = 2.0
"""So long the code of a module may take by itself; what it imports may take longer."""


class LoadAlarm:
    """A timer of the operating system, in the loader's process. Code in C that does not return is not interrupted."""

    def __init__(self, patience_s: float = PATIENCE_S) -> None:
        self._patience_s = patience_s
        self._is_loading = False
        signal.signal(signal.SIGALRM, self._ring)

    @contextmanager
    def watch(self) -> Iterator[None]:
        """Within it module code is loaded; raises ModuleError there when it takes too long."""
        self._is_loading = True
        signal.setitimer(signal.ITIMER_REAL, self._patience_s, self._patience_s)
        try:
            yield
        finally:
            self._is_loading = False
            signal.setitimer(signal.ITIMER_REAL, 0.0)

    def _ring(self, _signal: int, frame: FrameType | None) -> None:
        if self._is_loading and not _is_importing(frame):
            raise ModuleError(Reason.of("host.loading_takes_long", seconds=self._patience_s))


def _is_importing(frame: FrameType | None) -> bool:
    """Whether a library is imported just now, which may take long where the disk is slow."""
    importer = vars(sys.modules["_frozen_importlib"])
    while frame is not None:
        if frame.f_globals is importer:
            return True
        frame = frame.f_back
    return False
