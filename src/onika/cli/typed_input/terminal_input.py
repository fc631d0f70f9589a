"""The keys of a terminal as prompt_toolkit reads them; Ctrl-C stays a signal, which no busy program delays (E07)."""

import os
import termios
from collections.abc import Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from typing import TextIO

from prompt_toolkit.input.posix_utils import PosixStdinReader
from prompt_toolkit.input.vt100 import Vt100Input
from prompt_toolkit.key_binding import KeyPress
from prompt_toolkit.keys import Keys


class TerminalInput(Vt100Input):
    """Gives single keys within `single_keys`, and leaves the terminal as that set it.

    A control sequence that the library does not know is nothing: no letter of it is taken for a key. What is no letter
    in the terminal's encoding is shown as �.
    """

    def __init__(self, stdin: TextIO) -> None:
        super().__init__(stdin)
        self.stdin_reader = PosixStdinReader(stdin.fileno(), errors="replace", encoding=stdin.encoding)
        self._sequence = ""
        """How the sequence began of which the last key was a part: escape, [ or O."""

    @contextmanager
    def single_keys(self) -> Iterator[None]:
        """Within the block keys come at once and are not echoed; after it the terminal is as it was."""
        usual = termios.tcgetattr(self.fileno())
        mode = termios.tcgetattr(self.fileno())
        mode[0] &= ~(termios.IXON | termios.ICRNL)
        mode[3] &= ~(termios.ICANON | termios.ECHO | termios.IEXTEN)  # Ctrl-C stays a signal
        mode[6][termios.VSUSP] = b"\0"  # who is put aside watches over nothing
        mode[6][termios.VMIN], mode[6][termios.VTIME] = 1, 0
        termios.tcsetattr(self.fileno(), termios.TCSADRAIN, mode)
        try:
            yield
        finally:
            with suppress(termios.error):  # a terminal that has hung up
                termios.tcsetattr(self.fileno(), termios.TCSADRAIN, usual)

    def raw_mode(self) -> AbstractContextManager[None]:
        """Nothing: `single_keys` holds the mode, between two lines as well."""
        return nullcontext()

    def cooked_mode(self) -> AbstractContextManager[None]:
        """Nothing, likewise."""
        return nullcontext()

    @property
    def is_in_background(self) -> bool:
        """Whether another program has the terminal: to touch it would put this one to sleep."""
        try:
            return os.tcgetpgrp(self.fileno()) != os.getpgrp()
        except OSError:
            return False  # it is not the terminal of this session, which alone puts programs to sleep

    def read_keys(self) -> list[KeyPress]:
        """The keys since the last call."""
        return list(self._pressed(super().read_keys()))

    def flush_keys(self) -> list[KeyPress]:
        """The keys that were held back because more might have followed, such as Escape alone."""
        return list(self._pressed(super().flush_keys()))

    def _pressed(self, keys: Iterable[KeyPress]) -> Iterator[KeyPress]:
        """The keys without the sequences that the library takes for Escape and letters."""
        for press in keys:
            begin, self._sequence = self._sequence, ""
            if len(press.key) > 1:
                self._sequence = "escape" if press.key == Keys.Escape else ""
                yield press
            elif begin == "escape" and press.key in "[O":
                self._sequence = press.key
                yield KeyPress(Keys.Ignore, "")  # so that the Escape is over
            elif begin == "[" and not "@" <= press.key <= "~":
                self._sequence = "["
            elif begin not in ("[", "O"):
                yield press
