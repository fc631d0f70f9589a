"""The reading of one text of Appendix A: lines of a keyword and its words, with `#` comments and blank lines between.

A comment is a line whose first sign is `#`. Runs of blanks and tabs count as one. The order of lines within a block
is law (reading 41), EOF is the last one, VERSION the first (requirement B06). Every fault of a text is collected.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import TypeVar

from onika.files import version
from onika.files.line import FileLine, parse_line, show
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

_T = TypeVar("_T")
_CONTROL = re.compile(r"[\x00-\x08\x0a-\x1f\x7f-\x9f]")
_STRANGE = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
"""A control sign that is no blank and ends no line: where a text has none, none of its lines has to be looked at."""
_WHOLE = re.compile(r"[+-]?[0-9]{1,18}\Z")

MOST_LINES = 100_000
"""Lines of a text; a configuration of ten thousand tasks has half of them."""
LONGEST_LINE = 1_000_000
"""Letters of a line."""
MOST_FAULTS = 1_000
"""Faults of one text, beyond which it is not looked at any further: nobody reads more, and it is left out anyway."""


class Need(Enum):
    """When a line must be there."""

    ALWAYS = "always"
    SINCE_1_3 = "older files may lack it"
    OPTIONAL = "never"
    OF_2_0 = "never, and it may only in a file of version 2.0"


@dataclass(frozen=True, slots=True)
class KeywordSlot:
    """A line's place in the order of a block."""

    keyword: str
    need: Need = Need.ALWAYS
    many: bool = False


