"""A console without a terminal: lines in, plain lines out, no control sequences (requirement A16)."""

import os
import select
import sys
from types import TracebackType

from onika.cli.language import say
from onika.cli.lines.safe_text import safe
from onika.desk.console.display import Tone
from onika.words.reason import Reason


class PlainConsole:
    """Reads standard input, which may be a file, a pipe, or a person at a terminal that can do nothing."""

    def __init__(self) -> None:
        self.is_person = sys.stdin is not None and sys.stdin.isatty()
        self._rest = b""
        self._is_over = sys.stdin is None
        self._prompted = ""

    def __enter__(self) -> "PlainConsole":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        pass

    def say(self, line: Reason, tone: Tone = Tone.PLAIN) -> None:
        """Show a line."""
        del tone
        print(safe(say(line)), flush=True)

    def line(self, prompt: str, timeout_s: float) -> str | None:
        """The next line, None while there is none yet; raises EOFError at the end of the input."""
        if self.is_person and prompt != self._prompted:
            print(prompt, end="", flush=True)
            self._prompted = prompt
        if b"\n" not in self._rest and not self._is_over:
            if not select.select([sys.stdin], [], [], timeout_s)[0]:
                return None
            data = os.read(sys.stdin.fileno(), 65536)
            self._is_over = not data
            self._rest += data
        if b"\n" not in self._rest and not (self._is_over and self._rest):
            if self._is_over:
                raise EOFError
            return None
        line, _, self._rest = self._rest.partition(b"\n")
        self._prompted = ""
        return line.decode("utf-8", "replace").rstrip("\r")

    def drop(self) -> None:
        """Nothing is typed here that could be forgotten."""
