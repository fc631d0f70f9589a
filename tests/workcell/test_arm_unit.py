import math

import mujoco
import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.workcell.arm_unit import ArmUnit
from onika.workcell.layout import base, boxes, text
from onika.workcell.plant import Plant

RIGHT = ("right",)


def _unit(side="left"):
    plant = Plant(text(boxes(0, 0.0), (side,), drawn=False))
    unit = ArmUnit(side, base(side))
    unit.bind(plant)
    unit.restart()
    plant.settle()
    return unit, plant


def test_its_sheet_says_who_it_is_and_where_it_stands():
    sheet = _unit("right")[0].sheet
    assert sheet.name == "arm_right"
    assert sheet.state == ("time", "drive", "q1", "q2", "q3", "q4", "q5", "q6")
    assert sheet.command == ("tau1", "tau2", "tau3", "tau4", "tau5", "tau6")
    assert sheet.identity["ROBOT"] == "puma560"
    assert np.array_equal(np.reshape(sheet.identity["BASE"], (4, 4)), base("right"))


def test_a_scara_has_four_joints_and_its_own_name():  # R-K03
    sheet = ArmUnit("left", base("left"), "scara").sheet
    assert sheet.name == "scara_left"
    assert sheet.command == ("tau1", "tau2", "tau3", "tau4")
    assert sheet.identity["ROBOT"] == adept_one.ROBOT


def test_before_it_is_in_the_world_it_stands_at_home():
    assert np.array_equal(ArmUnit("left", base("left")).state[2:], puma560.HOME)


@pytest.mark.parametrize("kind", [list, tuple, np.array, lambda values: memoryview(np.array(values))])
def test_torques_come_in_any_kind_of_row(kind):
    unit, plant = _unit()
    assert unit.follow(kind([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]))
    assert plant.data.ctrl[:6].tolist() == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]


@pytest.mark.parametrize("values", [[1.0], [1.0] * 7, np.zeros(5), memoryview(np.zeros(7))])
def test_a_wrong_number_of_torques_is_a_fault(values):
    with pytest.raises(ValueError, match=r".+"):
        _unit()[0].follow(values)


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_torques_that_are_not_finite_are_told(bad):
    unit, _ = _unit()
    assert not unit.follow(np.array([0.0, 0.0, bad, 0.0, 0.0, 0.0]))


def test_it_holds_its_posture_against_gravity_and_a_push():  # law 17
    unit, plant = _unit()
    start = np.array([0.2, -0.6, 2.5, 0.3, 0.8, 0.1])
    unit._q[:] = start
    plant.settle()
    unit.capture()
    unit._qd[:] = 0.5
    for _ in range(1000):
        unit.hold()
        mujoco.mj_step(plant.model, plant.data)
    unit.refresh(2.0)
    assert np.allclose(unit.state[2:], start, atol=1e-3)


def test_holding_torque_is_bias_and_spring_and_damper():
    unit, plant = _unit()
    unit.capture()
    unit._q += 0.01
    unit._qd[:] = 0.1
    unit.hold()
    expected = plant.data.qfrc_bias[24:30] - 0.01 * puma560.KP - 0.1 * puma560.KD
    assert np.allclose(plant.data.ctrl[:6], expected)
