"""The way of a gripper's fingers, found by trying."""

import pytest

from kit.worlds.box_cells import boxes_world
from kit.worlds.grasping_cells import Cell


def way_of(world):
    ((unit, (way, _)),) = world._hands.ways.items()
    return unit, way


@pytest.mark.parametrize(("world", "joints"), [(Cell().world, (0.0, 0.03)), (boxes_world(), (0.0, 0.026))])
def test_both_ends_of_coupled_fingers_are_found_whatever_moves_them(world, joints):  # R-X19
    if "arm_left" in {sheet.name for sheet in world.devices()}:
        world.claim("arm_left", 1)
    _, way = way_of(world)
    assert way._closed == pytest.approx([joints[0]] * 2, abs=1e-3)
    assert way._opened == pytest.approx([joints[1]] * 2, abs=1e-3)
    way.go(0.5, 0.0)
    assert way.share() == pytest.approx(0.5)


def test_fingers_are_told_apart_by_the_way_they_go():  # R-X19
    world = Cell().world
    _, way = way_of(world)
    model = world._plant.model
    named = {model.body(int(model.geom_bodyid[shape])).name: number for shape, number in way.fingers.items()}
    assert set(named) == {"left.finger1", "left.finger2"}
    assert named["left.finger1"] != named["left.finger2"]
