import math

import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.workcell.kinematic_unit import KinematicUnit
from onika.workcell.layout import KINDS, base, boxes, text
from onika.workcell.part import STEP_S
from onika.workcell.plant import Plant


def _unit(kind="arm"):
    plant = Plant(text(boxes(0, 0.0), ("left",), drawn=False, kinds={"left": kind}))
    unit = KinematicUnit("left", base("left"), kind)
    unit.bind(plant)
    unit.restart()
    return unit


@pytest.mark.parametrize("kind", KINDS)
def test_its_sheet_tells_it_from_the_arm_with_motors(kind):  # law 18
    sheet, robot = _unit(kind).sheet, KINDS[kind].robot
    assert sheet.name == f"{kind}_left_kin"
    assert sheet.command == tuple(f"q{k}" for k in range(1, robot.NDOF + 1))
    assert sheet.identity["ROBOT"] == f"{robot.ROBOT}_kin"


@pytest.mark.parametrize("kind", KINDS)
def test_it_is_where_it_is_told_to_be_in_one_step(kind):  # R-K03, law 18
    unit = _unit(kind)
    goal = unit.robot.HOME + 0.9 * STEP_S * unit.robot.QDMAX
    assert unit.follow(goal)
    unit.move()
    unit.refresh(0.0)
    assert np.allclose(unit.state[2:], goal, atol=1e-15)


def test_a_far_goal_is_gone_to_as_quick_as_the_joints_can():
    unit = _unit()
    unit.follow(puma560.HOME + 1.0)
    unit.move()
    assert np.allclose(unit._q, puma560.HOME + STEP_S * puma560.QDMAX)


def test_a_goal_beyond_a_limit_is_held_at_it():
    unit = _unit("scara")
    unit.follow([0.0, 0.0, 1.0, 0.0])
    for _ in range(2000):
        unit.move()
    assert unit._q[2] == adept_one.QMAX[2]


@pytest.mark.parametrize("bad", [math.nan, math.inf])
def test_angles_that_are_not_finite_are_told_and_not_followed(bad):
    unit = _unit()
    assert not unit.follow([bad, 0, 0, 0, 0, 0])
    unit.move()
    assert np.array_equal(unit._q, puma560.HOME)


def test_it_holds_where_it_is_without_a_servo():
    unit = _unit()
    unit.follow(puma560.HOME + 1.0)
    unit.move()
    unit.capture()
    at = unit._q.copy()
    unit.move()
    assert np.array_equal(unit._q, at)
    assert not unit.holds
