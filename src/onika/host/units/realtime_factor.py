"""The real-time factor: how far a virtual clock may go as wall time passes (law 15, requirement A16)."""

SLOWEST, FASTEST = 0.01, 1000.0

_MOST_NS = 200_000_000
"""So much wall time counts at once at most: a stall stretches a motion and never jumps."""


class RealtimeFactor:
    """Virtual time passes `scale` times as fast as wall time, which is handed in (ns, a clock that never goes back)."""

    def __init__(self, scale: float, now: int, wall_ns: int) -> None:
        if not SLOWEST <= scale <= FASTEST:
            raise ValueError(f"expected a scale of {SLOWEST:g} to {FASTEST:g}, found {scale:g}")
        self._scale = scale
        self._allowed = float(now)
        self._wall = wall_ns

    def allowed(self, wall_ns: int, stands: bool) -> int:
        """Up to when the clock may go; while it stands nothing is saved up for later."""
        passed, self._wall = wall_ns - self._wall, wall_ns
        if not stands:
            self._allowed += min(passed, _MOST_NS) * self._scale
        return int(self._allowed)

    def follow(self, now: int, wall_ns: int) -> None:
        """The clock has gone further than it may by itself: from here on it goes as wall time passes."""
        if now > self._allowed:
            self._allowed, self._wall = float(now), wall_ns

    def wait_s(self, until: int) -> float:
        """How long the clock takes to a time from where it is."""
        return max(0.0, (until - self._allowed) * 1e-9 / self._scale)
