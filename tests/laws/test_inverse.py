import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.laws.damped import DampedInverse
from onika.laws.inverse import serial_inverse
from onika.laws.puma_inverse import PumaInverse
from onika.laws.scara_inverse import ScaraInverse
from onika.laws.textbook import serial_arm


def test_a_table_of_the_family_gets_the_closed_form():
    inverse = serial_inverse(puma560.DH, None, puma560.TOOL, puma560.QMIN, puma560.QMAX)
    assert isinstance(inverse, PumaInverse)


def test_a_scara_is_known_by_its_table_too():  # R-K03
    inverse = serial_inverse(adept_one.DH, None, adept_one.TOOL, adept_one.QMIN, adept_one.QMAX)
    assert isinstance(inverse, ScaraInverse)


def test_any_other_table_gets_least_squares_and_the_same_answers():
    other = puma560.DH.copy()
    other[3, 0] = 1e-3
    inverse = serial_inverse(other, None, puma560.TOOL, puma560.QMIN, puma560.QMAX)
    assert isinstance(inverse, DampedInverse)
    q = np.array([0.2, -0.7, 2.4, 0.6, 0.8, -0.3])
    solution = inverse.nearest(serial_arm(other, tool=puma560.TOOL).forward(q), q + 0.05)
    assert np.allclose(solution, q, atol=1e-6)


def test_constants_may_come_as_flat_rows():
    inverse = serial_inverse(puma560.DH.ravel().tolist(), np.eye(4).ravel(), None, puma560.QMIN, puma560.QMAX)
    assert isinstance(inverse, PumaInverse)


def test_limits_of_the_wrong_number_are_refused():
    with pytest.raises(ValueError, match="expected"):
        serial_inverse(puma560.DH, None, None, puma560.QMIN[:5], puma560.QMAX)
