"""Statistics of a sweep: how many runs are good, how sure that is, what failed first (requirement X23)."""

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from onika.desk.sweep.case import CaseResult
from onika.words.reason import Reason

_Z = 1.959964
"""The normal distribution has 95 % of itself within so many deviations."""
PARTS = 5


@dataclass(frozen=True, slots=True)
class SuccessRate:
    """So many good ones among so many."""

    good: int
    count: int

    @property
    def share(self) -> float:
        """The share of good ones; 0 where there is none at all."""
        return self.good / self.count if self.count else 0.0

    @property
    def interval(self) -> tuple[float, float]:
        """Where the true share lies with 95 % confidence, by Wilson's score."""
        if not self.count:
            return 0.0, 1.0
        square = _Z * _Z / self.count
        middle = self.share + square / 2
        spread = _Z * math.sqrt(self.share * (1 - self.share) / self.count + square / (4 * self.count))
        return max(0.0, (middle - spread) / (1 + square)), min(1.0, (middle + spread) / (1 + square))


@dataclass(frozen=True, slots=True)
class Failure:
    """A way to fail: how often, and the first seed that did."""

    reason: Reason
    count: int
    seed: int


@dataclass(frozen=True, slots=True)
class VariedPart:
    """A part of what a number was varied over, and how many runs in it are good."""

    least: float
    most: float
    rate: SuccessRate


@dataclass(frozen=True, slots=True)
class SweepSummary:
    """A sweep as a whole."""

    rate: SuccessRate
    failures: tuple[Failure, ...]
    lasted_s: tuple[float, float, float] | None
    """Least, median and most duration of the good runs, in s of virtual time."""
    parts: dict[str, tuple[VariedPart, ...]]


def summarise(results: Iterable[CaseResult]) -> SweepSummary:
    """The summary of these runs."""
    ordered = sorted(results, key=lambda result: result.case.seed)
    lasted = sorted(result.lasted_s for result in ordered if result.is_good)
    names = list(dict.fromkeys(name for result in ordered for name in result.case.values))
    return SweepSummary(
        rate(ordered),
        tuple(_failures(ordered)),
        (lasted[0], median(lasted), lasted[-1]) if lasted else None,
        {name: parts(ordered, name) for name in names},
    )


def rate(results: Sequence[CaseResult]) -> SuccessRate:
    """How many of them are good."""
    return SuccessRate(sum(result.is_good for result in results), len(results))


def parts(results: Sequence[CaseResult], name: str) -> tuple[VariedPart, ...]:
    """The runs by what was drawn under a name: each value, or five equal parts where there are many."""
    drawn = sorted({result.case.values[name] for result in results if name in result.case.values})
    if len(drawn) <= PARTS:
        bounds = [(value, value) for value in drawn]
    else:
        width = (drawn[-1] - drawn[0]) / PARTS
        edges = [drawn[0] + number * width for number in range(PARTS)] + [drawn[-1]]
        bounds = list(pairwise(edges))
    among = [(result.case.values[name], result) for result in results if name in result.case.values]
    found = []
    for least, most in bounds:
        has_end = most in (least, drawn[-1])  # the upper edge of a part belongs to the next one, but of the last
        inside = [result for value, result in among if least <= value < most or (value == most and has_end)]
        found.append(VariedPart(least, most, rate(inside)))
    return tuple(found)


def _failures(results: Sequence[CaseResult]) -> list[Failure]:
    """Most frequent first. What differs in numbers only is the same."""
    first: dict[str, CaseResult] = {}
    counts: Counter[str] = Counter()
    for result in results:
        if not result.is_good:
            kind = _kind(result.failure)
            first.setdefault(kind, result)
            counts[kind] += 1
    return [Failure(first[kind].failure, count, first[kind].case.seed) for kind, count in counts.most_common()]


def _kind(reason: Reason) -> str:
    """What a reason is about, whatever its numbers."""
    words = [reason.key]
    for name, argument in sorted(reason.args.items()):
        if isinstance(argument, Reason):
            words.append(_kind(argument))
        elif isinstance(argument, str):
            words.append(f"{name}={argument}")
    return " ".join(words) if reason.args else f"{reason.key} {reason.text}"
