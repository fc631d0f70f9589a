"""A picture as a page sends it: the digits of all its rows, one after the other (requirements D07, B11)."""

from math import isqrt

from onika.model.picture import BLACK, SIZES, Picture, framed
from onika.words.reason import Reason


def painted(digits: str) -> Picture | Reason:
    """The picture of these digits, its border made black; a 9 is black too (reading 38). Else what is wrong."""
    counts = tuple(size * size for size in SIZES)
    if len(digits) not in counts or not (digits.isascii() and digits.isdigit()):
        strange = sorted({digit for digit in digits if not (digit.isascii() and digit.isdigit())})
        count = len(digits)
        plain = Reason.of("desk.signs", count=count)
        summary = Reason.of("desk.signs_with", count=count, sign=strange[0]) if strange else plain
        return Reason.of("desk.picture_digits", counts=counts, found=summary)
    size = isqrt(len(digits))
    rows = digits.replace("9", BLACK)
    return framed([rows[start : start + size] for start in range(0, len(rows), size)])
