"""The rows of a picture, in PICT lines of icons and in the `.dta` files of start and stop icons (§A.8).

Of version 2.0 are pictures of 48 and 64 rows (decision 43). A `.dta` has no VERSION: its rows alone say how many.
"""

from collections import Counter
from collections.abc import Sequence

from onika.files import version
from onika.files.line import show
from onika.files.text_reading import TextReading
from onika.model.picture import BLACK, SIZE, SIZES, Picture, blank, framed, is_digits
from onika.words.fault import Fault
from onika.words.reason import Reason

ENDING = ".dta"

_DIGITS = "0123456789"

Rows = Sequence[tuple[int, str]]
"""The rows of a picture, each with the number of its line."""


def read(text: str, name: str, place_file: str) -> tuple[Picture | None, tuple[Fault, ...]]:
    """The picture of a start or stop icon: its rows of digits and nothing else; `name` only completes the form."""
    reading = TextReading(place_file, Reason.of("files.shipped_picture_stands", name=name))
    lines = [(number, line.removesuffix("\r")) for number, line in enumerate(text.split("\n"), start=1)]
    while lines and not lines[-1][1].strip(" \t"):
        lines.pop()
    picture = read_rows(lines, lines[-1][0] if lines else 0, reading, SIZES)
    return (None if reading.broken else picture), reading.faults


def write(picture: Picture) -> str:
    """The lines of a picture."""
    return "".join(line + "\n" for line in picture.rows)


def read_rows(rows: Rows, last: int, reading: TextReading, sizes: Sequence[int]) -> Picture:
    """The picture of numbered rows; faults go to `reading`, a missing row to line `last`; then it is blank.

    Of other `sizes` than these only a file of version 2.0 may have one. A 9 is read as black (reading 38) and the
    border is made black (requirement B11), each with one note.
    """
    if not _is_sound(rows, last, reading, sizes):
        return blank()
    picture = framed([text.replace("9", BLACK) for _, text in rows])
    nines = [number for number, text in rows if "9" in text]
    coloured = [at for (at, text), row in zip(rows, picture.rows, strict=True) if text.replace("9", BLACK) != row]
    if nines:
        reading.note(nines[0], Reason.of("files.picture_colours"), Reason.of("files.read_black"))
    if coloured:
        reading.note(coloured[0], Reason.of("files.black_border"), Reason.of("files.border_read_black"))
    return picture


def _is_sound(rows: Rows, last: int, reading: TextReading, sizes: Sequence[int]) -> bool:
    """Whether a picture can be made of the rows, though it may not stand here; what is wrong is told."""
    size = _size(rows)
    if size not in sizes:
        reading.fault(rows[0][0], Reason.of("files.version_for_picture", extended=version.EXTENDED, size=size))
    if is_digits([text for _, text in rows], _DIGITS):
        return True
    if len(rows) != size:
        number = rows[size][0] if len(rows) > size else last
        reading.fault(number, Reason.of("files.picture_rows", size=size, count=len(rows)))
    for number, text in rows:
        if not _is_row(text, size):
            reading.fault(number, Reason.of("files.picture_digits", size=size, text=show(text)))
    return False


def _size(rows: Rows) -> int:
    """The size that is meant: that of most rows, else their number, else that of the thesis."""
    counts = Counter(len(text) for _, text in rows if len(text) in SIZES)
    if counts:
        return counts.most_common(1)[0][0]
    return len(rows) if len(rows) in SIZES else SIZE


def _is_row(text: str, size: int) -> bool:
    return len(text) == size and not text.strip(_DIGITS)
