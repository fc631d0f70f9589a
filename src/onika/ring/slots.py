"""One entry of shared memory: a ring of slots that one writer fills and any reader reads without waiting.

The first line of 64 bytes holds a guard, the counters and four seals; the slots follow, each a multiple of 64 bytes:
sixty-four, so that who looks now and then misses nothing even if he is late, and four where a value is long. The writer
fills the slot behind the current one and then moves the counter, so a dead writer blocks nobody. A copy is good unless
the writer came round meanwhile, which a reader sees by the counter. The order of stores is kept by x86-64; other
processors would need a fence (law 31).
"""

from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple
from zlib import crc32

from onika.words.reason import Reason

LINE = 64
_SLOTS, _LONG_SLOTS = 64, 4
_SEAL = 3
"""Of a count, the bits that tell its seal."""
_WORD = 8
_GUARD = 0x4B_61_72_61_6B_61_73_21
"""Stands before the counters of an armed entry, mixed with its place: what runs over from below meets it first."""
SEALS, STRANGE = 2, 6
"""Places among the words: of the seals, and of the number of times that somebody else had published (its lower
half; the upper one holds the count at which the entry was put to rest, doubled, plus 1; 0 while it is in use)."""
_COUNTED = 0xFFFF_FFFF
"""A seal is a checksum and, above it, these bits of the count it belongs to; one of another count seals nothing."""
LONGEST_SEALED = 512
"""A longer value is sealed at rest only: a checksum would cost more than to copy it."""
ATTEMPTS = 64
"""How often a slot is looked at that is written meanwhile; then it is left alone."""


class Signed(NamedTuple):
    """The end of an entry's declared writer."""

    publish: Callable[[], None]
    """Publish what lies in the source; counts as strange whatever was published by others since the last time."""
    look: Callable[[], None]
    """Take the entry as it stands: what others published until now was their right."""
    own: list[int]
    """The count of its newest publication, alone in a list: whoever publishes in its place keeps it."""


