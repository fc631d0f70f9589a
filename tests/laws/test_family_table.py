import math

import numpy as np
import pytest

from onika.laws.family_table import across, frame, turn_about

X, Y, Z = np.eye(3)


def test_a_frame_is_right_handed():
    pose = frame(Y, Z, np.array([1.0, 2.0, 3.0]))
    assert np.linalg.det(pose[:3, :3]) == pytest.approx(1.0)
    assert pose[:3, 1].tolist() == [-1.0, 0.0, 0.0] and pose[:3, 3].tolist() == [1.0, 2.0, 3.0]


def test_a_turn_counts_about_its_axis():
    assert turn_about(Z, X, Y) == pytest.approx(math.pi / 2) == -turn_about(-Z, X, Y)


def test_what_lies_along_an_axis_is_taken_away():
    assert across(Z, np.array([1.0, 2.0, 3.0])).tolist() == [1.0, 2.0, 0.0]
