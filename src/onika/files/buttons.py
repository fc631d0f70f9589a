"""The file of the user's own buttons, `.onika.buttons` (dissertation §A.6)."""

import re
from collections.abc import Iterable, Sequence

from onika.files.layout import carry_comments
from onika.files.line import FileLine, one_line, row, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import VERSION
from onika.model.button import Button
from onika.words.fault import Fault
from onika.words.reason import Reason

NAME = ".onika.buttons"

# §A.6 spells the last keyword SPAWNNTTY in the format and in the text; SPAWNTTY is what it means. Both are read.
_SPAWN = "SPAWNNTTY"
_HEAD = (KeywordSlot("VERSION", Need.OPTIONAL),)
_BUTTON = (KeywordSlot("BUTTON"), KeywordSlot("FUNCTION"), KeywordSlot(_SPAWN, Need.SINCE_1_3))


def read(text: str, name: str, place_file: str) -> tuple[tuple[Button, ...] | None, tuple[Fault, ...]]:
    """The buttons of a text, all or none; `name` completes the form of all formats."""
    reading = TextReading(place_file, Reason.of("files.no_button", name=name))
    reading.open_versioned(text)
    if reading.is_over:
        return None, reading.faults
    lines = [FileLine(at.number, _SPAWN, at.rest) if at.keyword == "SPAWNTTY" else at for at in reading.lines]
    head, *blocks = split(lines, {"BUTTON"})
    reading.arrange(head, _HEAD)
    buttons = tuple(_button(block, reading) for block in blocks)
    return (None if reading.broken else buttons), reading.faults


def write(buttons: Iterable[Button], former: str = "") -> str:
    """The text of buttons, with the comments of its former text."""
    parts = [row("VERSION", VERSION)]
    for button in buttons:
        parts += ["\n", row("BUTTON", one_line(button.name)), row("FUNCTION", _command(button.command))]
        parts.append(row(_SPAWN, "yes" if button.spawns_terminal else "no"))
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _command(text: str) -> str:
    """Unlike in other texts, every blank of a command may count."""
    return re.sub(r"[\x00-\x08\x0a-\x1f\x7f-\x9f]+", " ", text).strip(" \t")


def _button(block: Sequence[FileLine], reading: TextReading) -> Button:
    by_keyword = {keyword: lines[0] if lines else None for keyword, lines in reading.arrange(block, _BUTTON).items()}
    for line in by_keyword.values():
        if line and not line.rest:
            reading.fault(line.number, Reason.of("files.text_after", keyword=line.keyword, line=str(line)))
    name, command = by_keyword["BUTTON"], by_keyword["FUNCTION"]
    return Button(
        name.text if name else "", command.rest if command else "", reading.yes(by_keyword[_SPAWN], default=False)
    )
