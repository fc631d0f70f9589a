"""Handles Ctrl-C during a run: the first is noted, so that no event on its way is lost; the second ends everything."""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType, TracebackType
from typing import Any


class Interruption:
    """Within the `with` block the first Ctrl-C is only noted, each further one is a KeyboardInterrupt.

    Outside the main thread, where Python gives no signals, nothing is ever noted.
    """

    def __init__(self) -> None:
        self._count = 0
        self._told = 0
        self._is_open = False
        self._former: Any = None

    def __enter__(self) -> "Interruption":
        if threading.current_thread() is threading.main_thread():
            self._former = signal.signal(signal.SIGINT, self._heard)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._former is not None:
            signal.signal(signal.SIGINT, self._former)

    def is_new(self) -> bool:
        """Whether there was a Ctrl-C since the last call."""
        earlier, self._told = self._told, self._count
        return self._count > earlier

    @contextmanager
    def at_once(self) -> Iterator[None]:
        """Within this block the first one is a KeyboardInterrupt too: somebody is asked and would have to answer."""
        self._is_open = True
        try:
            yield
        except KeyboardInterrupt:
            if self._count > 1:
                raise
        finally:
            self._is_open = False

    def _heard(self, _signal: int, _frame: FrameType | None) -> None:
        self._count += 1
        if self._count > 1 or self._is_open:
            raise KeyboardInterrupt
