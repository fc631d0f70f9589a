"""A line while it is typed: keys in, the text and its cursor out; no terminal (requirement A16)."""

from collections.abc import Callable

_KEPT = 1000


class Editor:
    """One line, the lines before it, and what may complete it.

    Up and down find earlier lines that begin as the line does.
    """

    def __init__(self, complete: Callable[[str], list[str]], history: list[str] | None = None) -> None:
        self._complete = complete
        self.history = list(history or [])
        self.text = ""
        self.cursor = 0
        self.is_over = False
        """Whether the end of the input was typed, into an empty line."""
        self.offered: list[str] = []
        """What may stand at the cursor, where the last key asked for it and there are several."""
        self._cut = ""
        self._place: int | None = None
        self._sought = ""
        self._moves: dict[str, Callable[[], None]] = {
            "left": lambda: self._go(self.cursor - 1),
            "right": lambda: self._go(self.cursor + 1),
            "home": lambda: self._go(0),
            "end": lambda: self._go(len(self.text)),
            "word left": lambda: self._go(self._word_left()),
            "word right": lambda: self._go(self._word_right()),
            "backspace": lambda: self._drop(self.cursor - 1, self.cursor),
            "delete": lambda: self._drop(self.cursor, self.cursor + 1),
            "delete or end": self._delete_or_end,
            "cut to end": lambda: self._take(self.cursor, len(self.text)),
            "cut to start": lambda: self._take(0, self.cursor),
            "cut word": lambda: self._take(self._word_left(), self.cursor),
            "cut word right": lambda: self._take(self.cursor, self._word_right()),
            "paste": lambda: self._insert(self._cut),
            "tab": self._tab,
        }

    def press(self, key: str) -> str | None:
        """Take one key; the whole line where it is the last one."""
        self.offered = []
        if key in ("up", "down"):
            self._seek(-1 if key == "up" else 1)
            return None
        self._place = None
        if key == "enter":
            return self._finish()
        if len(key) == 1:
            self._insert(key)
        elif key in self._moves:
            self._moves[key]()
        return None

    def drop(self) -> None:
        """Begin anew, with nothing typed."""
        self.text, self.cursor, self._place, self.offered = "", 0, None, []

    def _finish(self) -> str:
        line = self.text
        if line.strip() and self.history[-1:] != [line]:
            self.history = [*self.history, line][-_KEPT:]
        self.drop()
        return line

    def _go(self, place: int) -> None:
        self.cursor = min(max(place, 0), len(self.text))

    def _insert(self, text: str) -> None:
        self.text = self.text[: self.cursor] + text + self.text[self.cursor :]
        self.cursor += len(text)

    def _drop(self, start: int, end: int) -> None:
        start = max(start, 0)
        self.text = self.text[:start] + self.text[end:]
        self.cursor = start

    def _take(self, start: int, end: int) -> None:
        self._cut = self.text[start:end] or self._cut
        self._drop(start, end)

    def _delete_or_end(self) -> None:
        if self.text:
            self._drop(self.cursor, self.cursor + 1)
        else:
            self.is_over = True

    def _word_left(self) -> int:
        before = self.text[: self.cursor].rstrip()
        return len(before) - len(before.split(" ")[-1])

    def _word_right(self) -> int:
        rest = self.text[self.cursor :]
        blanks = len(rest) - len(rest.lstrip())
        return self.cursor + blanks + len(rest.lstrip().partition(" ")[0])

    def _seek(self, step: int) -> None:
        if self._place is None:
            self._sought, self._place = self.text, len(self.history)
        place = self._place + step
        while 0 <= place < len(self.history):
            if self.history[place].startswith(self._sought) and self.history[place] != self.text:
                self._place, self.text = place, self.history[place]
                break
            place += step
        else:
            if step > 0:
                self._place, self.text = len(self.history), self._sought
        self.cursor = len(self.text)

    def _tab(self) -> None:
        before = self.text[: self.cursor]
        candidates = self._complete(before)
        if not candidates:
            return
        word = "" if not before or before[-1].isspace() else before.split()[-1]
        longest = _common(candidates)
        self._insert(longest[len(word) :])
        if len(candidates) == 1 and not longest.endswith("/"):
            self._insert(" ")
        elif len(longest) == len(word):
            self.offered = candidates


def _common(words: list[str]) -> str:
    """The beginning that all words have."""
    first, last = min(words), max(words)
    alike = next((place for place, letter in enumerate(first) if last[place : place + 1] != letter), len(first))
    return first[:alike]
