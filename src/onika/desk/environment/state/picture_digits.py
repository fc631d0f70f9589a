"""A picture as a page sends it: 1024 digits (requirements D07, B11)."""

from onika.model.picture import BLACK, SIZE, Picture, framed
from onika.words.reason import Reason


def painted(digits: str) -> Picture | Reason:
    """The picture of 1024 digits, its border made black; a 9 is black too (reading 38). Else what is wrong."""
    if len(digits) != SIZE * SIZE or not (digits.isascii() and digits.isdigit()):
        strange = sorted({digit for digit in digits if not (digit.isascii() and digit.isdigit())})
        count = len(digits)
        plain = Reason.of("desk.signs", count=count)
        summary = Reason.of("desk.signs_with", count=count, sign=strange[0]) if strange else plain
        return Reason.of("desk.picture_digits", count=SIZE * SIZE, found=summary)
    rows = digits.replace("9", BLACK)
    return framed([rows[start : start + SIZE] for start in range(0, len(rows), SIZE)])
