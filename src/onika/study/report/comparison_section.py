"""Groups compared, as a part of the page: box plots, tests, pairs, and how many subjects it needs (requirement H03)."""

import math
from collections.abc import Callable, Iterator

from onika.study.compared import ComparedFigure
from onika.study.comparison import Comparison, GroupSummary, Significance
from onika.study.power import POWER, SIZES, subjects_needed
from onika.study.report import box_plot, markup, pair_plot
from onika.study.report.figure_names import title_of
from onika.words.reason import Reason

Say = Callable[[Reason], str]


def section(compared: ComparedFigure, say: Say) -> Iterator[str]:
    """What is said of one figure."""
    comparison, title = compared.comparison, say(title_of(compared.figure))
    yield markup.heading(3, title)
    yield markup.figure(box_plot.drawn(compared.points, title), say(Reason.of("study.box_caption")))
    yield _groups(comparison, say)
    if comparison.doubts:
        yield markup.listing(say(doubt) for doubt in comparison.doubts)
    if math.isfinite(comparison.variance.p) or math.isfinite(comparison.ranks.p):
        yield _tests(comparison, say)
    if comparison.pairs:
        yield markup.figure(pair_plot.drawn(comparison.pairs, title), say(Reason.of("study.pair_caption")))
        yield _pairs(comparison, say)
        yield markup.paragraph(say(_sizes(comparison)))


def needed(comparison: Comparison, say: Say) -> str:
    """How many subjects a group needs, for a small, medium and large difference and that found here."""
    groups = sum(len(group.values) > 1 for group in comparison.groups)
    omega = comparison.effect.omega
    sizes = [(f, say(Reason.of(key))) for f, key in zip(SIZES, _SIZES, strict=True)]
    if math.isfinite(omega) and 0.0 < omega < 1.0:
        sizes.append((math.sqrt(omega / (1.0 - omega)), say(Reason.of("study.size_here"))))
    rows = []
    for f, name in sizes:
        each = subjects_needed(f, max(groups, 2))
        counts = (markup.NOTHING, markup.NOTHING) if each is None else (str(each), str(each * max(groups, 2)))
        rows.append((name, f"{f:.3g}", *counts))
    head = ("study.size", "study.cohens_f", "study.each_group", "study.all_groups")
    text = say(Reason.of("study.power_text", percent=100.0 * POWER, groups=max(groups, 2)))
    return markup.paragraph(text) + markup.table([say(Reason.of(key)) for key in head], rows)


_SIZES = ("study.size_small", "study.size_medium", "study.size_large")


def _groups(comparison: Comparison, say: Say) -> str:
    keys = ("study.group", "study.subjects", "study.mean", "study.spread", "study.interval", "study.normal")
    rows = [_group(group) for group in comparison.groups]
    return markup.table([say(Reason.of(key)) for key in keys], rows)


def _group(group: GroupSummary) -> tuple[str, ...]:
    interval = f"{group.low:.2f} … {group.high:.2f}" if math.isfinite(group.low) else markup.NOTHING
    count, spread = str(len(group.values)), markup.number(group.spread)
    return group.name, count, markup.number(group.mean), spread, interval, markup.percent(group.normal_p)


def _tests(comparison: Comparison, say: Say) -> str:
    tests = (
        ("study.anova", "F", comparison.variance),
        ("study.welch", "F", comparison.welch),
        ("study.kruskal", "H", comparison.ranks),
        ("study.brown_forsythe", "F", comparison.spreads),
    )
    head = ("study.test", "study.statistic", "study.probability")
    rows = [(say(Reason.of(key)), _statistic(letter, test), markup.percent(test.p)) for key, letter, test in tests]
    return markup.table([say(Reason.of(key)) for key in head], rows, ("main", "", "", ""))


def _statistic(letter: str, test: Significance) -> str:
    if not math.isfinite(test.statistic):
        return markup.NOTHING
    freedom = [f"{value:g}" if float(value).is_integer() else f"{value:.1f}" for value in (test.between, test.within)]
    return f"{letter}({', '.join(value for value in freedom if value != 'nan')}) = {test.statistic:.3f}"


def _pairs(comparison: Comparison, say: Say) -> str:
    keys = (
        "study.pair",
        "study.lower_limit",
        "study.difference",
        "study.upper_limit",
        "study.tukey_p",
        "study.howell_p",
    )
    rows = [
        (
            f"{pair.first} − {pair.second}",
            *(markup.number(value, 4) for value in (pair.low, pair.difference, pair.high)),
            markup.percent(pair.p),
            markup.percent(pair.welch_p),
            f"{pair.g:.2f} ({pair.g_low:.2f} … {pair.g_high:.2f})" if math.isfinite(pair.g) else markup.NOTHING,
        )
        for pair in comparison.pairs
    ]
    return markup.table([say(Reason.of(key)) for key in (*keys, "study.hedges")], rows)


def _sizes(comparison: Comparison) -> Reason:
    effect = comparison.effect
    return Reason.of("study.effect", eta=effect.eta, low=effect.low, high=effect.high, omega=effect.omega, f=effect.f)
