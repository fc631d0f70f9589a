"""Units in which people read and type what files and links hold in SI units (requirement G08)."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import pi

UNITS: Mapping[str, Mapping[str, float]] = {
    "angle_unit": {"rad": 1.0, "deg": 180.0 / pi},
    "length_unit": {"m": 1.0, "cm": 100.0, "mm": 1000.0},
}
"""By preference: the units to choose from, the first of which is that of files, and how many of each it is worth."""

RATES = ("", "/s", "/s^2")
"""What may stand behind such a unit; others, as in `N m/rad`, are read as they are."""


@dataclass(frozen=True, slots=True)
class UnitScale:
    """A unit as people see it: its name, and by what an SI value is multiplied; of a list, element by element."""

    name: str
    factors: tuple[float, ...]

    @property
    def is_plain(self) -> bool:
        """Whether values are read as they are."""
        return all(factor == 1.0 for factor in self.factors)


def scale(unit: str, choices: Mapping[str, str]) -> UnitScale:
    """How values of a unit, or of a list of units as in `m,m/s,N`, are read where these units are preferred."""
    parts = [_part(part.strip(), choices) for part in unit.split(",")]
    return UnitScale(",".join(name for name, _ in parts), tuple(factor for _, factor in parts))


def _part(unit: str, choices: Mapping[str, str]) -> tuple[str, float]:
    for preference, units in UNITS.items():
        files, chosen = next(iter(units)), choices.get(preference, "")
        rate = unit.removeprefix(files)
        if unit.startswith(files) and rate in RATES and chosen in units:
            return chosen + rate, units[chosen]
    return unit, 1.0
