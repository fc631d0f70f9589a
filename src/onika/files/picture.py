"""The rows of a picture, in PICT lines of icons and in the `.dta` files of start and stop icons (§A.8)."""

import re
from collections.abc import Sequence

from onika.files.line import show
from onika.files.text_reading import TextReading
from onika.model.picture import BLACK, SIZE, Picture, blank, framed, is_digits
from onika.words.fault import Fault
from onika.words.reason import Reason

ENDING = ".dta"

_DIGITS = "0123456789"
_ROW = re.compile(rf"[0-9]{{{SIZE}}}\Z")


def read(text: str, name: str, place_file: str) -> tuple[Picture | None, tuple[Fault, ...]]:
    """The picture of a start or stop icon: 32 lines of 32 digits and nothing else; `name` only completes the form."""
    reading = TextReading(place_file, Reason.of("files.shipped_picture_stands", name=name))
    lines = [(number, line.removesuffix("\r")) for number, line in enumerate(text.split("\n"), start=1)]
    while lines and not lines[-1][1].strip(" \t"):
        lines.pop()
    picture = read_rows(lines, lines[-1][0] if lines else 0, reading)
    return (None if reading.broken else picture), reading.faults


def write(picture: Picture) -> str:
    """The 32 lines of a picture."""
    return "".join(line + "\n" for line in picture.rows)


def read_rows(rows: Sequence[tuple[int, str]], last: int, reading: TextReading) -> Picture:
    """The picture of numbered rows; faults go to `reading`, a missing row to line `last`; then it is blank.

    A 9 is read as black (reading 38) and the border is made black (requirement B11), each with one note.
    """
    if len(rows) != SIZE:
        reading.fault(
            rows[SIZE][0] if len(rows) > SIZE else last, Reason.of("files.picture_rows", size=SIZE, count=len(rows))
        )
    is_whole = is_digits([text for _, text in rows], _DIGITS)
    wrong = [] if is_whole else [(number, text) for number, text in rows if not _ROW.match(text)]
    for number, text in wrong:
        reading.fault(number, Reason.of("files.picture_digits", size=SIZE, text=show(text)))
    if wrong or len(rows) != SIZE:
        return blank()
    picture = framed([text.replace("9", BLACK) for _, text in rows])
    nines = [number for number, text in rows if "9" in text]
    coloured = [at for (at, text), row in zip(rows, picture.rows, strict=True) if text.replace("9", BLACK) != row]
    if nines:
        reading.note(nines[0], Reason.of("files.picture_colours"), Reason.of("files.read_black"))
    if coloured:
        reading.note(coloured[0], Reason.of("files.black_border"), Reason.of("files.border_read_black"))
    return picture
