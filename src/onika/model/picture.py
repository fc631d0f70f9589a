"""The picture of an onikon: 32 rows of 32 cells over a table of nine colours (dissertation §A.3, §5.6.1)."""

from collections.abc import Sequence
from dataclasses import dataclass

from onika.words.reason import Reason

SIZE = 32
"""Rows of a picture, and cells of a row."""

COLOURS = ("red", "green", "blue", "yellow", "orange", "purple", "grey", "white", "black")
"""The name of each colour; a cell holds its index as a digit."""

BLACK = "8"
"""The colour of the border (requirement B11)."""

_DIGITS = "012345678"


@dataclass(frozen=True, slots=True)
class Picture:
    """32 rows of 32 digits 0 to 8 with a black border; anything else raises ValueError."""

    rows: tuple[str, ...]

    def __post_init__(self) -> None:
        if len(self.rows) != SIZE or not is_digits(self.rows, _DIGITS):
            raise ValueError(Reason.of("rules.picture_digits", size=SIZE, given=repr(self.rows)))
        if _framed(self.rows) != self.rows:
            raise ValueError(Reason.of("rules.picture_border"))


def is_digits(rows: Sequence[str], digits: str) -> bool:
    """Whether rows are of the right length and hold these digits only; a thousand pictures are looked at at once."""
    return all(len(row) == SIZE for row in rows) and not "".join(rows).strip(digits)


def framed(rows: Sequence[str]) -> Picture:
    """The picture of these rows with its border made black; raises ValueError where they are not 32 × 32 digits."""
    if len(rows) != SIZE or any(len(row) != SIZE for row in rows):
        raise ValueError(Reason.of("rules.picture_size", size=SIZE, given=repr(rows)))
    return Picture(_framed(rows))


def blank() -> Picture:
    """An empty picture: white within the black border."""
    return framed(("7" * SIZE,) * SIZE)


def _framed(rows: Sequence[str]) -> tuple[str, ...]:
    edge = BLACK * SIZE
    return (edge, *(BLACK + row[1:-1] + BLACK for row in rows[1:-1]), edge)
