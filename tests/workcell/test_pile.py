import math

import mujoco
import numpy as np
import pytest

from onika.workcell.arm import SHOULDER_M
from onika.workcell.box import SIGNS, SIZE_M
from onika.workcell.layout import boxes, text
from onika.workcell.pile import Pile
from onika.workcell.plant import Plant
from onika.workcell.table import TOP_M

WAVES, TRIANGLE, SQUARE, CROSS = range(4)
HIGH = SIZE_M[2]


@pytest.fixture
def plant():
    return Plant(text(boxes(0, 0.0), (), drawn=False))


@pytest.fixture
def pile(plant):
    return Pile(plant)


def at(x, y, z, yaw=0.0):
    pose = np.eye(4)
    pose[:2, :2] = [[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]]
    pose[:3, 3] = x, y, z
    return pose


def drop(pile, number, pose):
    pile.held.add(number)
    pile.put(number, pose)
    pile.drop([number])
    return pile.pose(number)


def test_a_box_is_where_it_was_put(plant, pile):
    pose = at(0.6, 0.1, 0.2, 0.7)
    pile.put(SQUARE, pose)
    assert np.allclose(pile.pose(SQUARE), pose)
    mujoco.mj_kinematics(plant.model, plant.data)
    assert np.allclose(plant.data.xpos[plant.body(f"box_{SIGNS[SQUARE]}")], pose[:3, 3])


def test_a_box_falls_onto_what_is_below_it():  # R-K03
    pile = Pile(Plant(text(boxes(0, 0.0), (), drawn=False)))
    for place, height in (((0.5, 0.3), TOP_M), ((0.70, 0.01), TOP_M + HIGH), ((0.1, 0.0), -SHOULDER_M)):
        assert drop(pile, CROSS, at(*place, 0.0))[:3, 3] == pytest.approx([*place, height + HIGH / 2])


def test_a_box_pressed_into_another_comes_to_stand_on_it(pile):
    assert drop(pile, CROSS, at(0.70, 0.0, TOP_M + HIGH))[2, 3] == pytest.approx(TOP_M + 1.5 * HIGH)


def test_a_box_beside_another_stands_beside_it(pile):
    beside = 0.70 + SIZE_M[0] + 0.001
    assert drop(pile, CROSS, at(beside, 0.0, 0.0))[2, 3] == pytest.approx(TOP_M + HIGH / 2)


def test_turned_boxes_are_judged_by_their_corners(pile):
    beside = 0.70 + SIZE_M[0] + 0.001
    assert drop(pile, CROSS, at(beside, 0.0, 0.0, math.pi / 4))[2, 3] == pytest.approx(TOP_M + 1.5 * HIGH)


def test_it_keeps_its_turn_about_the_vertical_and_loses_every_other(pile):
    pose = at(0.5, 0.3, 0.0, 0.4)
    pose[:3, :3] = pose[:3, :3] @ [[1, 0, 0], [0, math.cos(0.2), -math.sin(0.2)], [0, math.sin(0.2), math.cos(0.2)]]
    assert np.allclose(drop(pile, CROSS, pose)[:3, :3], at(0, 0, 0, 0.4)[:3, :3], atol=1e-9)


def test_boxes_that_are_let_go_together_fall_on_each_other(pile):
    for level, number in enumerate((SQUARE, CROSS)):
        pile.held.add(number)
        pile.put(number, at(0.5, 0.3, 0.1 + HIGH * level))
    pile.drop([CROSS, SQUARE])
    assert [pile.pose(box)[2, 3] for box in (SQUARE, CROSS)] == pytest.approx([TOP_M + HIGH / 2, TOP_M + 1.5 * HIGH])
    assert pile.held == set()


def test_what_stands_on_a_box_is_known_up_to_the_top(pile):
    drop(pile, TRIANGLE, at(0.70, 0.0, 0.0))
    drop(pile, SQUARE, at(0.70, 0.0, 0.0))
    assert pile.standing_on(WAVES) == [TRIANGLE, SQUARE]
    assert pile.standing_on(SQUARE) == pile.standing_on(CROSS) == []


def test_a_box_in_a_hand_carries_and_stops_nothing(pile):
    pile.put(WAVES, at(0.5, 0.3, 0.0))
    pile.held.add(WAVES)
    assert drop(pile, CROSS, at(0.5, 0.3, 0.2))[2, 3] == pytest.approx(TOP_M + HIGH / 2)
