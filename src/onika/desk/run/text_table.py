"""Formats a table as lines of text: columns as wide as they have to be, numbers to the right."""

import re
from collections.abc import Callable, Iterable, Sequence

from onika.words.reason import Reason

Cell = Reason | str
"""What stands in a cell: words, or a name or number that is the same in every language."""

_GAP = "  "
_NUMBER = re.compile(r"[+-]?\.?\d\S*\Z")


def lines(head: Sequence[Cell], rows: Iterable[Sequence[Cell]], say: Callable[[Reason], str] = str) -> list[str]:
    """The head and one line for each row, without blanks at their ends; the head alone where there are no rows.

    `say` makes the words of what is a reason.
    """
    table = [[cell if isinstance(cell, str) else say(cell) for cell in row] for row in (head, *rows)]
    widths = [max(len(row[column]) for row in table) for column in range(len(head))]
    rights = [_is_numeric(row[column] for row in table[1:]) for column in range(len(head))]
    return [
        _GAP.join(_cell(*cell) for cell in zip(row, widths, rights, strict=True)).rstrip() for row in table
    ]  # fmt: skip


def _cell(text: str, width: int, right: bool) -> str:
    return text.rjust(width) if right else text.ljust(width)


def _is_numeric(cells: Iterable[str]) -> bool:
    """Whether every cell that says something is one word that begins as a number does."""
    filled = [cell for cell in cells if cell not in ("", "-")]
    return bool(filled) and all(_NUMBER.match(cell) for cell in filled)
