"""The log of a session: lines of the seven columns of the thesis, and what a session is rebuilt from (H01, H08).

Columns are parted by tabs: time in seconds since 1970, event, object, its id, the associated object, its id, the window
(§6.2.2.4). Behind them stand a record, a JSON object on the same line, and a check of all that stands before it. In a
record `s` names the session and `n` is the place of the line in it: lines are put in this order; what lacks is told.
Logs that have the seven columns only, as those of the thesis, are read as well; nothing can be rebuilt from them.
"""

import hashlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import msgspec

from onika.words.fault import Fault, Place
from onika.words.reason import Reason

COLUMNS = ("time", "event", "object", "id", "associated", "associated_id", "window")
HEADER = "\t".join((*COLUMNS, "record", "check"))

_LEFT_OUT = "replay.line_left_out"


@dataclass(frozen=True, slots=True)
class LogLine:
    """A line of a log: its number in the file, seconds since 1970, and the columns; ids and names are texts."""

    number: int
    at_s: float
    event: str
    object: str
    id: str
    associated: str
    associated_id: str
    window: str
    record: Mapping[str, Any] = field(default_factory=dict)
    """Empty: it has none."""

    @property
    def session(self) -> str:
        """The session that it belongs to; empty: it does not say."""
        return str(self.record.get("s", ""))

    @property
    def place(self) -> int:
        """Its place in the session; -1: it does not say."""
        place = self.record.get("n", -1)
        return place if isinstance(place, int) else -1


def line(columns: Sequence[str], record: str) -> str:
    """A line as it is written: the seven columns, a record as JSON, and the check."""
    text = "\t".join((*columns, record))
    return f"{text}\t{_check(text)}"


def read(text: str, file: str) -> tuple[tuple[LogLine, ...], tuple[Fault, ...]]:
    """The lines of one session in its order, with a fault for each line that lacks, was changed, or is of another."""
    faults: list[Fault] = []
    lines = [read for number, raw in _lines(text) if (read := _read(number, raw, file, faults)) is not None]
    begun = beginning(lines)
    session = next((line.session for line in (*begun, *lines) if line.session), "")
    strange = [line for line in lines if line.session not in (session, "")]
    faults += [_fault(file, line.number, "replay.other_session", _LEFT_OUT) for line in strange]
    ours = [line for line in lines if line.session in (session, "")]
    if not session:
        return tuple(ours), tuple(faults)
    named = {fault.place.line for fault in faults}
    bare = (line.number for line in ours if not line.record and line.number not in named)
    faults += [_fault(file, number, "replay.line_cut", "replay.record_left_out") for number in bare]
    ordered = sorted(zip(_places(ours), ours, strict=True), key=lambda pair: pair[0])
    return tuple(_each_once((line for _, line in ordered), file, faults)), tuple(faults)


def beginning(lines: Iterable[LogLine]) -> tuple[LogLine, ...]:
    """The line with which a session begins, where there is one; of several sessions that of the first."""
    return tuple(line for line in lines if isinstance(line.record.get("start"), dict))[:1]


def _places(lines: Iterable[LogLine]) -> Iterator[int]:
    """Where each belongs; one that does not say it, behind the line before it in the file."""
    place = -1
    for line in lines:
        place = line.place if line.place >= 0 else place
        yield place


def _lines(text: str) -> Iterator[tuple[int, str]]:
    """The lines that say something, with their numbers; a header stands at the top of every part of a log."""
    for number, raw in enumerate(text.split("\n"), 1):
        if raw.strip() and not raw.startswith("time\tevent\t"):
            yield number, raw.rstrip("\r")


def _read(number: int, raw: str, file: str, faults: list[Fault]) -> LogLine | None:
    columns = raw.split("\t")
    at_s = _seconds(columns[0])
    if len(columns) < len(COLUMNS) or at_s is None:
        faults.append(_fault(file, number, "replay.no_line", _LEFT_OUT))
        return None
    event, thing, thing_id, associated, associated_id, window = columns[1:7]
    bare = LogLine(number, at_s, event, thing, thing_id, associated, associated_id, window)
    if len(columns) == len(COLUMNS):
        return bare
    record = _record(columns[7])
    if record is None or len(columns) != len(COLUMNS) + 2:
        faults.append(_fault(file, number, "replay.line_cut", "replay.record_left_out"))
        return bare
    if columns[8] != _check("\t".join(columns[:8])):
        faults.append(_fault(file, number, "replay.line_changed", "replay.as_it_stands"))
    return replace(bare, record=record)


def _each_once(ordered: Iterable[LogLine], file: str, faults: list[Fault]) -> Iterator[LogLine]:
    """The lines in their order; what stands twice or lacks is told at the line behind it."""
    expected = 0
    for line in ordered:
        if line.place < 0:  # it has no record, which was told
            yield line
            continue
        if line.place < expected:
            faults.append(_fault(file, line.number, "replay.line_twice", _LEFT_OUT))
            continue
        if line.place > expected:
            gap = Reason.of("replay.lines_lack", first=expected, last=line.place - 1)
            faults.append(Fault(Place(file, line.number), gap, Reason.of("replay.goes_on")))
        expected = line.place + 1
        yield line


def _seconds(word: str) -> float | None:
    try:
        seconds = float(word)
    except ValueError:
        return None
    return seconds if 0 <= seconds < 1e12 else None


def _record(text: str) -> Mapping[str, Any] | None:
    try:
        record = msgspec.json.decode(text)
    except (msgspec.DecodeError, RecursionError):
        return None
    return record if isinstance(record, dict) else None


def _check(text: str) -> str:
    return hashlib.sha256(text.encode(errors="replace")).hexdigest()[:8]


def _fault(file: str, number: int, key: str, instead: str) -> Fault:
    return Fault(Place(file, number), Reason.of(key), Reason.of(instead))
