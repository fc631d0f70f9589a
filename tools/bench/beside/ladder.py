"""Climbing a ladder: one figure at growing sizes, the sizes round about."""

from dataclasses import dataclass
from statistics import median

from beside.contestant import Contestant, Figures
from beside.contests import Ladder


@dataclass(frozen=True, slots=True)
class Rung:
    """What was found at one size."""

    size: int
    figure: float
    share: float | None


def climb(ladder: Ladder, rounds: int, *, is_quick: bool = False) -> list[Rung]:
    """Measure every size in every round; medians. Raises `Absent` where it cannot be measured here."""
    sizes = ladder.quick_sizes if is_quick else ladder.sizes
    found: dict[int, list[Figures]] = {size: [] for size in sizes}
    contestant = Contestant(ladder.module)
    try:
        for number in range(rounds + 1):  # the first one warms up
            for size in sizes:
                figures = contestant.measure(size)
                if number:
                    found[size].append(figures)
    finally:
        contestant.end()
    return [_rung(ladder, size, figures) for size, figures in found.items()]


def _rung(ladder: Ladder, size: int, figures: list[Figures]) -> Rung:
    share = median(float(one[ladder.share]) for one in figures) if ladder.share else None  # type: ignore[arg-type]
    return Rung(size, median(float(one["figure"]) for one in figures), share)  # type: ignore[arg-type]
