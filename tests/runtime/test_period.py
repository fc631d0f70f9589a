import pytest

from onika.runtime.period import period_of

MS = 1_000_000


@pytest.mark.parametrize(("frequency", "period"), [(1.0, 10**9), (3.0, 333_333_333), (500.0, 2 * MS), (1e9, 1)])
def test_a_period_is_whole_nanoseconds(frequency, period):  # law 13
    assert period_of(frequency) == period


@pytest.mark.parametrize("frequency", [0.0, -1.0, 1.1e9, float("nan"), float("inf")])
def test_what_has_no_period_is_refused(frequency):
    with pytest.raises(ValueError, match="expected a rate above 0 Hz"):
        period_of(frequency)
