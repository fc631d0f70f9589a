"""Groups compared: the tables of the source, published examples, and computations that share nothing with SciPy's."""

import math
import warnings
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.study import folder
from onika.study.compared import compared
from onika.study.comparison import compare, effect_of
from onika.study.source_tables import BUILDING_S, FOLDER, MEAN_SELECTION_S


def of_source():
    figures = compared(folder.read(FOLDER).subjects)
    return {figure.figure: figure.comparison for figure in figures}


def simpson(function, low, high, count=4000):
    """The integral by Simpson's rule."""
    x = np.linspace(low, high, count + 1)
    y = function(x)
    return float((high - low) / (3 * count) * (y[0] + y[-1] + 4 * y[1:-1:2].sum() + 2 * y[2:-1:2].sum()))


def f_tail(f, between, within):
    """P(F > f): the incomplete beta function, integrated over t = sqrt(x) so that nothing is infinite at 0."""
    a, b = within / 2, between / 2
    x = within / (within + between * f)
    beta = math.exp(math.lgamma(a) + math.lgamma(b) - math.lgamma(a + b))
    return simpson(lambda t: 2 * t ** (2 * a - 1) * (1 - t * t) ** (b - 1), 0.0, math.sqrt(x)) / beta


def chi_tail(value, freedom):
    """P(chi square > value), over t = sqrt(x)."""
    density = 2 ** (1 - freedom / 2) / math.gamma(freedom / 2)
    return 1.0 - simpson(lambda t: density * t ** (freedom - 1) * np.exp(-t * t / 2), 0.0, math.sqrt(value))


def normal_cdf(x):
    return 0.5 * (1.0 + np.vectorize(math.erf)(x / math.sqrt(2.0)))


def studentized_range_cdf(q, groups, within):
    """By its definition: the range of normal values, averaged over the distribution of the estimated deviation."""
    z = np.linspace(-8.0, 8.0, 641)
    phi = np.exp(-z * z / 2) / math.sqrt(2 * math.pi)

    def of_range(w):
        inner = phi * (normal_cdf(z) - normal_cdf(z - w)) ** (groups - 1)
        return groups * float(np.sum((inner[1:] + inner[:-1]) / 2) * (z[1] - z[0]))

    log_density = (within / 2) * math.log(within) - math.lgamma(within / 2) - (within / 2 - 1) * math.log(2)

    def integrand(s):
        density = np.exp(log_density + (within - 1) * np.log(s) - within * s * s / 2)
        return density * np.array([of_range(q * one) for one in s])

    return simpson(integrand, 0.05, 3.5, 160)


def test_the_analysis_of_the_source_has_its_probability():  # R-H03
    """p2 and t1 removed, pt9 absent, adjusted times of the words-only group: 6.99 %."""
    comparison = of_source()["mean_selection_s"]
    assert [(group.name, len(group.values)) for group in comparison.groups] == [
        ("both", 9),
        ("pictures", 8),
        ("words", 4),
    ]
    assert (comparison.variance.between, comparison.variance.within) == (2, 18)
    assert round(100 * comparison.variance.p, 2) == 6.99


def test_the_pairs_are_those_of_table_4():  # R-H03
    pairs = of_source()["mean_selection_s"].pairs
    assert [(pair.first, pair.second) for pair in pairs] == [
        ("both", "pictures"),
        ("both", "words"),
        ("pictures", "words"),
    ]
    rows = [tuple(round(value, 4) for value in (pair.low, pair.difference, pair.high)) for pair in pairs]
    assert rows == [(-3.2796, -0.7369, 1.8058), (-6.1984, -3.0539, 0.0907), (-5.5214, -2.3170, 0.8874)]


def test_the_tables_of_the_source_have_the_means_of_its_text():  # R-H03, R-H06
    groups = {}
    for subject in folder.read(FOLDER).subjects:
        groups.setdefault(subject.group, []).append(subject)
    mean = {name: np.mean([s.figures["mean_selection_s"] for s in members]) for name, members in groups.items()}
    assert [round(mean[name], 1) for name in ("both", "pictures")] == [MEAN_SELECTION_S, 7.8]
    assert round(mean["words"] - 2.25, 2) == 9.19  # the source prints 9.18
    deletions = {name: np.mean([s.figures["deletions"] for s in members]) for name, members in groups.items()}
    assert [round(deletions[name], 2) for name in ("both", "pictures")] == [0.33, 0.89]
    times = [subject.figures["building_s"] for subject in groups["both"]]
    assert (min(times), max(times)) == BUILDING_S