class Ring:
    """An entry of `size` bytes at `offset` of a shared view; `words` holds its counter and its mark.

    Raises ValueError where the view has no room for it.
    """

    def __init__(self, view: memoryview, offset: int, size: int) -> None:
        stride, count = _stride(size), _slots(size)
        if offset < 0 or offset + Ring.footprint(size) > len(view):
            raise ValueError(f"expected {Ring.footprint(size)} bytes of room at {offset}, found {len(view)} in all")
        self.size = size
        self.stride = stride
        """Bytes from one slot to the next."""
        self.offset = offset
        self._guard = view[offset : offset + _WORD].cast("Q")
        self.words = view[offset + _WORD : offset + LINE].cast("Q")
        first = offset + LINE
        self._memory = view[first : first + count * stride]
        self.slots = tuple(map(self._memory.__getitem__, _places(size)))
        """Where the values lie; that of a count lies in the slot `count & last`."""
        self.last = count - 1

    @staticmethod
    def footprint(size: int) -> int:
        """Bytes that an entry of `size` bytes takes in memory."""
        return LINE + _slots(size) * _stride(size)

    def release(self) -> None:
        """Hold the memory no longer; nobody reads or writes by this ring any more."""
        for view in (self._guard, self.words, self._memory, *self.slots):
            view.release()

    @property
    def count(self) -> int:
        """How often the entry was written."""
        return self.words[0]

    @property
    def mark(self) -> int:
        """The count at which its value was last forgotten: what was written before is no longer in force."""
        return self.words[1]

    def forget(self) -> None:
        """Mark the present value as no longer in force; readers still see it."""
        self.words[1] = self.words[0]

    # Integrity

    def arm(self) -> None:
        """Put the guard in its place: once, by the owner of the memory."""
        self._guard[0] = _GUARD ^ self.offset

    def faults(self) -> list[Reason]:
        """What is wrong with the entry's memory; while it is written too. Only of an armed entry."""
        faults_: list[Reason] = []
        if self._guard[0] != _GUARD ^ self.offset:
            faults_.append(Reason.of("runtime.guard_overwritten"))
        strange = self.words[STRANGE] & _COUNTED
        if strange:
            faults_.append(Reason.of("runtime.strangely_published", count=strange))
        blank = bytes(self.stride - self.size)
        ends = range(self.stride, len(self._memory) + 1, self.stride)
        if any(self._memory[end - len(blank) : end] != blank for end in ends):
            faults_.append(Reason.of("runtime.between_overwritten"))
        if self._is_broken():
            faults_.append(Reason.of("runtime.value_strange"))
        if self._is_behind():
            faults_.append(Reason.of("runtime.counter_put_back"))
        elif self._is_moved():
            faults_.append(Reason.of("runtime.counter_moved"))
        return faults_

    def _is_moved(self) -> bool:
        """Whether an entry at rest counts something else than when it was put to rest."""
        for _ in range(ATTEMPTS):
            rest, count = self.words[STRANGE] >> 32, self.words[0]
            if self.words[STRANGE] >> 32 == rest:
                return rest != 0 and rest != _rest(count)
        return False

    def _is_behind(self) -> bool:
        """Whether something was sealed later than the counter tells; one that is about to be published is not."""
        for _ in range(ATTEMPTS):
            count = self.words[0]
            ahead = [((self.words[SEALS + i] >> 32) - count) & _COUNTED for i in range(_SEAL + 1)]
            if self.words[0] == count:
                return any(1 < distance < _COUNTED >> 1 for distance in ahead)
        return False

    def _is_broken(self) -> bool:
        """Whether one of the slots that are not being written is another than its seal says."""
        words = self.words
        for _ in range(ATTEMPTS):
            count = words[0]
            last = range(max(1, count - 2), count + 1)
            slots = [(n, words[SEALS + (n & _SEAL)], bytes(self.slots[n & self.last])) for n in last]
            if words[0] == count:  # the writer was not in the oldest of them yet
                return any(seal >> 32 == n & _COUNTED and seal != seal_of(data, n) for n, seal, data in slots)
        return False

    def seal(self) -> None:
        """Seal the present value, long ones too; an entry that was at rest may be written from now on."""
        count = self.words[0]
        self._use()
        if count:
            self.words[SEALS + (count & _SEAL)] = seal_of(self.slots[count & self.last], count)

    def rest(self) -> None:
        """Seal the present value and note the count: nobody writes the entry until a writer looks at it."""
        words = self.words
        count = words[0]
        if count:
            seal = crc32(self.slots[count & self.last], count)  # as `seal_of` and `_rest`, without a call: each switch
            words[SEALS + (count & _SEAL)] = (count & _COUNTED) << 32 | seal
        words[STRANGE] = words[STRANGE] & _COUNTED | ((count << 1 | 1) & _COUNTED) << 32

    def _use(self) -> None:
        self.words[STRANGE] &= _COUNTED

    # Values

    def write(self, source: memoryview | bytes) -> None:
        """Publish a value of exactly `size` bytes. One writer at a time, which its owner sees to."""
        self.writer(memoryview(source).cast("B"))()

    def read(self) -> bytes:
        """A whole copy of the newest value (zeros before the first write)."""
        target = bytearray(self.size)
        self.reader(memoryview(target))()
        return bytes(target)

    def since(self, seen: int) -> tuple[int, list[bytes]]:
        """The count, and the values published after the count `seen`, oldest first, as far as they still lie here."""
        words, slots, last = self.words, self.slots, self.last
        while True:
            count: int = words[0]
            first = max(seen + 1, count - last + 1)
            values = [bytes(slots[n & last]) for n in range(first, count + 1)]
            if words[0] - first < last:
                return count, values

    def stretch(self, seen: int) -> tuple[int, int, bytes]:
        """The same as `since` in one piece: the count, how many values, and their slots as they lie, oldest first.

        A slot takes `stride` bytes. To copy them so costs a tenth of what it costs to take them apart.
        """
        words, memory, last, stride = self.words, self._memory, self.last, self.stride
        while True:
            count: int = words[0]
            first = max(seen + 1, count - last + 1)
            if first > count:
                return count, 0, b""
            begin, end = (first & last) * stride, ((count & last) + 1) * stride
            slots = bytes(memory[begin:end]) if begin < end else bytes(memory[begin:]) + bytes(memory[:end])
            if words[0] - first < last:
                return count, count - first + 1, slots

    def writer(self, source: memoryview) -> Callable[[], None]:
        """A fast function that publishes what lies in `source` (bytes, `size` of them) at the time of the call."""
        words, slots, last = self.words, self.slots, self.last
        _check(source, self.size)

        def publish() -> None:
            count = words[0] + 1
            slots[count & last][:] = source
            words[0] = count

        return publish

    def signed_writer(self, source: memoryview) -> Signed:
        """As `writer`, for the one whose entry it is: publications of others are noticed.

        One in eight short values is sealed; to seal each would cost a task more than the check is worth.
        """
        words, slots, last = self.words, self.slots, self.last
        _check(source, self.size)
        own = [words[0]]
        is_short = self.size <= LONGEST_SEALED

        def publish() -> None:
            count = words[0]
            if count != own[0]:
                words[STRANGE] += 1
            count += 1
            slots[count & last][:] = source
            if not count & 7 and is_short:
                words[SEALS] = (count & _COUNTED) << 32 | crc32(source, count)  # as `seal_of`, without a call
            words[0] = own[0] = count

        def look() -> None:
            words[STRANGE] &= _COUNTED  # as `_use`, without a call
            own[0] = words[0]

        return Signed(publish, look, own)

    def reader(self, target: memoryview) -> Callable[[], int]:
        """A fast function that copies the newest value into `target` and returns the count it belongs to."""
        words, slots, last = self.words, self.slots, self.last
        _check(target, self.size)

        def fetch() -> int:
            while True:
                count: int = words[0]
                target[:] = slots[count & last]
                if words[0] - count < last:
                    return count

        return fetch

    def refresher(self, target: memoryview) -> Callable[[], None]:
        """As `reader`, for a buffer that nothing else fills: nothing is copied where nothing new was written."""
        words, slots, last = self.words, self.slots, self.last
        _check(target, self.size)
        seen = -1

        def refresh() -> None:
            nonlocal seen
            while seen != (count := words[0]):
                target[:] = slots[count & last]
                if words[0] - count < last:
                    seen = count
                    return

        return refresh


def seal_of(data: memoryview | bytes, count: int) -> int:
    """What is kept in a seal of a value and the count it belongs to."""
    return (count & _COUNTED) << 32 | crc32(data, count)


def _rest(count: int) -> int:
    return (count << 1 | 1) & _COUNTED


def last_of(size: int) -> int:
    """The bits of a count that tell the slot of its value, where a value has so many bytes."""
    return _slots(size) - 1


def _slots(size: int) -> int:
    return _SLOTS if size <= LONGEST_SEALED else _LONG_SLOTS


@lru_cache
def _places(size: int) -> tuple[slice, ...]:
    """Where the slots lie, from the first one on."""
    stride = _stride(size)
    return tuple(slice(first, first + size) for first in range(0, _slots(size) * stride, stride))


def _stride(size: int) -> int:
    return -(-size // LINE) * LINE


def _check(buffer: memoryview, size: int) -> None:
    if buffer.format != "B" or buffer.nbytes != size:
        raise ValueError(f"expected a buffer of {size} bytes, found {buffer.nbytes} of format {buffer.format!r}")
