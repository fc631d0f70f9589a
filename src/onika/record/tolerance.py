"""The tolerance within which two recorded runs count as the same (X05).

Measured of the same program in wall time, on a busy machine: places repeat to 0.0013 rad or m, references to 0.0001,
times to 0.05 s. Speeds and torques that are measured do not repeat at all: for an instant each may be anything up to
its greatest value, because a cycle was late.
"""

import math
from dataclasses import dataclass

_RATES = ("/s", "/s^2", "/s²")
_FORCES = ("N", "N m", "Nm")


@dataclass(frozen=True, slots=True)
class Tolerance:
    """Values by an amount, or by a part of themselves; times by seconds."""

    value: float = 0.0
    part: float = 0.0
    seconds: float = 0.0
    is_of_places: bool = False
    """Whether speeds and forces are left out: they tell of disturbances; what they lead to is compared in any case."""

    def leaves_out(self, unit: str, count: int) -> list[bool]:
        """For each element of a variable of this unit, or of these, whether it is not compared."""
        units = [part.strip() for part in unit.split(",")]
        if not self.is_of_places or len(units) not in (1, count):
            return [False] * count
        are_rates = [unit_name.endswith(_RATES) or unit_name in _FORCES for unit_name in units]
        if len(units) == count:
            return are_rates
        return are_rates * count

    def covers(self, value: float, low: float, high: float) -> bool:
        """Whether a number lies near enough to what another took on from `low` to `high`."""
        if math.isnan(value) or math.isnan(low):
            return math.isnan(value) and math.isnan(low)
        if low <= value <= high:
            return True
        room = self.value + self.part * max(abs(low), abs(high))
        return max(low - value, value - high) <= room


EXACT = Tolerance()
"""Between two runs in virtual time."""
WALL = Tolerance(0.002, 0.001, 0.1, is_of_places=True)
"""Between two runs of the same program of which one at least was in wall time."""


def usual(is_virtual: bool, value: float | None, part: float | None, seconds: float | None) -> Tolerance:
    """As asked; else two runs of the simulator may not differ at all, and in wall time no run is like another.

    Whoever says by how much values may differ has all of them compared.
    """
    default = EXACT if is_virtual else WALL
    return Tolerance(
        default.value if value is None else value,
        default.part if part is None else part,
        default.seconds if seconds is None else seconds,
        default.is_of_places and value is None and part is None,
    )
