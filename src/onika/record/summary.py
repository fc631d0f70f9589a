"""The summary of a recording, for lists of many: of which application, since when, how long."""

from dataclasses import dataclass
from io import SEEK_END
from itertools import islice
from pathlib import Path
from typing import BinaryIO

from mcap.reader import FOOTER_SIZE
from mcap.records import Footer, Metadata, Statistics
from mcap.stream_reader import MAGIC_SIZE, StreamReader

from onika.record.black_box_span import BlackBoxSpan
from onika.record.reader import UNREADABLE, Reader
from onika.record.run import NOTE
from onika.record.stored import unfit
from onika.words.reason import Reason

_FIRST = 8
"""The note stands among so many first records."""


@dataclass(frozen=True, slots=True)
class Summary:
    """`began` is ISO 8601."""

    application: str
    began: str
    took_s: float
    is_whole: bool
    is_black_box: bool
    lasted_s: float
    """How much of the run is in it; all of it, unless it is a black box."""


def summary(path: Path) -> Summary:
    """Raises what `reader.UNREADABLE` names where it is no recording of a run."""
    with path.open("rb") as stream:
        notes = _notes(stream)
        last_ns = _last_ns(stream)
    words, held = notes.get(NOTE), BlackBoxSpan.of(notes)
    if words is None:
        raise unfit(path, Reason.of("record.no_run", given=Reason.of("record.none_in_file")))
    is_whole = last_ns is not None
    if last_ns is None:
        reader = Reader(path)
        last_ns = reader.span[1]
        reader.close()
    begin_ns = 0 if held is None else held.begin_ns
    return Summary(
        words.get("application", ""),
        words.get("began", ""),
        last_ns * 1e-9,
        is_whole,
        held is not None,
        max(last_ns - begin_ns, 0) * 1e-9,
    )


def _notes(stream: BinaryIO) -> dict[str, dict[str, str]]:
    """Those that stand first, up to the one of the run."""
    notes: dict[str, dict[str, str]] = {}
    for record in islice(StreamReader(stream, emit_chunks=True).records, _FIRST):
        if isinstance(record, Metadata) and NOTE not in notes:
            notes[record.name] = dict(record.metadata)
    return notes


def _last_ns(stream: BinaryIO) -> int | None:
    """The time of the last message, as the file's own summary says it; None: it was cut short and has none.

    The summary is read up to its statistics only: an index of every chunk follows, which is long in a long recording.
    """
    try:
        stream.seek(-(FOOTER_SIZE + MAGIC_SIZE), SEEK_END)
        (footer,) = StreamReader(stream, skip_magic=True).records
        if not isinstance(footer, Footer) or not footer.summary_start:
            return None
        stream.seek(footer.summary_start)
        records = StreamReader(stream, skip_magic=True).records
        return next((int(record.message_end_time) for record in records if isinstance(record, Statistics)), None)
    except UNREADABLE:
        return None
