import math

import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.laws.chain import chain_pose, kinds_of
from onika.laws.scara_family import scara_table
from onika.laws.textbook import screws_of, tool_of


@pytest.mark.parametrize("down", [math.pi, 0.0])
@pytest.mark.parametrize("offsets", [np.zeros(4), np.array([0.2, -0.4, 0.1, 0.7])])
def test_the_table_of_the_family_is_found_behind_its_screws(down, offsets):  # R-K03, decision 46
    dh = adept_one.DH.copy()
    dh[1, 1] = down
    dh[:, 3] += offsets
    table = scara_table(screws_of(dh))
    assert table is not None
    tool, kinds = np.linalg.inv(table.last) @ tool_of(dh, adept_one.TOOL), kinds_of(dh)
    for q in np.random.default_rng(1).uniform(adept_one.QMIN, adept_one.QMAX, (50, 4)):
        reached = table.first @ chain_pose(table.dh, kinds_of(table.dh), q) @ tool
        assert np.abs(reached - chain_pose(dh, kinds, q) @ adept_one.TOOL).max() < 1e-12


@pytest.mark.parametrize(("row", "column", "value"), [(0, 1, 0.1), (1, 1, 0.1), (2, 1, 0.1), (0, 0, 0.0), (1, 0, 0.0)])
def test_what_is_bent_otherwise_is_not_of_the_family(row, column, value):
    dh = adept_one.DH.copy()
    dh[row, column] = value
    assert scara_table(screws_of(dh)) is None


def test_only_four_joints_with_the_third_one_sliding_are_of_the_family():
    assert scara_table(screws_of(adept_one.DH, np.zeros(4))) is None
    assert scara_table(screws_of(puma560.DH)) is None
    assert scara_table(screws_of(adept_one.DH[[0, 1, 2, 3, 3]])) is None