def test_the_analysis_of_variance_is_that_of_sums_of_squares():  # R-H03
    comparison = of_source()["mean_selection_s"]
    groups = [np.array(group.values) for group in comparison.groups]
    every = np.concatenate(groups)
    between = sum(len(group) * (group.mean() - every.mean()) ** 2 for group in groups)
    within = sum(((group - group.mean()) ** 2).sum() for group in groups)
    f = (between / 2) / (within / 18)
    assert comparison.variance.statistic == pytest.approx(f)
    assert comparison.variance.p == pytest.approx(f_tail(f, 2, 18), rel=1e-6)
    assert comparison.effect.eta == pytest.approx(between / (between + within))
    omega = (between - 2 * within / 18) / (between + within + within / 18)
    assert comparison.effect.omega == pytest.approx(omega)
    assert comparison.effect.f == pytest.approx(math.sqrt(between / within))


def test_the_limits_of_pairs_are_those_of_the_studentized_range():  # R-H03
    comparison = of_source()["mean_selection_s"]
    groups = {group.name: np.array(group.values) for group in comparison.groups}
    within = sum(((group - group.mean()) ** 2).sum() for group in groups.values()) / 18
    for pair in comparison.pairs:
        n, m = len(groups[pair.first]), len(groups[pair.second])
        error = math.sqrt(within / 2 * (1 / n + 1 / m))
        q = (pair.high - pair.low) / 2 / error
        assert studentized_range_cdf(q, 3, 18) == pytest.approx(0.95, abs=2e-4)
        assert 1 - studentized_range_cdf(abs(pair.difference) / error, 3, 18) == pytest.approx(pair.p, abs=2e-4)


def test_welch_and_ranks_are_those_of_their_formulas():  # R-H03
    comparison = of_source()["building_s"]
    groups = [np.array(group.values) for group in comparison.groups]
    k = len(groups)
    weights = [len(group) / group.var(ddof=1) for group in groups]
    mean = sum(w * group.mean() for w, group in zip(weights, groups, strict=True)) / sum(weights)
    rest = sum((1 - w / sum(weights)) ** 2 / (len(group) - 1) for w, group in zip(weights, groups, strict=True))
    above = sum(w * (group.mean() - mean) ** 2 for w, group in zip(weights, groups, strict=True)) / (k - 1)
    f, within = above / (1 + 2 * (k - 2) / (k * k - 1) * rest), (k * k - 1) / (3 * rest)
    assert comparison.welch.statistic == pytest.approx(f)
    assert comparison.welch.within == pytest.approx(within)
    assert comparison.welch.p == pytest.approx(f_tail(f, k - 1, within), rel=1e-5)

    every = sorted(value for group in groups for value in group)
    ranks = {value: np.mean([i + 1 for i, v in enumerate(every) if v == value]) for value in every}
    n = len(every)
    h = 12 / (n * (n + 1)) * sum(sum(ranks[v] for v in g) ** 2 / len(g) for g in groups) - 3 * (n + 1)
    assert comparison.ranks.statistic == pytest.approx(h)
    assert comparison.ranks.p == pytest.approx(chi_tail(h, k - 1), rel=1e-5)

    apart = [np.abs(group - np.median(group)) for group in groups]
    all_apart = np.concatenate(apart)
    between = sum(len(g) * (g.mean() - all_apart.mean()) ** 2 for g in apart) / (k - 1)
    inside = sum(((g - g.mean()) ** 2).sum() for g in apart) / (n - k)
    assert comparison.spreads.statistic == pytest.approx(between / inside)


def test_two_groups_are_compared_as_by_students_test():  # R-H03
    """Sleep of Student's ten patients (Biometrika 1908): t = -1.8608, p = 0.07919; d = 0.832; Welch's p = 0.07939."""
    first = (0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0)
    second = (1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4)
    comparison = compare({"first": first, "second": second})
    assert comparison.variance.statistic == pytest.approx(1.8608**2, rel=1e-4)
    assert comparison.variance.p == pytest.approx(0.07919, abs=1e-5)
    assert comparison.welch.p == pytest.approx(0.07939, abs=1e-5)
    (pair,) = comparison.pairs
    assert pair.p == pytest.approx(0.07919, abs=1e-4)
    assert pair.difference == pytest.approx(-1.58)
    assert pair.g == pytest.approx(-0.8322 * (1 - 3 / 71), abs=1e-3)
    assert pair.g_low < pair.g < pair.g_high


def test_a_mean_has_the_interval_of_student():  # R-H03
    (first, _) = compare({"a": (1.0, 2.0, 3.0), "b": (1.0, 5.0)}).groups
    assert (first.low, first.high) == pytest.approx((2 - 4.30265 / math.sqrt(3), 2 + 4.30265 / math.sqrt(3)), rel=1e-5)


