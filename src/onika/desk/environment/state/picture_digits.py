"""A picture as a page sends it: 1024 digits (requirements D07, B11)."""

from onika.model.picture import BLACK, SIZE, Picture, framed


def painted(digits: str) -> Picture | str:
    """The picture of 1024 digits, its border made black; a 9 is black too (reading 38). Else what is wrong."""
    if len(digits) != SIZE * SIZE or not (digits.isascii() and digits.isdigit()):
        strange = sorted({digit for digit in digits if not (digit.isascii() and digit.isdigit())})
        summary = f"{len(digits)} signs" + (f", among them {strange[0]!r}" if strange else "")
        return f"expected {SIZE * SIZE} digits from 0 to 8, found {summary}"
    rows = digits.replace("9", BLACK)
    return framed([rows[start : start + SIZE] for start in range(0, len(rows), SIZE)])
