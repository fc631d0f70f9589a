import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.laws.chain import chain_pose
from onika.laws.frames import rotation_of_rpy
from onika.laws.puma_family import puma_table
from onika.laws.textbook import screws_of, tool_of

MOVED = np.eye(4)
MOVED[:3, :3], MOVED[:3, 3] = rotation_of_rpy(0.3, -0.2, 1.1), (0.4, -0.1, 0.2)


def moved(screw, pose):
    """The same joints seen from another frame."""
    turn, way = pose[:3, :3], pose[:3, 3]
    axes, moments = screw[:, :3] @ turn.T, screw[:, 3:] @ turn.T
    return np.hstack((axes, moments + np.cross(way, axes)))


@pytest.mark.parametrize("offsets", [np.zeros(6), np.array([0.1, -0.2, 0.3, 0.2, -0.1, 0.4])])
@pytest.mark.parametrize("pose", [np.eye(4), MOVED])
def test_the_table_of_the_family_is_found_behind_its_screws_wherever_they_are_seen_from(offsets, pose):  # decision 46
    dh = puma560.DH.copy()
    dh[:, 3] += offsets
    table = puma_table(moved(screws_of(dh), pose))
    assert table is not None
    assert table.dh[:, :2] == pytest.approx(dh[:, :2], abs=1e-12)
    tool = np.linalg.inv(table.last) @ pose @ tool_of(dh, puma560.TOOL)
    for q in np.random.default_rng(1).uniform(puma560.QMIN, puma560.QMAX, (50, 6)):
        reached = table.first @ chain_pose(table.dh, np.zeros(6), q) @ tool
        at_zero = table.first @ chain_pose(table.dh, np.zeros(6), np.zeros(6))
        assert at_zero == pytest.approx(table.last, abs=1e-12)
        assert np.abs(reached - pose @ chain_pose(dh, np.zeros(6), q) @ puma560.TOOL).max() < 1e-12


def test_the_pumas_own_table_comes_back_but_for_where_its_frames_stand_on_their_axes():
    table = puma_table(screws_of(puma560.DH))
    assert table is not None
    assert table.dh[:, 0] == pytest.approx(puma560.DH[:, 0], abs=1e-16)
    assert not table.dh[:, 3].any() and np.array_equal(table.first, np.eye(4))


@pytest.mark.parametrize(("row", "column"), [(0, 0), (0, 1), (1, 1), (2, 1), (3, 0), (3, 1), (4, 0), (4, 1), (4, 2)])
def test_other_joints_are_not_of_the_family(row, column):
    dh = puma560.DH.copy()
    dh[row, column] += 1e-4
    assert puma_table(screws_of(dh)) is None


def test_joints_that_slide_are_more_or_fewer_or_point_away_are_not_of_the_family():
    assert puma_table(screws_of(puma560.DH, np.array([0, 0, 1, 0, 0, 0]))) is None
    assert puma_table(screws_of(puma560.DH[:5])) is None and puma_table(screws_of(adept_one.DH)) is None
    dh = puma560.DH.copy()
    dh[3, 2] *= -1.0
    assert puma_table(screws_of(dh)) is None
