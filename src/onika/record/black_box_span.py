"""The span of a black box: from when to when of its run it holds everything, and whether the run went on (X05)."""

from collections.abc import Mapping
from dataclasses import dataclass

from onika.record.run import BLACK_BOX, END

_MOST_DIGITS = 18
SEEN_WITHIN_S = 0.03
"""What is kept of a value is kept at looks; when it was written in between is shared evenly."""


@dataclass(frozen=True, slots=True)
class BlackBoxSpan:
    """Times are ns of the run."""

    begin_ns: int
    end_ns: int
    goes_on: bool
    """Whether it was written at a fault after which the run went on."""

    @classmethod
    def of(cls, notes: Mapping[str, Mapping[str, str]]) -> "BlackBoxSpan | None":
        """Of the notes of a recording; None: it holds a run from its beginning."""
        note = notes.get(BLACK_BOX)
        if note is None:
            return None
        begin_ns, end_ns = _number(note.get("from_ns", "")), _number(note.get("to_ns", ""))
        return cls(begin_ns, max(begin_ns, end_ns), notes.get(END, {}).get("goes_on") == "yes")


def _number(text: str) -> int:
    """The nanoseconds that a file gives; 0 for what are none."""
    if text.isascii() and text.isdecimal() and len(text) <= _MOST_DIGITS:
        return int(text)
    return 0
