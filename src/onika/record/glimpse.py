"""What a recording is, at a glance at both of its ends: of whom, since when, how long; for lists of many."""

from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from struct import Struct
from typing import BinaryIO

from mcap.data_stream import ReadDataStream
from mcap.opcode import Opcode
from mcap.records import Metadata, Statistics

from onika.record.reader import Reader
from onika.record.run import NOTE
from onika.record.writer import MAGIC

_RECORD = Struct("<BQ")
_FOOTER = Struct("<BQQQI")
_FIRST = 8
"""The note stands among so many first records."""


@dataclass(frozen=True, slots=True)
class Glimpse:
    """`began` is ISO 8601."""

    application: str
    began: str
    took_s: float
    is_whole: bool


def glimpse(path: Path) -> Glimpse:
    """Raises what `reader.UNREADABLE` names where it is no recording of a run."""
    with path.open("rb") as stream:
        if stream.read(len(MAGIC)) != MAGIC:
            raise ValueError(f"{path}: expected a recording (MCAP), found something else")
        words = _note(stream)
        last_ns = _last_ns(stream)
    if words is None:
        raise ValueError(f"{path}: expected a recording of a run, found none in this file")
    is_whole = last_ns is not None
    if last_ns is None:
        reader = Reader(path)
        last_ns = reader.span[1]
        reader.close()
    return Glimpse(words.get("application", ""), words.get("began", ""), last_ns * 1e-9, is_whole)


def _note(stream: BinaryIO) -> dict[str, str] | None:
    for _ in range(_FIRST):
        opcode, length = _RECORD.unpack(stream.read(_RECORD.size))
        body = stream.read(length)
        if opcode == Opcode.METADATA:
            note = Metadata.read(_data(body))
            if note.name == NOTE:
                return dict(note.metadata)
    return None


def _last_ns(stream: BinaryIO) -> int | None:
    """The time of the last message, as the summary says it; None: there is no summary."""
    size = stream.seek(0, 2)
    ends_at = size - len(MAGIC) - _FOOTER.size
    if ends_at <= 0:
        return None
    stream.seek(ends_at)
    opcode, _, at, _, _ = _FOOTER.unpack(stream.read(_FOOTER.size))
    if stream.read() != MAGIC or opcode != Opcode.FOOTER:
        return None
    while at < ends_at:
        stream.seek(at)
        opcode, length = _RECORD.unpack(stream.read(_RECORD.size))
        if opcode == Opcode.STATISTICS:
            return int(Statistics.read(_data(stream.read(length))).message_end_time)
        at += _RECORD.size + length
    return None


def _data(body: bytes) -> ReadDataStream:
    return ReadDataStream(BytesIO(body))
