"""Vectors of which only the finite numbers are taken."""

import numpy as np

from onika.laws.finite import FiniteValues


def test_an_element_that_is_no_number_leaves_the_one_before():
    sound = FiniteValues(3)
    assert sound.take(np.array([np.nan, 1.0, np.inf])).tolist() == [0.0, 1.0, 0.0]
    assert sound.take(np.array([4.0, -np.inf, 5.0])).tolist() == [4.0, 1.0, 5.0]
    assert sound.take(np.full(3, np.nan)) is sound.values
    assert sound.values.tolist() == [4.0, 1.0, 5.0]
