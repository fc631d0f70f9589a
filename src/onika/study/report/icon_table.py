"""How long which icon took to be selected: what is hard to find stands out (§6.2.2.4; requirement H02)."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import fmean

from onika.study.subject import Subject


@dataclass(frozen=True, slots=True)
class IconTimes:
    """An icon: how often it was selected meaningfully, and how long that took, in seconds."""

    name: str
    count: int
    mean_s: float
    longest_s: float


def icons_of(subjects: Sequence[Subject]) -> list[IconTimes]:
    """All icons that subjects who are compared have selected, the slowest first."""
    times: dict[str, list[float]] = {}
    for subject in [subject for subject in subjects if subject.is_compared]:
        for selection in subject.selections:
            times.setdefault(selection.icon, []).append(selection.seconds)
    rows = [IconTimes(name, len(values), fmean(values), max(values)) for name, values in times.items()]
    return sorted(rows, key=lambda icon: (-icon.mean_s, icon.name))
