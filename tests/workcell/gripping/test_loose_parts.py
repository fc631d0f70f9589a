"""Parts that move freely, where there are no forces: their size, and where they come to rest."""

import mujoco
import numpy as np
import pytest

from kit.worlds.grasping_cells import TOP, Cell
from onika.laws.frames import rotation_about
from onika.workcell.gripping.loose_parts import LooseParts


@pytest.fixture
def parts():
    world = Cell().world
    return LooseParts(world._plant, world._composition.parts)


def test_a_part_is_as_large_as_its_shapes_in_any_frame(parts):
    assert parts.names == ("cube", "other", "post", "plate")
    lowest, highest = parts.extent(0, np.eye(3))
    assert (lowest, highest) == (pytest.approx([-0.02] * 3), pytest.approx([0.02] * 3))
    _, turned = parts.extent(0, rotation_about(0.0, 0.0, 1.0, np.pi / 4)[:3, :3])
    assert turned == pytest.approx([0.02 * 2**0.5, 0.02 * 2**0.5, 0.02])
    _, post = parts.extent(2, rotation_about(0.0, 0.0, 1.0, 0.7)[:3, :3])
    assert post == pytest.approx([0.018, 0.018, 0.04])


def test_what_falls_stands_upright_on_what_is_below(parts):  # law 18, R-X19
    pose = parts.pose(2)
    pose[:3, :3] = rotation_about(1.0, 0.0, 0.0, 0.3)[:3, :3]
    pose[2, 3] = 0.5
    parts.put(2, pose)
    parts.drop([2])
    assert parts.pose(2)[:3, 3] == pytest.approx([0.55, -0.2, TOP + 0.04], abs=1e-6)
    assert parts.pose(2)[2, 2] == pytest.approx(1.0)


def test_what_falls_beside_the_table_lies_on_the_floor_and_what_reaches_into_it_is_lifted(parts):
    beside = parts.pose(0)
    beside[:3, 3] = (1.5, 0.0, 0.7)
    parts.put(0, beside)
    within = parts.pose(1)
    within[2, 3] = TOP + 0.019
    parts.put(1, within)
    parts.drop([0, 1])
    assert parts.pose(0)[2, 3] == pytest.approx(0.02, abs=1e-6)
    assert parts.pose(1)[2, 3] == pytest.approx(TOP + 0.02, abs=1e-6)


def test_what_stands_on_what(parts):
    for number, height in ((1, 0.06), (2, 0.12)):
        pose = parts.pose(number)
        pose[:3, 3] = (0.55, 0.0, TOP + height)
        parts.put(number, pose)
    mujoco.mj_kinematics(parts._model, parts._data)
    assert parts.standing_on(0) == [1, 2]
    assert parts.standing_on(2) == []
