"""How far two recorded runs may lie apart and still be the same (X05)."""

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Tolerance:
    """Values by an amount, or by a part of themselves; times by seconds."""

    value: float = 0.0
    part: float = 0.0
    seconds: float = 0.0

    def covers(self, one: float, low: float, high: float) -> bool:
        """Whether a number lies near enough to what another took on from `low` to `high`."""
        if math.isnan(one) or math.isnan(low):
            return math.isnan(one) and math.isnan(low)
        if low <= one <= high:
            return True
        room = self.value + self.part * max(abs(low), abs(high))
        return max(low - one, one - high) <= room
