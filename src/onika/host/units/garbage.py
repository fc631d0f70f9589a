"""The garbage of a unit is collected where it stands in nobody's way: between two cycles, once tasks have ended.

Every task has a class of its own, and a class refers to itself: without a collection the memory of a unit would grow
with every task that ever lived. What was loaded before the first task is not looked at (`still_garbage`).
"""

import gc
from time import monotonic_ns

_FIRST_NS = 400_000
"""What a collection takes, until one has been measured."""
_MARGIN = 2
MOST = 100
"""So much may wait for a gap; then one late cycle is better than memory without end."""


class Garbage:
    """Collected once something was noted, in a gap that is long enough by the last one, or when too much waits."""

    def __init__(self) -> None:
        self._count = 0
        self._took_ns = _FIRST_NS

    def note(self) -> None:
        """Something has ended."""
        self._count += 1

    def collect(self, gap_ns: int | None) -> bool:
        """Collect, if there is something and this gap, None: an endless one, has room for it; whether it was done."""
        has_room = gap_ns is None or gap_ns >= _MARGIN * self._took_ns
        if not self._count or not (has_room or self._count >= MOST):
            return False
        began = monotonic_ns()
        gc.collect()
        self._took_ns = monotonic_ns() - began
        self._count = 0
        return True
