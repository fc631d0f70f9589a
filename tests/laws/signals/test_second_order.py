"""Filters of second order."""

import numpy as np
import pytest

from onika.laws.signals.second_order import SecondOrder

DT = 1 / 500


def gain(made, frequency):
    """How much of a sine is left once the filter has settled."""
    made.reset([0.0])
    time = np.arange(round(20 / frequency / DT)) * DT
    passed = np.array([made.update(np.array([np.sin(2 * np.pi * frequency * t)]))[0] for t in time])
    return np.sqrt(2 * np.mean(passed[len(passed) // 2 :] ** 2))


@pytest.mark.parametrize(("frequency", "left"), [(2.0, 1.0), (20.0, 0.5**0.5), (80.0, 0.0537)])
def test_a_low_pass_lets_slow_things_through_and_3_db_at_its_cutoff(frequency, left):
    assert gain(SecondOrder.lowpass(1, DT, 20.0), frequency) == pytest.approx(left, abs=0.01)


@pytest.mark.parametrize(("frequency", "left"), [(2.0, 1.0), (25.0, 0.0), (27.6, 0.71), (22.6, 0.71), (100.0, 1.0)])
def test_a_notch_takes_its_middle_out_and_leaves_the_rest(frequency, left):
    assert gain(SecondOrder.notch(1, DT, 25.0, 5.0), frequency) == pytest.approx(left, abs=0.03)


@pytest.mark.parametrize("made", [SecondOrder.lowpass(2, DT, 20.0), SecondOrder.notch(2, DT, 25.0, 5.0)])
def test_what_stays_the_same_passes_unchanged_from_the_first_sample_on(made):
    made.reset([3.0, -1.0])
    for _ in range(50):
        assert made.update(np.array([3.0, -1.0])) == pytest.approx([3.0, -1.0])


def test_a_butterworth_low_pass_overshoots_a_step_by_4_per_cent():
    made = SecondOrder.lowpass(1, DT, 5.0)
    made.reset([0.0])
    assert max(made.update(np.ones(1))[0] for _ in range(500)) == pytest.approx(1.0432, abs=0.002)


@pytest.mark.parametrize("frequency", [0.0, -1.0, 250.0, 1e9])
def test_a_frequency_that_the_rate_cannot_carry_is_refused(frequency):
    for make in (lambda: SecondOrder.lowpass(1, DT, frequency), lambda: SecondOrder.notch(1, DT, frequency, 1.0)):
        with pytest.raises(ValueError, match="below 250 Hz, half of the rate"):
            make()
