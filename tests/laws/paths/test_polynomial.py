"""Paths of polynomials."""

import numpy as np
import pytest

from onika.laws.paths.polynomial import PolynomialPath

QUINTIC = [[1.0, 0.0, 0.0, 10.0, -15.0, 6.0], [0.5, 0.0, 0.0, 0.0, 0.0, 0.0]]
FAST = np.full(2, 100.0)


def test_the_fifth_order_law_is_one_of_them():
    path = PolynomialPath(np.array(QUINTIC), 2.0, FAST)
    assert path.at(0.0)[0] == pytest.approx([1.0, 0.5])
    assert path.at(1.0)[0] == pytest.approx([1.5, 0.5])
    assert path.at(1.0)[1] == pytest.approx([1.875 / 2, 0.0])
    assert path.at(2.0)[0] == pytest.approx([2.0, 0.5])
    assert path.at(9.0)[1] == pytest.approx([0.0, 0.0])


def test_the_speed_is_the_derivative_of_the_position():
    path = PolynomialPath(np.array([[0.2, 0.0, 16.0, -32.0, 16.0]]), 3.0, FAST[:1])
    for t in np.linspace(0.01, 2.99, 40):
        slope = (path.at(t + 1e-5)[0] - path.at(t - 1e-5)[0]) / 2e-5
        assert path.at(t)[1] == pytest.approx(slope, abs=1e-6)


def test_a_path_that_is_too_quick_is_stretched_to_the_limit():
    path = PolynomialPath(np.array(QUINTIC), 0.1, np.array([0.5, 9.0]))
    assert path.duration == pytest.approx(1.875 / 0.5)
    assert max(abs(path.at(t)[1][0]) for t in np.linspace(0, path.duration, 500)) == pytest.approx(0.5, rel=1e-3)


@pytest.mark.parametrize("coefficients", [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
def test_a_path_that_is_not_at_rest_at_its_ends_is_refused(coefficients):
    with pytest.raises(ValueError, match="at rest; that of joint 2 has a slope of"):
        PolynomialPath(np.array([[0.0, 0.0, 0.0], coefficients]), 1.0, FAST)


def test_a_path_that_leaves_its_range_in_the_middle_is_told_with_the_joint():
    path = PolynomialPath(np.array([[0.0, 0.0, 16.0, -32.0, 16.0]]), 1.0, FAST[:1])
    path.check_range([-0.1], [1.01])
    with pytest.raises(ValueError, match=r"joint 1 would stand at 1\.000 rad, beyond -0\.100\.\.0\.900"):
        path.check_range([-0.1], [0.9])
