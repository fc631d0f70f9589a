import pytest

from onika.host.units.realtime_factor import RealtimeFactor

SECOND = 1_000_000_000


@pytest.mark.parametrize("scale", [0.1, 1.0, 10.0])
def test_the_clock_goes_as_many_times_as_fast_as_it_was_told(scale):  # R-X08
    realtime_factor = RealtimeFactor(scale, 0, 5 * SECOND)
    for step in range(1, 11):
        assert realtime_factor.allowed(5 * SECOND + step * SECOND // 10, stands=False) == round(
            step * 0.1 * scale * SECOND
        )


def test_nothing_is_saved_up_while_the_clock_stands():  # law 15
    realtime_factor = RealtimeFactor(1.0, 7, 0)
    assert realtime_factor.allowed(SECOND, stands=True) == 7
    assert realtime_factor.allowed(SECOND + 1000, stands=False) == 1007


def test_a_stall_stretches_time_and_never_jumps():  # law 13
    realtime_factor = RealtimeFactor(1.0, 0, 0)
    assert realtime_factor.allowed(60 * SECOND, stands=False) == 200_000_000


def test_a_clock_that_has_gone_further_goes_on_from_there():  # R-X05
    realtime_factor = RealtimeFactor(1.0, 0, 0)
    realtime_factor.follow(5 * SECOND, 7 * SECOND)
    assert realtime_factor.allowed(7 * SECOND + 1000, stands=False) == 5 * SECOND + 1000
    realtime_factor.follow(SECOND, 8 * SECOND)
    assert realtime_factor.allowed(7 * SECOND + 3000, stands=False) == 5 * SECOND + 3000


def test_the_wait_is_as_long_as_the_clock_takes():
    realtime_factor = RealtimeFactor(10.0, 0, 0)
    assert realtime_factor.wait_s(SECOND) == pytest.approx(0.1)
    assert realtime_factor.wait_s(-5) == 0.0


@pytest.mark.parametrize("scale", [0.0, -1.0, 1e9, float("nan")])
def test_a_scale_beyond_reason_is_refused(scale):
    with pytest.raises(ValueError, match="expected a scale"):
        RealtimeFactor(scale, 0, 0)
