"""The words of one line as the formats of robots and worlds have them: real numbers, names of a model, files."""

import math
from collections.abc import Mapping, Sequence

from onika.files.line import FileLine, is_number, one_line, row, show_number
from onika.files.text_reading import KeywordSlot, TextReading
from onika.model.robot import Lines, Numbers
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

BY_KEYWORD = Mapping[str, FileLine | None]
_MOST = 64
"""Numbers or names on a line."""


class BlockWords:
    """The lines of one block by their keywords, each once, and what their words say.

    A line that is missing gives the default, and one that is wrong too, once it is told.
    """

    def __init__(self, block: Sequence[FileLine], slots: Sequence[KeywordSlot], reading: TextReading) -> None:
        self._reading = reading
        arranged = reading.arrange(block, slots)
        self._arranged = arranged
        self._line: BY_KEYWORD = {keyword: lines[0] if lines else None for keyword, lines in arranged.items()}

    @property
    def lines(self) -> Lines:
        """Where each keyword stands."""
        return {keyword: line.number for keyword, line in self._line.items() if line is not None}

    def has(self, keyword: str) -> bool:
        """Whether the line is there."""
        return self._line.get(keyword) is not None

    def name(self, keyword: str, unnamed: str = "") -> str:
        """The name of a block: one word as of a task, or the sign `unnamed`."""
        line = self._line[keyword]
        if line is not None and unnamed and line.rest == unnamed:
            return unnamed
        return self._reading.match(line, TASK_NAME, Reason.of("files.a_name"))

    def rows(self, keyword: str) -> Sequence[FileLine]:
        """The lines of a keyword that may stand several times."""
        return self._arranged[keyword]

    def wrong_row(self, line: FileLine, meaning: Reason) -> None:
        """Report that a line does not say what it should."""
        self._wrong(line, meaning)

    def text(self, keyword: str) -> str:
        """Free text, which may be empty."""
        line = self._line[keyword]
        return line.text if line else ""

    def file(self, keyword: str) -> str:
        """A file, which may hold blanks."""
        line = self._line[keyword]
        if line is not None and not line.rest:
            self._wrong(line, Reason.of("files.name_of_file"))
        return line.text if line else ""

    def words(self, keyword: str, meaning: Reason, least: int = 1, *, is_each_once: bool = True) -> tuple[str, ...]:
        """Words of any form, at least so many and, unless said otherwise, each once."""
        line = self._line[keyword]
        if line is None:
            return ()
        words = line.words
        if not least <= len(words) <= _MOST or (is_each_once and len(set(words)) < len(words)):
            self._wrong(line, meaning)
            return ()
        return words

    def word(self, keyword: str, meaning: Reason, default: str = "") -> str:
        """One word of any form."""
        return self._reading.word(self._line[keyword], meaning, default)

    def choice(self, keyword: str, choices: Sequence[str]) -> str:
        """One of several words, the first where the line is missing."""
        return self._reading.choice(self._line[keyword], {word: word for word in choices}, choices[0])

    def numbers(self, keyword: str, meaning: Reason, count: int, default: Numbers = (), low: float = -1e9) -> Numbers:
        """As many real numbers of at least `low`; 0: any number of them, but one at least."""
        line = self._line[keyword]
        if line is None:
            return default
        numbers = reals(line.words)
        if numbers is None or len(numbers) != (count or len(numbers)) or not 0 < len(numbers) <= _MOST:
            self._wrong(line, meaning)
            return default
        if min(numbers) < low:
            self._wrong(line, meaning)
            return default
        return numbers

    def number(self, keyword: str, meaning: Reason, default: float, low: float = -1e9) -> float:
        """One real number of at least `low`."""
        return self.numbers(keyword, meaning, 1, (default,), low)[0]

    def named_numbers(
        self, keyword: str, meaning: Reason, names: int, counts: Sequence[int], low: float = -1e9
    ) -> tuple[tuple[str, ...], Numbers]:
        """So many words and then numbers of at least `low`, one of `counts` of them; nothing where the line is none."""
        line = self._line[keyword]
        if line is None:
            return (), ()
        numbers = reals(line.words[names:])
        if len(line.words) < names or numbers is None or len(numbers) not in counts or min((low, *numbers)) < low:
            self._wrong(line, meaning)
            return (), ()
        return line.words[:names], numbers

    def wrong(self, keyword: str, reason: Reason) -> None:
        """Report something at a line, or at the head of the block where there is none such."""
        line = self._line.get(keyword)
        number = line.number if line is not None else min(self.lines.values(), default=0)
        self._reading.fault(number, reason)

    def _wrong(self, line: FileLine, meaning: Reason) -> None:
        self._reading.fault(
            line.number, Reason.of("files.meaning_after", meaning=meaning, keyword=line.keyword, line=str(line))
        )


def reals(words: Sequence[str]) -> Numbers | None:
    """Finite numbers of at most a milliard; None where a word is none."""
    if not all(map(is_number, words)):
        return None
    numbers = tuple(float(word) for word in words)
    if not all(math.isfinite(number) and abs(number) <= 1e9 for number in numbers):
        return None
    return tuple(number + 0.0 for number in numbers)


def number_row(keyword: str, numbers: Sequence[float]) -> str:
    """A line of numbers."""
    return row(keyword, *map(show_number, numbers))


def text_row(keyword: str, text: str) -> str:
    """A line of free text; nothing where there is none."""
    return row(keyword, one_line(text)) if text else ""