class TextReading:
    """One text on its way to a model: its lines up to EOF and the faults found so far.

    `broken` tells that nothing may be made of it, `is_over` that there is nothing more to find, as it is empty or of
    a newer version, `is_old` that lines may be lacking, `is_extended` that there may be lines of version 2.0. `end` is
    the number of the line with EOF, or else the last. `is_full` tells that the rest is not read, as too much is wrong.
    """

    def __init__(self, file: str, instead: Reason, most_lines: int = MOST_LINES) -> None:
        self.file = file
        self.instead = instead
        self._most_lines = most_lines
        self._broken_lines = 0
        self.broken = False
        self.is_full = False
        self.is_over = False
        self.is_old = False
        self.is_extended = False
        self.end = 0
        self.lines: list[FileLine] = []
        self._faults: list[Fault] = []

    @property
    def faults(self) -> tuple[Fault, ...]:
        """Everything found, in the order of the lines."""
        return tuple(sorted(self._faults, key=lambda fault: fault.place.line))

    def fault(self, number: int, reason: Reason) -> None:
        """Report something for which the whole text is left out; `number` is its line."""
        self.broken = True
        self._broken_lines += 1
        if self._broken_lines < MOST_FAULTS:
            self.part(number, reason, self.instead)
        elif not self.is_full:
            self.is_full = True
            self.part(number, Reason.of("files.faults_many", most=MOST_FAULTS), self.instead)

    def part(self, number: int, reason: Reason, instead: Reason) -> None:
        """Report something for which a part is left out, as `instead` says."""
        self._faults.append(Fault(Place(self.file, number), reason, instead))

    def note(self, number: int, reason: Reason, instead: Reason) -> None:
        """Report something that is only worth knowing: nothing is left out."""
        self._faults.append(Fault(Place(self.file, number), reason, instead, is_note=True))

    # -- the whole text

    def open(self, text: str) -> None:
        """Take the lines of a text and see that it ends with EOF."""
        count = text.count("\n")
        if count > self._most_lines:
            self.fault(0, Reason.of("files.lines_many", most=self._most_lines, count=count))
            self.is_over = True
            return
        self.lines = _content(text, self)
        if not self.lines:
            if not self.broken:
                self.fault(0, Reason.of("files.empty"))
            self.is_over = True
            return
        self.end = self.lines[-1].number
        end = next((at for at, line in enumerate(self.lines) if line.keyword == "EOF"), None)
        if end is None:
            self.fault(self.end, Reason.of("files.eof_missing", lines=str(self.lines[-1])))
            return
        self.end = self.lines[end].number
        self.bare(self.lines[end])
        for line in self.lines[end + 1 : end + 1 + MOST_FAULTS]:
            self.fault(line.number, Reason.of("files.nothing_after_eof", line=str(line)))
        self.lines = self.lines[:end]

    def open_versioned(self, text: str, *, extended: bool = False) -> None:
        """As `open`, and look at VERSION: absent or below 1.3, lines may be lacking; above, the text is refused.

        `extended`: but for 2.0, in which the format has lines of our own.
        """
        self.open(text)
        line = next((line for line in self.lines if line.keyword == "VERSION"), None)
        self.is_old = line is None
        if line is None:
            return
        if not version.is_version(line.rest):
            self.fault(line.number, Reason.of("files.version_number", line=str(line)))
            return
        self.is_old = version.is_older(line.rest)
        self.is_extended = version.is_extended(line.rest)
        if not version.is_known(line.rest, extended=extended):
            self._faults.clear()
            self._broken_lines, self.is_full = 0, False
            self.fault(line.number, _newer(line.rest, is_extended=extended))
            self.is_over = True

    def arrange(self, block: Sequence[FileLine], slots: Sequence[KeywordSlot]) -> Mapping[str, list[FileLine]]:
        """Check a block of lines against its slots; gives the lines of every keyword, lists empty where none is.

        Where the reading is full, all are empty.
        """
        places = {slot.keyword: place for place, slot in enumerate(slots)}
        by_keyword: dict[str, list[FileLine]] = {slot.keyword: [] for slot in slots}
        reported: set[str] = set()
        reached = -1
        for line in block:
            if self.is_full:
                return {keyword: [] for keyword in places}
            place = places.get(line.keyword)
            if place is None:
                expected = self._expected(slots, reached)
                reported.update(expected)
                if expected:
                    reason = Reason.of("files.keywords_expected", keywords=tuple(expected), line=str(line))
                else:
                    reason = Reason.of("files.no_more_lines", line=str(line))
                self.fault(line.number, reason)
            elif by_keyword[line.keyword] and not slots[place].many:
                self.fault(line.number, Reason.of("files.keyword_once", keyword=line.keyword, line=str(line)))
            else:
                if slots[place].need is Need.OF_2_0 and not self.is_extended:
                    self.fault(
                        line.number,
                        Reason.of(
                            "files.version_for_line", extended=version.EXTENDED, keyword=line.keyword, line=str(line)
                        ),
                    )
                if place < reached:
                    self.fault(
                        line.number,
                        Reason.of(
                            "files.keyword_order",
                            keyword=line.keyword,
                            keyword_2=slots[reached].keyword,
                            line=str(line),
                        ),
                    )
                reached = max(reached, place)
                by_keyword[line.keyword].append(line)
        self._check_missing(block, [slot for slot in slots if slot.keyword not in reported], by_keyword)
        return by_keyword

    def _expected(self, slots: Sequence[KeywordSlot], reached: int) -> list[str]:
        """The keywords that may come after slot `reached`, up to the first that must."""
        names = [slots[reached].keyword] if reached >= 0 and slots[reached].many else []
        for slot in slots[reached + 1 :]:
            if slot.need is Need.OF_2_0 and not self.is_extended:
                continue
            names.append(slot.keyword)
            if self._needs(slot):
                break
        return names

    def _needs(self, slot: KeywordSlot) -> bool:
        return slot.need is Need.ALWAYS or (slot.need is Need.SINCE_1_3 and not self.is_old)

    def _check_missing(
        self, block: Sequence[FileLine], slots: Sequence[KeywordSlot], by_keyword: Mapping[str, list[FileLine]]
    ) -> None:
        """A line that is missing, but for those in whose place another one stood, as it is told already."""
        later = {slot.keyword: place for place, slot in enumerate(slots)}
        for place, slot in enumerate(slots):
            if self._needs(slot) and not by_keyword[slot.keyword]:
                after = [line.number for line in block if later.get(line.keyword, -1) > place]
                number = after[0] if after else (block[-1].number if block else self.end)
                self.fault(number, Reason.of("files.line_missing", keyword=slot.keyword))

    # -- the words of one line; each gives `default` where the line is missing or wrong

    def bare(self, line: FileLine) -> None:
        """A keyword that stands alone."""
        if line.rest:
            self.fault(line.number, Reason.of("files.keyword_alone", keyword=line.keyword, line=str(line)))

    def match(self, line: FileLine | None, pattern: re.Pattern[str], meaning: Reason, default: str = "") -> str:
        """One word of a form; `meaning` says which."""
        if line is None or pattern.match(line.rest):
            return line.rest if line else default
        self.fault(line.number, Reason.of("files.meaning_after", meaning=meaning, keyword=line.keyword, line=str(line)))
        return default

    def word(self, line: FileLine | None, meaning: Reason, default: str = "") -> str:
        """One word of any form."""
        return self.match(line, re.compile(r"[^ \t]+\Z"), meaning, default)

    def choice(self, line: FileLine | None, choices: Mapping[str, _T], default: _T) -> _T:
        """One of several words."""
        if line is None or line.rest in choices:
            return choices[line.rest] if line else default
        reason = Reason.of("files.choice_after", choices=tuple(choices), keyword=line.keyword, line=str(line))
        self.fault(line.number, reason)
        return default

    def yes(self, line: FileLine | None, default: bool) -> bool:
        """The word yes or no."""
        return self.choice(line, {"yes": True, "no": False}, default)

    def wholes(self, line: FileLine | None, default: tuple[int, ...], low: int = -(10**9)) -> tuple[int, ...]:
        """As many whole numbers from `low` to 10⁹ as `default` has."""
        if line is None:
            return default
        words = line.words
        if len(words) == len(default) and all(_WHOLE.match(word) for word in words):
            numbers = tuple(map(int, words))
            if all(low <= number <= 10**9 for number in numbers):
                return numbers
        self.fault(line.number, _no_wholes(line, len(default), low))
        return default

    def whole(self, line: FileLine | None, default: int, low: int = -(10**9)) -> int:
        """One whole number of at least `low`."""
        return self.wholes(line, (default,), low)[0]


