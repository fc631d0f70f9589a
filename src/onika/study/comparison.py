"""Groups compared: one-way analysis of variance and Tukey's HSD as in §6.2.5, and what stands beside them (H03).

The assumptions are tested too (Shapiro and Wilk for each group, Brown and Forsythe for equal variances), and Welch's
analysis and Kruskal and Wallis's test, which need less of them, are always given. All is SciPy's; effect sizes are
computed here from the sums of squares. NaN: it cannot be computed of these values, and a reason says why.
"""

import math
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import combinations
from statistics import fmean, stdev
from typing import Any

import numpy as np
from scipy import optimize, stats

from onika.words.reason import Reason

CONFIDENCE = 0.95
ALPHA = 1.0 - CONFIDENCE
_FEWEST_NORMAL = 3
_SAME = 1e-9
"""Values that differ by less than this, or this part of the largest, are equal: times are measured to a millisecond."""
_MOST_NONCENTRAL = 1e5
_EFFECT_CONFIDENCE = 0.90
"""Of the interval of η²: its lower end is above 0 just where the analysis of variance is significant at 5 %."""


@dataclass(frozen=True, slots=True)
class GroupSummary:
    """A group: how many, mean with its confidence interval, standard deviation, and whether it looks normal."""

    name: str
    values: tuple[float, ...]
    mean: float
    spread: float
    low: float
    high: float
    normal_p: float
    """Of Shapiro and Wilk's test."""


@dataclass(frozen=True, slots=True)
class Significance:
    """What a test says: statistic, degrees of freedom, and the probability of at least such differences by chance."""

    statistic: float = math.nan
    p: float = math.nan
    between: float = math.nan
    within: float = math.nan


@dataclass(frozen=True, slots=True)
class EffectSize:
    """How large the differences are, as shares of the variance: η² with its 90 % interval, ω², Cohen's f."""

    eta: float = math.nan
    low: float = math.nan
    high: float = math.nan
    omega: float = math.nan
    f: float = math.nan


@dataclass(frozen=True, slots=True)
class PairComparison:
    """Two groups: difference of means with its simultaneous limits (Tukey), p, and Hedges's g with its interval."""

    first: str
    second: str
    difference: float
    low: float
    high: float
    p: float
    welch_p: float
    """By Games and Howell's test, which needs no equal variances."""
    g: float
    g_low: float
    g_high: float


@dataclass(frozen=True, slots=True)
class Comparison:
    """Groups compared in one measure."""

    groups: tuple[GroupSummary, ...]
    variance: Significance = Significance()
    welch: Significance = Significance()
    ranks: Significance = Significance()
    """Of Kruskal and Wallis."""
    spreads: Significance = Significance()
    """Of Brown and Forsythe: whether the variances differ."""
    effect: EffectSize = EffectSize()
    pairs: tuple[PairComparison, ...] = ()
    doubts: tuple[Reason, ...] = ()
    """Why something was not computed, or should not be relied upon."""


def compare(values: Mapping[str, Sequence[float]]) -> Comparison:
    """Compare groups; those with fewer than two values are shown, and left out of the tests."""
    finite = {name: tuple(value for value in group if math.isfinite(value)) for name, group in values.items()}
    groups = tuple(_summary(name, group) for name, group in finite.items() if group)
    tested = {name: group for name, group in finite.items() if len(group) > 1}
    doubts = [Reason.of("study.group_of_one", group=group.name) for group in groups if len(group.values) == 1]
    if len(tested) < 2:
        doubts.append(Reason.of("study.one_group"))
        return Comparison(groups, doubts=tuple(doubts))
    samples = [np.array(group) for group in tested.values()]
    if is_flat(np.concatenate(samples)):
        doubts.append(Reason.of("study.all_equal"))
        return Comparison(groups, doubts=tuple(doubts))
    ranks = Significance(*_tested(lambda: stats.kruskal(*samples)), between=len(samples) - 1)
    if all(map(is_flat, samples)):
        doubts.append(Reason.of("study.no_spread"))
        return Comparison(groups, ranks=ranks, doubts=tuple(doubts))
    within = sum(map(len, samples)) - len(samples)
    variance = Significance(*_tested(lambda: stats.f_oneway(*samples)), len(samples) - 1, within)
    spreads = _spreads(samples, within)
    doubts += _assumption_doubts(groups, spreads, has_welch=not any(map(is_flat, samples)))
    return Comparison(
        groups=groups,
        variance=variance,
        welch=_welch(samples, doubts),
        ranks=ranks,
        spreads=spreads,
        effect=effect_of(variance, within + len(samples)),
        pairs=tuple(_pairs(tested)),
        doubts=tuple(doubts),
    )


def effect_of(variance: Significance, count: int) -> EffectSize:
    """The size of the effect behind an analysis of variance of so many values."""
    f, between, within = variance.statistic, variance.between, variance.within
    if not math.isfinite(f):
        return EffectSize()
    eta = f * between / (f * between + within)
    omega = max(0.0, between * (f - 1.0) / (between * (f - 1.0) + count))
    rest = (1.0 - _EFFECT_CONFIDENCE) / 2.0
    low, high = (_share(_noncentrality(f, between, within, level), count) for level in (1.0 - rest, rest))
    return EffectSize(eta, low, high, omega, math.sqrt(f * between / within))


