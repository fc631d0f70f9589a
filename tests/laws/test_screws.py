import math

import numpy as np
import pytest

from onika.laws.screws import parents, places, screws, slides, sliding, turning

AT_ONE = turning((0.0, 0.0, 1.0), (1.0, 0.0, 5.0))


def test_a_moment_is_that_of_any_place_on_the_axis():
    assert AT_ONE.tolist() == turning((0.0, 0.0, 1.0), (1.0, 0.0, -2.0)).tolist() == [0, 0, 1, 0, -1, 0]


def test_an_axis_of_no_length_says_that_a_joint_slides():  # R-X19
    assert slides(np.array([AT_ONE, sliding((0.0, 1.0, 0.0))])).tolist() == [False, True]


def test_a_place_on_an_axis_is_near_the_joint_before_it():
    rows = np.array([AT_ONE, sliding((1.0, 0.0, 0.0)), turning((0.0, 1.0, 0.0), (1.2, 7.0, 0.3))])
    assert places(rows) == pytest.approx(np.array([[1, 0, 0], [1, 0, 0], [1.2, 0, 0.3]]))


def test_constants_come_flat_too():
    assert screws([*AT_ONE, *AT_ONE]).shape == (2, 6)


@pytest.mark.parametrize("row", [[0, 0, 2, 0, 0, 0], [0, 0, 1, 0, 0, 0.1], [0, 0, 0, 0, 0.5, 0], [math.nan] * 6])
def test_a_row_that_is_no_joint_is_refused(row):
    with pytest.raises(ValueError, match="expected joint 2 as an axis of length 1"):
        screws([*AT_ONE, *row])


def test_joints_are_borne_by_those_before_them():
    assert parents(None, 3).tolist() == [-1, 0, 1]
    assert parents([-1.0, 0.0, 0.0], 3).tolist() == [-1, 0, 0]
    for wrong in ([-1, 1, 0], [-2, 0, 1], [-1, 0, 5]):
        with pytest.raises(ValueError, match="to be borne by a joint before it"):
            parents(wrong, 3)
