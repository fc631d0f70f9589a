import math

import numpy as np
import pytest

from onika.laws.filter import Derivative


def test_of_something_at_rest_the_derivative_is_zero():
    derivative = Derivative(2, 0.002, 30.0)
    derivative.reset([1.0, -2.0])
    assert not derivative.update([1.0, -2.0]).any()


def test_a_ramp_is_found_after_the_filters_time():
    derivative, out = Derivative(1, 0.002, 30.0), np.empty(1)
    derivative.reset([0.0])
    for k in range(1, 100):
        derivative.update([0.006 * k], out)
    assert out[0] == pytest.approx(3.0, rel=1e-6)


def test_the_first_step_of_a_ramp_is_damped_by_the_time_constant():
    tau = 1.0 / (2.0 * math.pi * 30.0)
    derivative = Derivative(1, 0.002, 30.0)
    assert derivative.update([0.006])[0] == pytest.approx(0.006 / (tau + 0.002))


def test_without_a_low_pass_it_is_the_difference_quotient():
    derivative = Derivative(1, 0.01, math.inf)
    assert derivative.update([0.05])[0] == pytest.approx(5.0)


@pytest.mark.parametrize(("dt", "cutoff"), [(0.0, 1.0), (0.01, 0.0), (math.nan, 1.0)])
def test_a_rate_or_cutoff_of_nothing_is_refused(dt, cutoff):
    with pytest.raises(ValueError, match="above 0"):
        Derivative(1, dt, cutoff)
