"""The plain picture of an onikon for which nobody has drawn one: the initial letters of its name (§5.6.2)."""

import re

from onika.model.picture import BLACK, SIZE, Picture, framed

_WHITE = "7"
_WIDTH, _HEIGHT = 5, 7
_GLYPHS = {
    sign: tuple(int(row, 16) for row in rows.split())
    for sign, rows in {
        "A": "0E 11 11 1F 11 11 11", "B": "1E 11 11 1E 11 11 1E", "C": "0E 11 10 10 10 11 0E",
        "D": "1E 11 11 11 11 11 1E", "E": "1F 10 10 1E 10 10 1F", "F": "1F 10 10 1E 10 10 10",
        "G": "0E 11 10 17 11 11 0F", "H": "11 11 11 1F 11 11 11", "I": "0E 04 04 04 04 04 0E",
        "J": "07 02 02 02 02 12 0C", "K": "11 12 14 18 14 12 11", "L": "10 10 10 10 10 10 1F",
        "M": "11 1B 15 15 11 11 11", "N": "11 19 15 13 11 11 11", "O": "0E 11 11 11 11 11 0E",
        "P": "1E 11 11 1E 10 10 10", "Q": "0E 11 11 11 15 12 0D", "R": "1E 11 11 1E 14 12 11",
        "S": "0F 10 10 0E 01 01 1E", "T": "1F 04 04 04 04 04 04", "U": "11 11 11 11 11 11 0E",
        "V": "11 11 11 11 11 0A 04", "W": "11 11 11 15 15 1B 11", "X": "11 11 0A 04 0A 11 11",
        "Y": "11 11 0A 04 04 04 04", "Z": "1F 01 02 04 08 10 1F", "0": "0E 11 13 15 19 11 0E",
        "1": "04 0C 04 04 04 04 0E", "2": "0E 11 01 06 08 10 1F", "3": "1F 02 04 02 01 11 0E",
        "4": "02 06 0A 12 1F 02 02", "5": "1F 10 1E 01 01 11 0E", "6": "06 08 10 1E 11 11 0E",
        "7": "1F 01 02 04 08 08 08", "8": "0E 11 11 0E 11 11 0E", "9": "0E 11 11 0F 01 02 0C",
    }.items()
}  # fmt: skip


def initials(name: str) -> str:
    """The first letters of the first two words of a name, in capitals: `GH` for `go_home`, `A` for `assemble`."""
    words = [word for word in re.split(r"[_.-]+|(?<=[a-z])(?=[A-Z])", name) if word]
    return "".join(word[0] for word in words[:2]).upper()


def drawn(name: str) -> Picture:
    """The picture: one large letter or two smaller ones, black on white."""
    letters = [_GLYPHS[sign] for sign in initials(name) if sign in _GLYPHS]
    scale = 3 if len(letters) == 1 else 2
    width = len(letters) * (_WIDTH + 1) * scale - scale
    left, top = (SIZE - width) // 2, (SIZE - _HEIGHT * scale) // 2
    cells = [[_WHITE] * SIZE for _ in range(SIZE)]
    for number, rows in enumerate(letters):
        for y in range(_HEIGHT * scale):
            for x in range(_WIDTH * scale):
                if rows[y // scale] >> (_WIDTH - 1 - x // scale) & 1:
                    cells[top + y][left + number * (_WIDTH + 1) * scale + x] = BLACK
    return framed(["".join(row) for row in cells])
