"""The samples of a variable: each value that was written of late, with its number and its time, in bounded memory."""

from collections import deque
from typing import NamedTuple

from onika.ring.slots import Ring
from onika.wire.samples import KEPT_NS, SampleStretch

MOST_BYTES = 1 << 20
"""Of one variable so much is kept: 30 s of a joint vector written 500 times a second."""
MOST_SENT = 1 << 16
"""Bytes of values that one answer holds of a variable."""


class _Piece(NamedTuple):
    """What came between two looks."""

    stretch: SampleStretch
    slots: bytes

    @property
    def last(self) -> int:
        """The number of its last value."""
        return self.stretch.first + self.stretch.count - 1


class SampleHistory:
    """`take` looks at the ring; it misses nothing where it is called before the writer has gone round.

    Times: in virtual time that of the instant. In wall time the values of a task come as evenly as its period, as long
    as that lies between the two looks that they were found between; else they are shared evenly.
    """

    def __init__(self, ring: Ring) -> None:
        self._size = ring.size
        self._stride = ring.stride
        self._seen = max(ring.count - 1, 0)  # the value in force is the first one
        self._pieces: deque[_Piece] = deque()
        self._bytes = 0
        self._last = 0
        self._last_ns = -1

    @property
    def is_empty(self) -> bool:
        """Whether nothing is kept."""
        return not self._pieces

    def take(self, ring: Ring, now: int, before: int, period_ns: int) -> None:
        """Keep what was written since the last look, which was at `before`; `period_ns` is 0 where nobody knows it."""
        if ring.count < self._seen:  # the entry was made anew
            self._seen = 0
        count, number, slots = ring.stretch(self._seen)
        if not number:
            return
        missed = count - self._seen - number
        self._seen = count
        self._keep(number, missed, slots, self._moment(number, missed, now, before, period_ns))
        self._forget(now - KEPT_NS)

    def since(self, after: int) -> tuple[tuple[SampleStretch, ...], bytes]:
        """The values whose numbers come after this one, as many as one answer holds; all, where it is not there yet."""
        if after > self._last:
            after = 0
        stretches: list[SampleStretch] = []
        values = bytearray()
        for piece in self._pieces:
            skipped = max(after + 1 - piece.stretch.first, 0)
            if skipped >= piece.stretch.count:
                continue
            if len(values) >= MOST_SENT:
                break
            _append(stretches, _without(piece.stretch, skipped))
            for at in range(skipped * self._stride, len(piece.slots), self._stride):
                values += piece.slots[at : at + self._size]
        return tuple(stretches), bytes(values)

    # Inner

    def _moment(self, number: int, missed: int, now: int, before: int, period_ns: int) -> tuple[int, int]:
        """When the last of these values came, and how far apart they are."""
        expected = self._last_ns + (number + missed) * period_ns
        if period_ns and self._last_ns >= 0 and before < expected <= now:
            return expected, period_ns
        since = max(self._last_ns, before - period_ns)
        step = (now - since) // (number + missed) if since >= 0 else period_ns
        return now, min(step, period_ns) if period_ns else step

    def _keep(self, number: int, missed: int, slots: bytes, moment: tuple[int, int]) -> None:
        last_ns, step_ns = moment
        first = self._last + missed + 1
        stretch = SampleStretch(first, last_ns - (number - 1) * step_ns, step_ns, number)
        self._pieces.append(_Piece(stretch, slots))
        self._bytes += len(slots)
        self._last, self._last_ns = first + number - 1, last_ns

    def _forget(self, until: int) -> None:
        pieces = self._pieces
        while len(pieces) > 1 and (pieces[1].stretch.begin_ns <= until or self._bytes > MOST_BYTES):
            self._bytes -= len(pieces.popleft().slots)


def _without(stretch: SampleStretch, skipped: int) -> SampleStretch:
    """The same without its first values."""
    begin_ns = stretch.begin_ns + skipped * stretch.step_ns
    return SampleStretch(stretch.first + skipped, begin_ns, stretch.step_ns, stretch.count - skipped)


def _append(stretches: list[SampleStretch], stretch: SampleStretch) -> None:
    """Append it, to the one before where it goes on as that did."""
    if stretches and _goes_on(stretches[-1], stretch):
        before = stretches[-1]
        step_ns = _step(before, stretch)
        stretches[-1] = SampleStretch(before.first, before.begin_ns, step_ns, before.count + stretch.count)
    else:
        stretches.append(stretch)


def _goes_on(before: SampleStretch, stretch: SampleStretch) -> bool:
    step_ns = _step(before, stretch)
    is_next = stretch.first == before.first + before.count
    is_even = stretch.count == 1 or stretch.step_ns == step_ns
    return is_next and is_even and before.begin_ns + before.count * step_ns == stretch.begin_ns


def _step(before: SampleStretch, stretch: SampleStretch) -> int:
    """How far apart values are; of one alone that is not known yet."""
    return before.step_ns if before.count > 1 else stretch.begin_ns - before.begin_ns
