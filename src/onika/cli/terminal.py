"""A console on a terminal: a line is typed at the bottom while what is told goes by above it (requirement A16)."""

import os
import select
import sys
import termios
from collections import deque
from collections.abc import Callable
from pathlib import Path
from shutil import get_terminal_size
from types import TracebackType

from rich.cells import cell_len

from onika.cli.editor import Editor
from onika.cli.keys import Keys
from onika.cli.language import say
from onika.cli.safe_text import safe
from onika.desk.console.display import Tone
from onika.words.reason import Text

_COLOURS = {
    Tone.HEAD: "1",
    Tone.GOOD: "32",
    Tone.DIM: "2",
    Tone.NOTE: "33",
    Tone.FAULT: "31",
    Tone.ASK: "35",
}
_CLEAR = "\r\x1b[K"


class Terminal:
    """The line at the bottom is taken away before something is said, and comes back after it; nothing typed is lost.

    `history` is the file of the lines of former consoles; none is kept where it is None or cannot be written.
    """

    is_person = True

    def __init__(self, complete: Callable[[str], list[str]], history: Path | None = None) -> None:
        self._history = history
        self._editor = Editor(complete, _former(history))
        self._keys = Keys()
        self._typed: deque[str] = deque()
        self._prompt = ""
        self._is_shown = False
        self._input = sys.stdin.fileno()
        self._usual = termios.tcgetattr(self._input)
        self._has_colour = not os.environ.get("NO_COLOR")

    def __enter__(self) -> "Terminal":
        mode = termios.tcgetattr(self._input)
        mode[3] &= ~(termios.ICANON | termios.ECHO)  # Ctrl-C stays a signal
        mode[6][termios.VSUSP] = b"\0"  # a console that is put aside watches over nothing
        mode[6][termios.VMIN], mode[6][termios.VTIME] = 1, 0
        termios.tcsetattr(self._input, termios.TCSADRAIN, mode)
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._hide()
        termios.tcsetattr(self._input, termios.TCSADRAIN, self._usual)
        _keep(self._history, self._editor.history)

    def say(self, line: Text, tone: Tone = Tone.PLAIN) -> None:
        """Show a line above the one that is typed."""
        was_shown = self._is_shown
        self._hide()
        colour = _COLOURS.get(tone, "") if self._has_colour else ""
        text = safe(say(line))
        sys.stdout.write((f"\x1b[{colour}m{text}\x1b[0m" if colour else text) + "\n")
        if was_shown:
            self._show()
        sys.stdout.flush()

    def line(self, prompt: str, timeout_s: float) -> str | None:
        """The next line, None while there is none yet; raises EOFError at the end of the input."""
        if prompt != self._prompt or not self._is_shown:
            self._prompt = prompt
            self._show()
        if not self._typed and select.select([self._input], [], [], timeout_s)[0]:
            data = os.read(self._input, 4096)
            if not data:
                raise EOFError
            self._typed += self._keys.read(data)
        has_keys = bool(self._typed)
        while self._typed:
            line = self._press(self._typed.popleft())
            if line is not None:
                return line
        if has_keys:
            self._show()
        return None

    def drop(self) -> None:
        """Forget what was typed of this line."""
        self._typed.clear()
        self._editor.drop()
        if self._is_shown:
            self._show()

    def _press(self, key: str) -> str | None:
        if key == "clear":
            sys.stdout.write("\x1b[H\x1b[2J")
        line = self._editor.press(key)
        if self._editor.is_over:
            raise EOFError
        if line is None:
            for row in _rows(self._editor.offered, get_terminal_size().columns):
                self.say(row, Tone.DIM)
            return None
        sys.stdout.write(_CLEAR + self._prompt + safe(say(line)) + "\n")  # as it was typed stays above
        self._is_shown = False
        sys.stdout.flush()
        return line

    def _hide(self) -> None:
        if self._is_shown:
            sys.stdout.write(_CLEAR)
            self._is_shown = False

    def _show(self) -> None:
        room = max(get_terminal_size().columns - cell_len(self._prompt) - 1, 1)
        text, column = _window(self._editor.text, self._editor.cursor, room)
        column += cell_len(self._prompt)
        sys.stdout.write(f"{_CLEAR}{self._prompt}{text}\r" + (f"\x1b[{column}C" if column else ""))
        sys.stdout.flush()
        self._is_shown = True


def _window(text: str, cursor: int, room: int) -> tuple[str, int]:
    """The part of a line around its cursor that has room, and the column of the cursor in it."""
    start = 0
    while cell_len(text[start:cursor]) > room:
        start += 1
    end = len(text)
    while cell_len(text[start:end]) > room:
        end -= 1
    return text[start:end], cell_len(text[start:cursor])


def _rows(words: list[str], columns: int) -> list[str]:
    """Words side by side, as many as have room."""
    width = max((cell_len(word) for word in words), default=0) + 2
    count = max(columns // width, 1)
    return [
        "".join(word + " " * (width - cell_len(word)) for word in words[start : start + count]).rstrip()
        for start in range(0, len(words), count)
    ]


def _former(path: Path | None) -> list[str]:
    try:
        if path is None:
            return []
        return path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError):
        return []


def _keep(path: Path | None, lines: list[str]) -> None:
    """For the next console; a history that cannot be kept is no reason to complain."""
    if path is None:
        return
    try:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        path.touch(mode=0o600)
        path.write_text("".join(line + "\n" for line in lines), encoding="utf-8")
    except OSError:
        pass
