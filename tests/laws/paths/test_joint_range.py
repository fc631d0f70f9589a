"""The range of joints over a whole motion."""

import numpy as np
import pytest

from onika.laws.paths.joint_range import check_range

PLACES = np.array([[0.0, -1.0], [0.5, 0.0], [0.2, 1.0]])


def test_a_motion_within_its_range_is_none_of_its_business():
    check_range(PLACES, [0.0, -1.0], [0.5, 1.0])


@pytest.mark.parametrize(
    ("low", "high", "sentence"),
    [
        ([0.0, -1.0], [0.4, 1.0], "joint 1 would stand at 0.500 rad, beyond 0.000..0.400"),
        ([0.0, -0.5], [0.5, 1.0], "joint 2 would stand at -1.000 rad, beyond -0.500..1.000"),
    ],
)
def test_the_first_joint_that_leaves_it_is_told(low, high, sentence):
    with pytest.raises(ValueError, match=sentence):
        check_range(PLACES, low, high)
