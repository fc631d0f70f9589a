"""The keyboard of a terminal while a run goes on: single keys, without waiting for them (requirement E07)."""

import sys
from contextlib import ExitStack
from types import TracebackType

from prompt_toolkit.keys import Keys

from onika.cli.typed_input.terminal_input import TerminalInput


class Keyboard:
    """Keys are neither echoed nor kept until Enter; the terminal is as it was after the `with` block.

    Where standard input is no terminal, or this program is in its background, there are no keys.
    """

    def __init__(self) -> None:
        is_terminal = sys.stdin is not None and sys.stdin.isatty()
        self._input = TerminalInput(sys.stdin) if is_terminal else None
        self._is_taken = False
        self._mode = ExitStack()

    @property
    def is_there(self) -> bool:
        """Whether there is a keyboard."""
        return self._input is not None

    @property
    def is_in_background(self) -> bool:
        """Whether another program has the keyboard now."""
        return self._input is not None and self._input.is_in_background

    def __enter__(self) -> "Keyboard":
        self._take()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._mode.close()

    def pressed(self) -> list[str]:
        """The keys since the last call; the end of the input takes the keyboard away."""
        self._take()
        if self._input is None or self._input.is_in_background:
            return []
        presses = iter(self._input.read_keys() or self._input.flush_keys())
        if self._input.closed:
            self._mode.close()
            self._input = None
        keys: list[str] = []
        for press in presses:
            if press.key == Keys.Escape:
                next(presses, None)  # a letter with Alt is another key
            else:
                keys.append(press.key)
        return keys

    def _take(self) -> None:
        """Have single keys, unless that is so already; again and again, as a program comes back from the background."""
        if self._input is not None and not self._is_taken and not self._input.is_in_background:
            self._mode.enter_context(self._input.single_keys())
            self._is_taken = True
