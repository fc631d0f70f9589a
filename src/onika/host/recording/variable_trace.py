"""The trace of a variable: what was written to it of late, as it lies in memory; put into words only if wanted."""

from collections import deque
from typing import NamedTuple

from onika.host.recording.recorded_variable import VariablePlace
from onika.ring.slots import LONGEST_SEALED, Ring
from onika.words.shape import Shape

_PICTURE = 1 << 14
_RARELY_NS = 1_000_000_000
"""A value of more bytes than that is taken no more often than this."""


class _Piece(NamedTuple):
    """What came between two looks: so many values, in slots."""

    before: int
    at: int
    number: int
    slots: bytes


class VariableTrace:
    """`words[0]` counts what was written; times are those of whoever looks, in ns."""

    def __init__(self, subsystem: str, place: VariablePlace, memory: memoryview) -> None:
        self.subsystem = subsystem
        self.place = place
        self.shape = Shape.parse(place.shape)
        self._ring = Ring(memory, place.offset, self.shape.size)
        self._is_long = self.shape.size > LONGEST_SEALED
        self._pause_ns = _RARELY_NS if self.shape.size > _PICTURE else 0
        self._due = -1
        self._seen = 0
        self._pieces: deque[_Piece] = deque()
        self.words = self._ring.words
        self.missed = 0
        """Values that were written over before anybody looked."""
        self.size = 0
        """Bytes that are kept."""

    @property
    def newest_at(self) -> int:
        """When it was taken last that something was written; -1: never."""
        return self._pieces[-1].at if self._pieces else -1

    def take(self, now: int, before: int) -> bool:
        """Keep what was written since the last look; of a long value the newest only. False: it is too early for it."""
        if self._is_long:
            return self._take_newest(now)
        count, number, slots = self._ring.stretch(self._seen)
        if count < self._seen:  # the entry was made anew
            count, number, slots = self._ring.stretch(0)
        else:
            self.missed += count - self._seen - number
        self._seen = count
        self._pieces.append(_Piece(before, now, number, slots))
        self.size += len(slots)
        return True

    def _take_newest(self, now: int) -> bool:
        if now < self._due:
            return False
        self._due = now + self._pause_ns
        value = self._ring.read()
        self._pieces.append(_Piece(now, now, 1, value))
        self.size += len(value)
        return True

    def forget(self, until: int) -> None:
        """Let go of what was written before this time, but for the value that was in force at it."""
        pieces = self._pieces
        while len(pieces) > 1 and pieces[1].at <= until:
            self.size -= len(pieces.popleft().slots)

    def values(self, begin: int) -> tuple[list[int], list[bytes]]:
        """When it changed and to what; what was in force at the begin is said at the begin.

        Times are shared evenly between two looks.
        """
        times: list[int] = []
        values: list[bytes] = []
        for piece in self._pieces:
            stride = len(piece.slots) // piece.number if piece.number else 0
            apart = (piece.at - piece.before) // piece.number if piece.before >= 0 and piece.number else 0
            for place in range(piece.number):
                value = piece.slots[place * stride : place * stride + self.shape.size]
                at = max(piece.at - apart * (piece.number - 1 - place), begin)
                if values and times[-1] == begin == at:
                    values[-1] = value
                elif not values or value != values[-1]:
                    times.append(at)
                    values.append(value)
        return times, values
