"""How much before its time a processing unit is woken: about as much as the system is late with it.

A unit that is woken when a cycle is due begins it as late as the system and cold caches make it, 30 to 80 us on a usual
machine. Woken so much earlier it waits for the instant itself. Only under SCHED_FIFO: a process that shares its
processor would lose by it what it is owed when others are busy.
"""

_LONGEST_NS = 100_000
_SHARE = 20
"""Of a gap between cycles a twentieth at most is waited through awake."""
_STEP_NS = 2_000
_AHEAD = 0.99
"""The share of wake-ups that shall come before the instant."""


class EarlyWake:
    """The lead of a unit's wake-ups, by how late those were until now."""

    def __init__(self) -> None:
        self._lead_ns = 0.0

    def lead_ns(self, gap_ns: int) -> int:
        """By how much to be woken before the end of a gap; the rest is waited for awake."""
        return min(int(self._lead_ns), gap_ns // _SHARE)

    def note(self, late_ns: int) -> None:
        """So much later than it was asked for came a wake-up: the lead follows the 99 % of all (a running quantile)."""
        is_within = late_ns <= self._lead_ns
        self._lead_ns += _STEP_NS * (_AHEAD - 1.0 if is_within else _AHEAD)
        self._lead_ns = min(max(self._lead_ns, 0.0), float(_LONGEST_NS))
