"""The keyboard of a terminal while a run goes on: single keys, without waiting for them (requirement E07)."""

import os
import select
import sys
import termios
from collections.abc import Iterator
from contextlib import contextmanager
from types import TracebackType
from typing import Any

from onika.cli.keys import Keys


class Keyboard:
    """Keys are neither echoed nor kept until Enter; the terminal is as it was after the `with` block.

    Where standard input is no terminal, or this program is in its background, there are no keys.
    """

    def __init__(self) -> None:
        self._input = sys.stdin.fileno() if _is_terminal() else -1
        self._keys = Keys()
        self._usual: list[Any] | None = None

    @property
    def is_there(self) -> bool:
        """Whether there is a keyboard."""
        return self._input >= 0

    def __enter__(self) -> "Keyboard":
        if self._is_ours:
            self._take()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._give_back()

    def pressed(self) -> list[str]:
        """The keys since the last call; the end of the input takes the keyboard away."""
        if not self._is_ours:
            return []
        if self._usual is None:
            self._take()  # it has come back from the background
        if not select.select([self._input], [], [], 0)[0]:
            return []
        data = os.read(self._input, 4096)
        if not data:
            self._give_back()
            self._input = -1
        return self._keys.read(data)

    @contextmanager
    def lent(self) -> Iterator[None]:
        """Within the block the terminal takes whole lines, as usual."""
        was_taken = self._usual is not None
        self._give_back()
        try:
            yield
        finally:
            if was_taken:
                self._take()

    @property
    def _is_ours(self) -> bool:
        """Whether this program is in the foreground: else to touch the terminal would put it to sleep."""
        try:
            return self._input >= 0 and os.tcgetpgrp(self._input) == os.getpgrp()
        except OSError:
            return False

    def _take(self) -> None:
        self._usual = termios.tcgetattr(self._input)
        mode = termios.tcgetattr(self._input)
        mode[3] &= ~(termios.ICANON | termios.ECHO)  # Ctrl-C stays a signal
        mode[6][termios.VSUSP] = b"\0"  # who is put aside watches over nothing
        mode[6][termios.VMIN], mode[6][termios.VTIME] = 1, 0
        termios.tcsetattr(self._input, termios.TCSADRAIN, mode)

    def _give_back(self) -> None:
        usual, self._usual = self._usual, None
        if usual is not None:
            termios.tcsetattr(self._input, termios.TCSADRAIN, usual)


def _is_terminal() -> bool:
    return sys.stdin is not None and sys.stdin.isatty()
