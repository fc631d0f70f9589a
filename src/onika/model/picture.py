"""The picture of an onikon: as many rows as cells in each, over a table of nine colours (dissertation §A.3, §5.6.1).

The thesis has pictures of 32 × 32 cells. Those of 48 and 64 are ours, and stand in files of version 2.0 (decision 43).
"""

from collections.abc import Sequence
from dataclasses import dataclass

from onika.words.reason import Reason

SIZE = 32
"""Rows of a picture of the thesis, and cells of a row."""

SIZES = (SIZE, 48, 64)
"""Rows that a picture may have, and as many cells has each of them."""

COLOURS = ("red", "green", "blue", "yellow", "orange", "purple", "grey", "white", "black")
"""The name of each colour; a cell holds its index as a digit."""

BLACK = "8"
"""The colour of the border (requirement B11)."""

_DIGITS = "012345678"


@dataclass(frozen=True, slots=True)
class Picture:
    """32, 48 or 64 rows of as many digits 0 to 8 with a black border; anything else raises ValueError."""

    rows: tuple[str, ...]

    def __post_init__(self) -> None:
        if not is_digits(self.rows, _DIGITS):
            raise ValueError(Reason.of("rules.picture_digits", sizes=SIZES, given=repr(self.rows)))
        if _framed(self.rows) != self.rows:
            raise ValueError(Reason.of("rules.picture_border"))

    @property
    def size(self) -> int:
        """How many rows it has, and cells each."""
        return len(self.rows)

    @property
    def is_larger(self) -> bool:
        """Whether version 1.3 cannot say it."""
        return self.size > SIZE


def is_square(rows: Sequence[str]) -> bool:
    """Whether there are as many rows as a picture may have, each of as many cells."""
    size = len(rows)
    return size in SIZES and all(len(row) == size for row in rows)


def is_digits(rows: Sequence[str], digits: str) -> bool:
    """Whether rows are those of a picture and hold these digits only; a thousand pictures are looked at at once."""
    return is_square(rows) and not "".join(rows).strip(digits)


def framed(rows: Sequence[str]) -> Picture:
    """The picture of these rows with its border made black; raises ValueError where they are no picture's."""
    if not is_square(rows):
        raise ValueError(Reason.of("rules.picture_size", sizes=SIZES, given=repr(rows)))
    return Picture(_framed(rows))


def blank(size: int = SIZE) -> Picture:
    """An empty picture: white within the black border."""
    return framed(("7" * size,) * size)


def _framed(rows: Sequence[str]) -> tuple[str, ...]:
    edge = BLACK * len(rows)
    return (edge, *(BLACK + row[1:-1] + BLACK for row in rows[1:-1]), edge)
