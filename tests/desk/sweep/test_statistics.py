import pytest
from hypothesis import given, strategies as st

from onika.desk.sweep.case import Case, CaseResult
from onika.desk.sweep.statistics import SuccessRate, parts, summarise
from onika.words.reason import Reason


def ended(seed, value=0.0, seconds=2.0):
    return CaseResult(Case(seed, {"pd.STIFF": value}), "completed", lasted_s=seconds)


def failed(seed, value=0.0, reason=None):
    return CaseResult(Case(seed, {"pd.STIFF": value}), "aborted", reason or Reason.plain("it fell"))


@pytest.mark.parametrize(
    ("good", "count", "least", "most"),
    [(9, 10, 0.596, 0.982), (0, 10, 0.0, 0.278), (10, 10, 0.722, 1.0), (50, 100, 0.404, 0.596), (0, 0, 0.0, 1.0)],
)
def test_the_interval_is_wilsons(good, count, least, most):  # R-X23
    assert SuccessRate(good, count).interval == pytest.approx((least, most), abs=5e-4)  # of published tables


@given(st.integers(0, 200), st.integers(0, 200))
def test_the_share_lies_within_its_interval(good, bad):  # R-X23
    rate = SuccessRate(good, good + bad)
    least, most = rate.interval
    assert 0.0 <= least <= rate.share + 1e-12
    assert rate.share - 1e-12 <= most <= 1.0


def test_what_failed_is_counted_by_what_it_is_about_whatever_its_numbers():  # R-X23
    away = [Reason.of("sweep.no_element", address="pd.HOME[3]", count=number) for number in (1, 2, 3)]
    results = [failed(5, reason=away[0]), failed(2, reason=away[1]), failed(9, reason=away[2]), failed(1), ended(0)]
    first, second = summarise(results).failures
    assert (first.count, first.seed, first.reason) == (3, 2, away[1])
    assert (second.count, second.seed, str(second.reason)) == (1, 1, "it fell")


def test_the_durations_are_of_good_runs_only():  # R-X23
    results = [ended(0, seconds=3.0), ended(1, seconds=1.0), ended(2, seconds=2.0), failed(3)]
    assert summarise(results).lasted_s == (1.0, 2.0, 3.0)
    assert summarise([failed(0)]).lasted_s is None


def test_few_values_are_told_each_and_many_in_five_parts_without_a_gap():  # R-X23
    few = parts([ended(0, 1.0), failed(1, 1.0), ended(2, 4.0)], "pd.STIFF")
    assert [(part.least, part.most, part.rate) for part in few] == [
        (1.0, 1.0, SuccessRate(1, 2)),
        (4.0, 4.0, SuccessRate(1, 1)),
    ]
    many = parts([ended(seed, float(seed)) for seed in range(11)], "pd.STIFF")
    assert [(part.least, part.most, part.rate.count) for part in many] == [
        (0, 2, 2), (2, 4, 2), (4, 6, 2), (6, 8, 2), (8, 10, 3)
    ]  # fmt: skip


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=60))
def test_every_run_is_in_one_part(values):  # R-X23
    results = [ended(seed, value) for seed, value in enumerate(values)]
    assert sum(part.rate.count for part in parts(results, "pd.STIFF")) == len(values)
