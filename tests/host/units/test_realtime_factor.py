import pytest

from onika.host.units.realtime_factor import RealtimeFactor

SECOND = 1_000_000_000


@pytest.mark.parametrize("scale", [0.1, 1.0, 10.0])
def test_the_clock_goes_as_many_times_as_fast_as_it_was_told(scale):  # R-X08
    pace = RealtimeFactor(scale, 0, 5 * SECOND)
    for step in range(1, 11):
        assert pace.allowed(5 * SECOND + step * SECOND // 10, stands=False) == round(step * 0.1 * scale * SECOND)


def test_nothing_is_saved_up_while_the_clock_stands():  # law 15
    pace = RealtimeFactor(1.0, 7, 0)
    assert pace.allowed(SECOND, stands=True) == 7
    assert pace.allowed(SECOND + 1000, stands=False) == 1007


def test_a_stall_stretches_time_and_never_jumps():  # law 13
    pace = RealtimeFactor(1.0, 0, 0)
    assert pace.allowed(60 * SECOND, stands=False) == 200_000_000


def test_a_clock_that_has_gone_further_goes_on_from_there():  # R-X05
    pace = RealtimeFactor(1.0, 0, 0)
    pace.follow(5 * SECOND, 7 * SECOND)
    assert pace.allowed(7 * SECOND + 1000, stands=False) == 5 * SECOND + 1000
    pace.follow(SECOND, 8 * SECOND)
    assert pace.allowed(7 * SECOND + 3000, stands=False) == 5 * SECOND + 3000


def test_the_wait_is_as_long_as_the_clock_takes():
    pace = RealtimeFactor(10.0, 0, 0)
    assert pace.wait_s(SECOND) == pytest.approx(0.1)
    assert pace.wait_s(-5) == 0.0


@pytest.mark.parametrize("scale", [0.0, -1.0, 1e9, float("nan")])
def test_a_scale_beyond_reason_is_refused(scale):
    with pytest.raises(ValueError, match="expected a scale"):
        RealtimeFactor(scale, 0, 0)
