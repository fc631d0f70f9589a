"""Chooses the tolerance of a demand from how much a value differs in equally good runs (requirement X07)."""

import math
from collections.abc import Sequence

from onika.desk.trial.variables import FLOORS
from onika.model.kept import Demand

LASTS_S = 0.05
"""How exactly a duration is asked for at least; two cycles of the slowest trigger."""

_MARGIN = 2.0
"""How many times as far as was seen a value may lie away: few runs do not show the farthest."""

_WORTH = 10.0
"""How many times its floor a tolerance may be: what varies more tells nothing, and is not asked for."""


def tolerance(floor: float, spread: float) -> float | None:
    """A readable tolerance for what differed by `spread`; None where it varies too much to be asked for."""
    wanted = max(floor, _MARGIN * spread)
    if wanted <= _WORTH * floor:
        return upwards(wanted)
    return None


def demand(address: str, unit: str, is_real: bool, runs: Sequence[tuple[float, ...]]) -> Demand | None:
    """What to ask of a variable that was this in several runs, the first of which is kept; None: nothing."""
    kept, *others = runs
    spread = max((abs(a - b) for other in others for a, b in zip(other, kept, strict=False)), default=0.0)
    if not all(map(math.isfinite, (*kept, spread))):
        return None
    if not is_real:
        return Demand(address, kept) if not spread else None
    within = tolerance(FLOORS[unit], spread) if unit in FLOORS else None
    shown = "" if unit == "-" else unit
    if within is None:
        return None
    return Demand(address, tuple(readable(number, within) for number in kept), shown, within)


def readable(value: float, within: float) -> float:
    """A value with no more digits than its tolerance has: 0.1124 within 0.002 is 0.112."""
    return round(value, -math.floor(math.log10(within))) + 0.0


def upwards(value: float) -> float:
    """The next number above that begins with 1, 2 or 5 and nothing behind: 0.013 becomes 0.02."""
    power = 10.0 ** math.floor(math.log10(value))
    step = next(digit for digit in (1, 2, 5, 10) if digit * power >= value * (1 - 1e-9))
    return float(f"{step * power:.1g}")