def is_flat(values: "Sequence[float] | np.ndarray[Any, Any]") -> bool:
    """Whether all values are equal, but for the last digits of their computation."""
    return float(np.ptp(values)) <= _SAME * max(1.0, float(np.max(np.abs(values))))


def _noncentrality(f: float, between: float, within: float, level: float) -> float:
    """The noncentrality with which a statistic F is at most `f` with the probability `level`; 0 where none is."""

    def excess(noncentrality: float) -> float:
        return float(stats.ncf.cdf(f, between, within, noncentrality)) - level

    if float(stats.f.cdf(f, between, within)) <= level:
        return 0.0
    high = 10.0
    while (beyond := excess(high)) > 0.0 and high < _MOST_NONCENTRAL:
        high *= 2.0
    if beyond > 0.0:
        return math.nan
    return float(optimize.brentq(excess, 0.0, high))


def _share(noncentrality: float, count: int) -> float:
    return noncentrality / (noncentrality + count)


def _summary(name: str, values: tuple[float, ...]) -> GroupSummary:
    mean = fmean(values)
    if len(values) < 2:
        return GroupSummary(name, values, mean, math.nan, math.nan, math.nan, math.nan)
    spread = stdev(values)
    reach = float(stats.t.ppf(1.0 - ALPHA / 2.0, len(values) - 1)) * spread / math.sqrt(len(values))
    normal_p = math.nan
    if len(values) >= _FEWEST_NORMAL and not is_flat(values):
        _, normal_p = _tested(lambda: stats.shapiro(values))
    return GroupSummary(name, values, mean, spread, mean - reach, mean + reach, normal_p)


def _welch(samples: Sequence["np.ndarray[Any, Any]"], doubts: list[Reason]) -> Significance:
    """Welch's analysis of variance; a group without any spread has no weight that it could be given."""
    if any(map(is_flat, samples)):
        doubts.append(Reason.of("study.no_welch"))
        return Significance()
    statistic, p = _tested(lambda: stats.f_oneway(*samples, equal_var=False))
    weights = [len(sample) / float(np.var(sample, ddof=1)) for sample in samples]
    whole = sum(weights)
    rest = sum((1.0 - weight / whole) ** 2 / (len(s) - 1) for weight, s in zip(weights, samples, strict=True))
    return Significance(statistic, p, len(samples) - 1, (len(samples) ** 2 - 1) / (3.0 * rest))


def _spreads(samples: Sequence["np.ndarray[Any, Any]"], within: int) -> Significance:
    """Whether variances differ; values that lie equally far from the middle, as two of a group do, cannot say."""
    if all(is_flat(np.abs(sample - np.median(sample))) for sample in samples):
        return Significance()
    return Significance(*_tested(lambda: stats.levene(*samples, center="median")), len(samples) - 1, within)


def _assumption_doubts(groups: Sequence[GroupSummary], spreads: Significance, *, has_welch: bool) -> Iterator[Reason]:
    for group in groups:
        if group.normal_p < ALPHA:
            yield Reason.of("study.not_normal", group=group.name, p=100.0 * group.normal_p)
    if spreads.p < ALPHA:
        key = "study.unequal_spreads" if has_welch else "study.unequal_without_welch"
        yield Reason.of(key, p=100.0 * spreads.p)


def _pairs(tested: Mapping[str, Sequence[float]]) -> Iterator[PairComparison]:
    """Each pair of groups; the difference is that of the first from the second."""
    samples = list(tested.values())
    with _quiet():
        tukey = stats.tukey_hsd(*samples)
        limits = tukey.confidence_interval(CONFIDENCE)
        howell = stats.tukey_hsd(*samples, equal_var=False) if not any(map(is_flat, samples)) else None
    for (i, first), (j, second) in combinations(enumerate(tested), 2):
        yield PairComparison(
            first,
            second,
            float(tukey.statistic[i, j]),
            float(limits.low[i, j]),
            float(limits.high[i, j]),
            float(tukey.pvalue[i, j]),
            float(howell.pvalue[i, j]) if howell is not None else math.nan,
            *_hedges(samples[i], samples[j]),
        )


def _hedges(first: Sequence[float], second: Sequence[float]) -> tuple[float, float, float]:
    """Hedges's g and its interval, by the standard error of Hedges and Olkin (1985)."""
    n, m = len(first), len(second)
    freedom = n + m - 2
    pooled = ((n - 1) * stdev(first) ** 2 + (m - 1) * stdev(second) ** 2) / freedom
    if is_flat(first) and is_flat(second):
        return math.nan, math.nan, math.nan
    g = (1.0 - 3.0 / (4.0 * freedom - 1.0)) * (fmean(first) - fmean(second)) / math.sqrt(pooled)
    reach = float(stats.norm.ppf(1.0 - ALPHA / 2.0)) * math.sqrt((n + m) / (n * m) + g * g / (2.0 * (n + m)))
    return g, g - reach, g + reach


def _tested(test: Callable[[], Any]) -> tuple[float, float]:
    """Statistic and p of a test of SciPy."""
    with _quiet():
        outcome = test()
    return float(outcome.statistic), float(outcome.pvalue)


@contextmanager
def _quiet() -> Iterator[None]:
    """SciPy warns of values that are nearly equal; here doubts say so."""
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield
