"""The section WHERE of an AL text: icons that no dictionary holds alike, and holes that keep a target.

Its lines are those of an `.onk`, so that nothing of an icon is lost: `ICON name #2` before the icon's own, `HOLE #1`
before the lines of a target of unknown type.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from onika.files.al import token
from onika.files.flow import HEADS
from onika.files.icon import SLOTS, read_icon, write_icon
from onika.files.line import FileLine, row, split
from onika.files.text_reading import KeywordSlot, TextReading
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

HEAD = "WHERE"
END = "END WHERE"

Dictionary = Callable[[str], Onikon | None]
"""Finds the onikon of a name."""


@dataclass(slots=True)
class WhereSection:
    """What names in a text stand for; variant 1 is written without its number."""

    dictionary: Dictionary
    icons: dict[tuple[str, int], Onikon] = field(default_factory=dict)
    holes: dict[int, str] = field(default_factory=dict)
    _variants: dict[Onikon, int] = field(default_factory=dict)
    _counts: dict[str, int] = field(default_factory=dict)

    # -- writing

    def refer(self, onikon: Onikon) -> str:
        """How a text names an onikon, whatever its values; it is defined here unless the dictionary has the same."""
        bare = replace(onikon, values=())
        variant = self._variants.get(bare)
        if variant is None:
            variant = self._define(onikon, bare)
        return token.show(onikon.name) + (f" #{variant}" if variant > 1 else "")

    def refer_hole(self, kept: str) -> str:
        """How a text names a hole that keeps lines; empty for one that keeps none."""
        if not kept:
            return ""
        number = next((number for number, lines in self.holes.items() if lines == kept), len(self.holes) + 1)
        self.holes[number] = kept
        return f" #{number}"

    def write(self) -> str:
        """The section; empty where nothing is defined."""
        parts = [
            row("ICON", name, *([f"#{n}"] if n > 1 else [])) + write_icon(onikon)
            for (name, n), onikon in self.icons.items()
        ]
        parts += [row("HOLE", f"#{number}") + kept for number, kept in self.holes.items()]
        if parts:
            return "\n".join([f"{HEAD}\n", *parts, f"{END}\n"])
        return ""

    def _define(self, onikon: Onikon, bare: Onikon) -> int:
        """The variant of a new onikon: 1 is the dictionary's where that has the name, else the first."""
        same_name = self.dictionary(onikon.name)
        same = same_name is not None and replace(same_name.as_placed(), values=()) == bare
        reached = self._counts.setdefault(onikon.name, 0 if same_name is None else 1)
        variant = 1 if same else reached + 1
        if not same:
            self._counts[onikon.name] = variant
            self.icons[onikon.name, variant] = onikon
        self._variants[bare] = variant
        return variant

    # -- reading

    def find(self, name: str, variant: int) -> Onikon | None:
        """What a name in the text stands for."""
        icon = self.icons.get((name, variant))
        if icon is not None or variant != 1:
            return icon
        same_name = self.dictionary(name)
        return same_name.as_placed() if same_name else None


def read(text: str, start: int, syntax: Syntax, dictionary: Dictionary, reading: TextReading) -> WhereSection:
    """The glossary behind the line WHERE, which ends at `start` of the text, -1 where there is none."""
    glossary = WhereSection(dictionary)
    if start < 0:
        return glossary
    lines = _lines(text, start, reading)
    head, *blocks = split(lines, {"ICON", "HOLE"})
    for line in head:
        reading.fault(line.number, Reason.of("files.icon_hole", line=str(line)))
    for block in blocks:
        (_icon if block[0].keyword == "ICON" else _hole)(block, glossary, syntax, reading)
    return glossary


def _lines(text: str, start: int, reading: TextReading) -> Sequence[FileLine]:
    """The lines up to END WHERE, with their numbers in the whole text."""
    reading.is_extended = True  # whatever version the icons need
    inner = TextReading(reading.file, reading.instead)
    # the lines before it count, and the one that ends every file of ours closes the section
    inner.open("\n" * text.count("\n", 0, start) + text[start:] + "\nEOF\n")
    lines = inner.lines
    end = next((at for at, line in enumerate(lines) if f"{line.keyword} {line.rest}" == END), None)
    for fault in inner.faults:
        reading.fault(fault.place.line, fault.reason)
    if end is None:
        reading.fault(text.rstrip().count("\n") + 1, Reason.of("files.text_unclosed", end=END))
        return lines
    for line in lines[end + 1 :]:
        reading.fault(line.number, Reason.of("files.after_end", end=END, line=str(line)))
    return lines[:end]


def _icon(block: Sequence[FileLine], glossary: WhereSection, syntax: Syntax, reading: TextReading) -> None:
    by_keyword = reading.arrange(block, (KeywordSlot("ICON"), *SLOTS))
    name, variant = _name(block[0], reading)
    onikon = read_icon(name, by_keyword, syntax, reading)
    kind = syntax.find(onikon.type) if onikon else None
    if kind and (kind.is_start or kind.is_end):
        reading.fault(
            by_keyword["ONIKON"][0].number, Reason.of("files.action_target", given=str(by_keyword["ONIKON"][0]))
        )
    if (name, variant) in glossary.icons:
        reading.fault(block[0].number, Reason.of("files.every_icon_once", block=str(block[0])))
    if onikon is not None:
        glossary.icons[name, variant] = onikon


def _name(line: FileLine, reading: TextReading) -> tuple[str, int]:
    """The name of an icon and its variant."""
    name, *others = line.words or ("",)
    if not TASK_NAME.match(name) or len(others) > 1:
        reading.fault(line.number, Reason.of("files.icon_name", line=str(line)))
    return name, _number(others[0], line, reading) if others else 1


def _hole(block: Sequence[FileLine], glossary: WhereSection, _: Syntax, reading: TextReading) -> None:
    number = _number(block[0].rest, block[0], reading)
    if number in glossary.holes:
        reading.fault(block[0].number, Reason.of("files.every_hole_once", block=str(block[0])))
    heads = [line.keyword for line in block[1:] if line.keyword in HEADS]
    if heads != ["ROUTINE"] or block[1].keyword != "ROUTINE":
        if heads:
            reason = Reason.of("files.hole_lines", heads=" ".join(heads))
        else:
            reason = Reason.of("files.hole_lines_missing")
        reading.fault(block[0].number, reason)
    glossary.holes[number] = "".join(row(line.keyword, line.rest) for line in block[1:])


def _number(shown: str, line: FileLine, reading: TextReading) -> int:
    digits = shown[1:]
    if shown.startswith("#") and digits.isascii() and digits.isdigit() and len(digits) < 10 and int(digits) > 0:
        return int(digits)
    reading.fault(line.number, Reason.of("files.number_sign", keyword=line.keyword, line=str(line)))
    return 0
