"""One entry of shared memory: a ring of four slots that one writer fills and any reader reads without waiting.

The first line of 64 bytes holds two counters; the slots follow, each a multiple of 64 bytes. The writer fills the slot
behind the current one and then moves the counter, so a dead writer blocks nobody. A copy is good unless the writer came
round meanwhile, which a reader sees by the counter. The order of stores is kept by x86-64; other processors would need
a fence (law 31).
"""

from collections.abc import Callable

LINE = 64
_SLOTS = 4


class Ring:
    """An entry of `size` bytes at `offset` of a shared view; `words` holds its counter and its mark."""

    def __init__(self, view: memoryview, offset: int, size: int) -> None:
        stride = _stride(size)
        self.size = size
        self.words = view[offset : offset + LINE].cast("Q")
        first = offset + LINE
        self._slots = tuple(view[first + i * stride : first + i * stride + size] for i in range(_SLOTS))

    @staticmethod
    def footprint(size: int) -> int:
        """Bytes that an entry of `size` bytes takes in memory."""
        return LINE + _SLOTS * _stride(size)

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

    def write(self, source: memoryview | bytes) -> None:
        """Publish a value of exactly `size` bytes. One writer at a time, which its owner sees to."""
        self.writer(memoryview(source).cast("B"))()

    def read(self) -> bytes:
        """A whole copy of the newest value (zeros before the first write)."""
        target = bytearray(self.size)
        self.reader(memoryview(target))()
        return bytes(target)

    def writer(self, source: memoryview) -> Callable[[], None]:
        """A fast function that publishes what lies in `source` (bytes, `size` of them) at the time of the call."""
        words, slots = self.words, self._slots
        _check(source, self.size)

        def publish() -> None:
            count = words[0] + 1
            slots[count & 3][:] = source
            words[0] = count

        return publish

    def reader(self, target: memoryview) -> Callable[[], int]:
        """A fast function that copies the newest value into `target` and returns the count it belongs to."""
        words, slots = self.words, self._slots
        _check(target, self.size)

        def fetch() -> int:
            while True:
                count: int = words[0]
                target[:] = slots[count & 3]
                if words[0] - count < 3:
                    return count

        return fetch

    def refresher(self, target: memoryview) -> Callable[[], None]:
        """As `reader`, for a buffer that nothing else fills: nothing is copied where nothing new was written."""
        words, slots = self.words, self._slots
        _check(target, self.size)
        seen = -1

        def refresh() -> None:
            nonlocal seen
            while seen != (count := words[0]):
                target[:] = slots[count & 3]
                if words[0] - count < 3:
                    seen = count
                    return

        return refresh


def _stride(size: int) -> int:
    return -(-size // LINE) * LINE


def _check(buffer: memoryview, size: int) -> None:
    if buffer.format != "B" or buffer.nbytes != size:
        raise ValueError(f"expected a buffer of {size} bytes, found {buffer.nbytes} of format {buffer.format!r}")
