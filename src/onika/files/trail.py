"""The audit trail of a runtime: lines `SHA256 RECORD`, each hash over the one before it and its own record.

A record is a JSON object on one line. A file begins with a record that names the hash it goes on from (`before`), so a
chain leads on from one file to the next. What was cut off in the midst of a line by a crash stays, and the record
after it says so (`torn`, the hash of what is left of it). The chain shows that a line was changed, taken out or put
in between; only who knows its head from elsewhere sees that lines were taken off its end, or that all was written anew.
"""

import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from onika.files.state.state_directory import state_directory
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

_LINE = re.compile(rb"([0-9a-f]{64}) (\{.*\})\n?")
_NO_FILES = 1000

Record = Mapping[str, Any]


@dataclass(slots=True)
class TrailReading:
    """What was read: the records, all that is wrong with the chain, and its head."""

    records: list[Record] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)
    notes: list[Reason] = field(default_factory=list)
    hashes: set[str] = field(default_factory=set)
    head: str = ""
    begins: str = ""
    """The hash that the first file goes on from; empty: it is the first of all."""


def usual_path(environment: Mapping[str, str]) -> Path:
    """Where it lies if nothing else is said: in the state directory."""
    return state_directory(environment) / "audit" / "audit.log"


def line(before: str, record: Record) -> tuple[bytes, str]:
    """A record as a line after the one of that hash, and its own hash."""
    text = json.dumps(record, ensure_ascii=False, separators=(",", ":")).encode("utf-8", "replace")
    own = _hash(before, text)
    return own.encode() + b" " + text + b"\n", own


def torn_hash(raw: bytes) -> str:
    """What stands for a line that is none."""
    return hashlib.sha256(raw.rstrip(b"\n")).hexdigest()


def head_of(tail: bytes) -> tuple[str, bytes]:
    """The hash of the last whole line in the end of a file, and what is torn after it; no hash where there is none."""
    lines = tail.splitlines(keepends=True)
    for at in range(len(lines) - 1, -1, -1):
        match = _LINE.fullmatch(lines[at])
        if match and lines[at].endswith(b"\n"):
            return match[1].decode(), b"".join(lines[at + 1 :])
    return "", tail


def older(path: Path) -> list[Path]:
    """A trail's files, oldest first, the present one last; `FILE.1` is older than `FILE`."""
    numbered = [path.with_name(f"{path.name}.{number}") for number in range(1, _NO_FILES)]
    return [*reversed([path for path in numbered if path.is_file()]), *([path] if path.is_file() else [])]


def beside(path: Path) -> list[Path]:
    """The trail at a path and those beside it (`audit-2.log` …), of runtimes that ran at the same time, by number."""
    numbered: dict[int, Path] = {}
    for file in path.parent.glob(f"{path.stem}-*{path.suffix}*"):
        match = re.fullmatch(rf"({re.escape(path.stem)}-(\d+)){re.escape(path.suffix)}(\.\d+)?", file.name)
        if match is not None:
            numbered[int(match[2])] = path.with_stem(match[1])
    there = [path] if older(path) else []
    return there + [numbered[number] for number in sorted(numbered)]


def read(files: Sequence[Path]) -> TrailReading:
    """Read files one after another and check the chain; raises OSError for what cannot be read."""
    trail = TrailReading()
    for number, path in enumerate(files):
        _read(path.read_bytes(), str(path), trail, is_first=number == 0)
    return trail


def _read(data: bytes, place: str, trail: TrailReading, is_first: bool) -> None:
    torn: list[tuple[int, bytes]] = []
    begins = True
    for number, raw in enumerate(data.splitlines(keepends=True), 1):
        match = _LINE.fullmatch(raw)
        record = _record(match[2]) if match else None
        if match is None or record is None or not raw.endswith(b"\n"):
            torn.append((number, raw))
            continue
        before = str(record.get("before", "")) if begins else trail.head
        if begins:
            _begin(record, Place(place, number), trail, is_first)
        own = match[1].decode()
        if _hash(before, match[2]) != own:
            _fault(trail, place, number, Reason.of("files.trail_not_next"))
        _torn(torn, record, place, trail)
        torn, begins = [], False
        trail.records.append(record)
        trail.hashes.add(own)
        trail.head = own
    for number, raw in torn:
        if raw.endswith(b"\n") or not trail.records:  # a crash leaves one line, without its end, after others
            _fault(trail, place, number, Reason.of("files.trail_no_record"))
        else:
            at = str(Place(place, number))
            trail.notes.append(Reason.of("files.trail_last_line", place=at, count=len(raw)))


def _begin(record: Record, place: Place, trail: TrailReading, is_first: bool) -> None:
    before = str(record.get("before", ""))
    if "before" not in record:
        trail.faults.append(
            Fault(place, Reason.of("files.trail_begins_midst"), Reason.of("files.what_was_before_gone"))
        )
    if is_first:
        trail.begins = before
    elif before != trail.head:
        if before:
            reason = Reason.of("files.trail_file_order", head=trail.head[:12], before=before[:12])
        else:
            reason = Reason.of("files.trail_file_first", head=trail.head[:12])
        trail.faults.append(Fault(place, reason, Reason.of("files.lines_may_be_gone")))


def _torn(torn: Sequence[tuple[int, bytes]], record: Record, place: str, trail: TrailReading) -> None:
    """Lines that are none are in order where the next one knows of them."""
    left = torn_hash(b"".join(raw for _, raw in torn)) if torn else ""
    if torn and record.get("torn") == left:
        trail.notes.append(Reason.of("files.trail_torn", place=str(Place(place, torn[0][0]))))
        return
    for number, _ in torn:
        _fault(trail, place, number, Reason.of("files.trail_no_record"))


def _fault(trail: TrailReading, place: str, number: int, reason: Reason) -> None:
    trail.faults.append(Fault(Place(place, number), reason, Reason.of("files.trail_damaged")))


def _record(text: bytes) -> Record | None:
    try:
        record = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return record if isinstance(record, dict) else None


def _hash(before: str, text: bytes) -> str:
    return hashlib.sha256(before.encode() + b"\n" + text).hexdigest()
