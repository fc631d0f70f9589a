"""How the clock of another runtime stands to the own one, learned from datagrams that go both ways all the time.

The quickest datagram of each direction counts, of the last ten seconds; the two need not belong together. How
lopsided a way is cannot be seen: what is learned is off by half the quickest round trip at most.
"""

from collections import deque

WINDOW_NS = 10_000_000_000
DRIFT_PPM = 50
"""By how much two clocks may part; within the window that comes to half a millisecond."""


class _Least:
    """The least of the values of the window."""

    def __init__(self) -> None:
        self._kept: deque[tuple[int, int]] = deque()

    def add(self, value: int, now_ns: int) -> None:
        kept = self._kept
        while kept and kept[-1][1] >= value:
            kept.pop()
        kept.append((now_ns, value))
        self._forget(now_ns)

    def of(self, now_ns: int) -> int | None:
        self._forget(now_ns)
        return self._kept[0][1] if self._kept else None

    def _forget(self, now_ns: int) -> None:
        kept = self._kept
        while kept and kept[0][0] < now_ns - WINDOW_NS:
            kept.popleft()


class ClockEstimate:
    """Of one other clock; `now_ns` is always the own one."""

    def __init__(self) -> None:
        self._out = _Least()
        self._back = _Least()

    def came(self, sent_ns: int, now_ns: int) -> None:
        """A datagram came that was sent then by the other clock."""
        self._back.add(now_ns - sent_ns, now_ns)

    def went(self, sent_ns: int, heard_ns: int, now_ns: int) -> None:
        """One that was sent by the own clock was heard then by the other one."""
        self._out.add(heard_ns - sent_ns, now_ns)

    def here(self, there_ns: int, now_ns: int) -> int | None:
        """A time of the other clock by the own one; None: nothing is known of it."""
        out, back = self._out.of(now_ns), self._back.of(now_ns)
        return None if out is None or back is None else there_ns - (out - back) // 2

    def trip_ns(self, now_ns: int) -> int | None:
        """The quickest round trip; None: there was none of late."""
        out, back = self._out.of(now_ns), self._back.of(now_ns)
        return None if out is None or back is None else max(0, out + back)

    def bound_ns(self, now_ns: int) -> int | None:
        """By how much `here` may be off."""
        trip_ns = self.trip_ns(now_ns)
        return None if trip_ns is None else trip_ns // 2 + WINDOW_NS * DRIFT_PPM // 1_000_000