def test_the_interval_of_the_effect_begins_at_nothing_where_it_is_not_significant():  # R-H03
    comparison = of_source()["mean_selection_s"]
    assert comparison.variance.p > 0.05
    assert comparison.effect.low == 0.0
    assert comparison.effect.low < comparison.effect.eta < comparison.effect.high
    surely = compare({"a": (1.0, 1.1, 1.2, 1.3), "b": (3.0, 3.1, 3.2, 3.4)})
    assert surely.variance.p < 0.05
    assert 0.0 < surely.effect.low < surely.effect.eta


def reasons(comparison):
    return [doubt.key for doubt in comparison.doubts]


def test_a_group_of_one_is_shown_and_left_out_of_the_tests():  # R-H03
    without = compare({"a": (1.0, 2.0, 4.0), "b": (3.0, 5.0, 6.0)})
    comparison = compare({"a": (1.0, 2.0, 4.0), "b": (3.0, 5.0, 6.0), "c": (9.0,)})
    assert reasons(comparison) == ["study.group_of_one"]
    assert [group.name for group in comparison.groups] == ["a", "b", "c"]
    assert comparison.variance == without.variance
    assert math.isnan(comparison.groups[2].spread)
    lone = compare({"a": (1.0,), "b": (2.0,)})
    assert reasons(lone) == ["study.group_of_one", "study.group_of_one", "study.one_group"]
    assert math.isnan(lone.variance.p)


def test_values_that_are_all_equal_are_not_compared():  # R-H03
    comparison = compare({"a": (2.0, 2.0, 2.0), "b": (2.0, 2.0)})
    assert reasons(comparison) == ["study.all_equal"]
    assert math.isnan(comparison.variance.p)
    apart = compare({"a": (2.0, 2.0, 2.0), "b": (3.0, 3.0, 3.0)})
    assert reasons(apart) == ["study.no_spread"]
    assert math.isnan(apart.variance.p)
    assert apart.ranks.p == pytest.approx(chi_tail(5.0, 1), rel=1e-5)
    partly = compare({"a": (2.0, 2.0, 2.0), "b": (3.0, 4.0, 3.0)})
    assert "study.no_welch" in reasons(partly)
    assert math.isfinite(partly.variance.p)
    assert math.isnan(partly.welch.p)


def test_nothing_is_compared_with_nobody():  # R-H03
    assert reasons(compare({})) == ["study.one_group"]
    assert compare({"a": (math.nan,)}).groups == ()


def test_broken_assumptions_are_told():  # R-H03
    skewed = (1.0, 1.1, 1.0, 1.2, 1.1, 1.0, 1.1, 30.0)
    assert "study.not_normal" in reasons(compare({"a": skewed, "b": (1.0, 2.0, 3.0, 4.0)}))
    narrow, broad = tuple(10 + i / 100 for i in range(10)), tuple(float(i * 7 % 41) for i in range(10))
    assert "study.unequal_spreads" in reasons(compare({"a": narrow, "b": broad}))


def test_what_cannot_be_computed_is_not_recommended():  # R-H03
    flat, broad = (5.0,) * 8, tuple(float(i * 7 % 41) for i in range(8))
    told = reasons(compare({"a": flat, "b": broad}))
    assert "study.no_welch" in told and "study.unequal_without_welch" in told
    assert "study.unequal_spreads" not in told


def test_two_values_say_nothing_of_how_far_a_group_spreads():  # R-H03
    comparison = compare({"a": (5.0, 6.0), "b": (1.0, 9.0)})
    assert math.isnan(comparison.spreads.p)
    assert reasons(comparison) == []


VALUES = st.lists(st.floats(-1e6, 1e6) | st.sampled_from((0.0, 1.0, math.nan)), max_size=6)


@settings(max_examples=examples(60), deadline=None)
@given(st.dictionaries(st.text(max_size=3), VALUES, max_size=4))
def test_whatever_the_values_are_nothing_crashes_and_probabilities_are_some(groups):  # R-H03
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        comparison = compare(groups)
    for test in (comparison.variance, comparison.welch, comparison.ranks, comparison.spreads):
        assert math.isnan(test.p) or 0.0 <= test.p <= 1.0
    for pair in comparison.pairs:
        assert math.isnan(pair.low) or pair.low <= pair.difference <= pair.high
    count = sum(len(group.values) > 1 for group in comparison.groups)
    assert len(comparison.pairs) in (0, len([*combinations(range(count), 2)]))


def test_no_effect_is_told_of_no_test():
    assert math.isnan(effect_of(compare({}).variance, 0).eta)
