"""One line of a file of Appendix A, a keyword and its words: as it is read, shown in messages and written."""

import re
from collections.abc import Sequence, Set
from typing import NamedTuple

_BLANK = re.compile(r"[ \t]+")
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?\Z")
_SHOWN = 200
"""Letters of a line that are looked at to show it."""


class FileLine(NamedTuple):
    """One line that is no comment: its number from 1, its keyword and what follows, with inner blanks as they are."""

    number: int
    keyword: str
    rest: str

    @property
    def words(self) -> tuple[str, ...]:
        """What follows the keyword, word by word."""
        return tuple(_BLANK.split(self.rest)) if self.rest else ()

    @property
    def text(self) -> str:
        """What follows the keyword, with single blanks."""
        return " ".join(self.words)

    def __str__(self) -> str:
        rest = " ".join(_BLANK.split(self.rest[:_SHOWN]))
        return show(f"{self.keyword[:_SHOWN]} {rest}".strip())


def parse_line(number: int, text: str) -> FileLine | None:
    """The line that a text without control signs is; None where it is blank or a comment."""
    stripped = text.strip(" \t")
    if not stripped or stripped.startswith("#"):
        return None
    keyword, _, rest = stripped.partition(" ")
    if "\t" in keyword:
        keyword, rest = _BLANK.split(stripped, maxsplit=1)
    return FileLine(number, keyword, rest.lstrip(" \t"))


def split(lines: Sequence[FileLine], heads: Set[str]) -> list[list[FileLine]]:
    """Cut lines into blocks, each but the first beginning with one of the keywords `heads`."""
    blocks: list[list[FileLine]] = [[]]
    for line in lines:
        if line.keyword in heads:
            blocks.append([])
        blocks[-1].append(line)
    return blocks


def is_number(word: str) -> bool:
    """Whether a word is a decimal number as files write it, sign and exponent included."""
    return bool(_NUMBER.match(word))


def show_number(value: float) -> str:
    """A finite number as short as it can be read back: 500, 0.004."""
    if value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return repr(value)


def row(keyword: str, *words: str) -> str:
    """A line of a file, its words in a column, with its line end."""
    return f"{keyword:<11} {' '.join(words)}".rstrip() + "\n"


def one_line(text: str) -> str:
    """A text that fits on a line: control signs, line ends and runs of blanks become one blank."""
    return " ".join(re.sub(r"[\x00-\x20\x7f-\x9f]+", " ", text).split(" ")).strip()


def show(text: str) -> str:
    """A found text in quotes, shortened for a message."""
    return repr(text if len(text) <= 60 else text[:57] + "…")
