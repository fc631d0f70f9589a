"""What time it is for bookings: the machine's clock, but for steps of it while somebody's time runs (F09)."""

from collections.abc import Callable
from time import monotonic_ns, time

STEP_S = 1.0
"""What a clock is corrected by at most without anybody's being told."""


class SiteClock:
    """Seconds of UTC since 1970, which go on evenly for as long as `look` is told that somebody's time runs.

    wall        the machine's clock, in s
    monotonic   one that nobody sets, in ns
    """

    def __init__(self, wall: Callable[[], float] = time, monotonic: Callable[[], int] = monotonic_ns) -> None:
        self._wall = wall
        self._monotonic = monotonic
        self._ahead_s = wall() - monotonic() * 1e-9
        self._known_s = self._ahead_s

    def now_s(self) -> float:
        """The time."""
        return self._monotonic() * 1e-9 + self._ahead_s

    def look(self, *, is_kept: bool) -> float:
        """Follow the machine's clock, unless the time is kept; by how much it was set since the last look, else 0."""
        ahead_s = self._wall() - self._monotonic() * 1e-9
        set_by_s = ahead_s - self._known_s
        self._known_s = ahead_s
        is_set = abs(set_by_s) > STEP_S
        if not is_kept or abs(ahead_s - self._ahead_s) <= STEP_S:
            self._ahead_s = ahead_s
        return set_by_s if is_set else 0.0
