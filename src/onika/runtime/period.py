"""The period of a task in whole nanoseconds (law 13)."""

from math import isfinite

from onika.words.reason import Reason

SLOWEST_GRID_NS = 1_000_000_000
"""The grid of deadlines of a task without a rate."""


def period_of(frequency: float) -> int:
    """The period of a rate in hertz; raises ValueError where there is none."""
    if not 0.0 < frequency <= 1e9:
        raise ValueError(
            Reason.of("runtime.rate_range", frequency=frequency if isfinite(frequency) else str(frequency))
        )
    return round(1e9 / frequency)