def _newer(given: str, *, is_extended: bool) -> Reason:
    if is_extended:
        newest, extended = version.VERSION, version.EXTENDED
        return Reason.of("files.version_newer_extended", version=newest, extended=extended, given=given)
    return Reason.of("files.version_newer", version=version.VERSION, given=given)


def _no_wholes(line: FileLine, count: int, low: int) -> Reason:
    keyword, text = line.keyword, str(line)
    if count == 1 and low >= 0:
        return Reason.of("files.whole_above_after", low=low, keyword=keyword, line=text)
    if count == 1:
        return Reason.of("files.whole_after", keyword=keyword, line=text)
    if low >= 0:
        return Reason.of("files.wholes_above_after", count=count, low=low, keyword=keyword, line=text)
    return Reason.of("files.wholes_after", count=count, keyword=keyword, line=text)


def _content(text: str, reading: TextReading) -> list[FileLine]:
    """The lines that are no comments; signs that no text file holds are reported."""
    lines = []
    is_clean = _STRANGE.search(text) is None
    for number, raw in enumerate(text.removeprefix("\ufeff").split("\n"), start=1):
        line = raw.removesuffix("\r")
        if len(line) > LONGEST_LINE:
            reading.fault(number, Reason.of("files.line_long", most=LONGEST_LINE, count=len(line)))
            line = ""
        if reading.is_full:
            break
        if not is_clean and _CONTROL.search(line):
            reading.fault(number, Reason.of("files.printable_text", line=show(line)))
            line = _CONTROL.sub("", line)
        parsed = parse_line(number, line)
        if parsed is not None:
            lines.append(parsed)
    return lines
