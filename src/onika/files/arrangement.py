"""The file in which stands how tasks or icons are arranged, `OnikaArrangement.dta` beside them (requirement D24).

A format of our own, of version 2.0: lines `PLACE NAME` in the order in which they stand. Names that are not in it come
behind, in the order in which they would stand without it; names that are nobody's say nothing. In the user's own base
directory, behind a line `BASE NAME`, stands how what comes with Onika is arranged, which is never written.
"""

from collections.abc import Mapping, Sequence

from onika.files.layout import carry_comments
from onika.files.line import FileLine, row, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED
from onika.words.fault import Fault
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

NAME = "OnikaArrangement.dta"
HERE = ""
"""The folder in which the file stands, as a key among the names of base directories."""

Arrangement = Mapping[str, tuple[str, ...]]
"""Names in their order, by the name of the base directory whose they are."""

_BASE, _PLACE = "BASE", "PLACE"
_HEAD = (KeywordSlot("VERSION"), KeywordSlot(_PLACE, Need.OPTIONAL, many=True))
_BLOCK = (KeywordSlot(_BASE), KeywordSlot(_PLACE, many=True))


def read(text: str, name: str, place_file: str) -> tuple[Arrangement | None, tuple[Fault, ...]]:
    """The arrangement of a text, whole or not at all; `name` only completes the form of all formats."""
    del name
    reading = TextReading(place_file, Reason.of("files.arrangement_left_out"))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, {_BASE})
    arrangement = {}
    places = _names(reading.arrange(head, _HEAD)[_PLACE], reading)
    if places:
        arrangement[HERE] = places
    for block in blocks:
        by_keyword = reading.arrange(block, _BLOCK)
        base = _name(by_keyword[_BASE][0], reading) if by_keyword[_BASE] else ""
        if base in arrangement and by_keyword[_BASE]:
            reading.fault(by_keyword[_BASE][0].number, Reason.of("files.base_twice", name=base))
        arrangement[base] = _names(by_keyword[_PLACE], reading)
    return (None if reading.broken else arrangement), reading.faults


def write(arrangement: Arrangement, former: str = "") -> str:
    """The text of an arrangement, with the comments of its former text."""
    parts = [row("VERSION", EXTENDED)]
    for base in sorted(arrangement):
        if arrangement[base]:
            parts += ["\n", *([row(_BASE, base)] if base else []), *(row(_PLACE, name) for name in arrangement[base])]
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _names(lines: Sequence[FileLine], reading: TextReading) -> tuple[str, ...]:
    """The names of lines; each once."""
    names: dict[str, None] = {}
    for line in lines:
        name = _name(line, reading)
        if name in names:
            reading.fault(line.number, Reason.of("files.place_twice", name=name))
        names[name] = None
    return tuple(names)


def _name(line: FileLine, reading: TextReading) -> str:
    return reading.match(line, TASK_NAME, Reason.of("files.a_name"))
