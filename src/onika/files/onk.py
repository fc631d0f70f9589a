"""The upper-level icon file, `.onk` (dissertation §A.3)."""

from onika.files.icon import SLOTS, needs_extension, read_icon, write_icon
from onika.files.layout import carry_comments
from onika.files.line import row
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED, VERSION
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax
from onika.words.fault import Fault
from onika.words.reason import Reason

ENDING = ".onk"

_SLOTS = (KeywordSlot("VERSION", Need.OPTIONAL), *SLOTS)


def read(text: str, name: str, place_file: str, syntax: Syntax) -> tuple[Onikon | None, tuple[Fault, ...]]:
    """The onikon `name` (no ending) of a text; left out with any fault, and where its type is an unknown target.

    A job of unknown type is kept and acts as a complete one, with a note (requirement D16).
    """
    reading = TextReading(place_file, Reason.of("files.icon_left_out"))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    by_keyword = reading.arrange(reading.lines, _SLOTS)
    onikon = read_icon(name, by_keyword, syntax, reading)
    kind = syntax.find(onikon.type) if onikon else None
    if kind and (kind.is_start or kind.is_end):
        reading.fault(
            by_keyword["ONIKON"][0].number, Reason.of("files.action_target", given=str(by_keyword["ONIKON"][0]))
        )
    return (None if reading.broken else onikon), reading.faults


def write(onikon: Onikon, former: str = "") -> str:
    """The text of an onikon, with the comments of its former text."""
    version = EXTENDED if needs_extension(onikon) else VERSION
    return carry_comments(former, row("VERSION", version) + "\n" + write_icon(onikon) + "\n" + row("EOF"))
