import math

import mujoco
import pytest

from onika.ring.device import DeviceOrder, DriveState
from onika.workcell.boxes import BoxesWorld
from onika.workcell.gripper import CLOSED_M, TRAVEL_M
from onika.workcell.gripper_unit import GripperUnit
from onika.workcell.layout import boxes, text
from onika.workcell.plant import Plant


def _unit():
    plant = Plant(text(boxes(0, 0.0), ("left",), drawn=False))
    unit = GripperUnit("left")
    unit.bind(plant)
    unit.restart()
    plant.settle()
    return unit, plant


def test_it_starts_closed_and_under_pressure():
    unit, plant = _unit()
    unit.refresh(0.0)
    assert unit.state[2] == CLOSED_M
    assert plant.data.ctrl[6:].tolist() == plant.data.act.tolist() == [-1.0, -1.0]


def test_above_nothing_opens_below_closes_and_nothing_keeps():
    unit, plant = _unit()
    for signal, valve in ((0.3, 1.0), (0.0, 1.0), (7.0, 1.0), (-0.1, -1.0), (0.0, -1.0)):
        assert unit.follow([signal])
        assert plant.data.ctrl[6:].tolist() == [valve, valve]


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_a_signal_that_is_not_finite_changes_nothing(bad):
    unit, plant = _unit()
    assert not unit.follow([bad])
    assert plant.data.ctrl[6:].tolist() == [-1.0, -1.0]


@pytest.mark.parametrize("values", [[], [1.0, 1.0]])
def test_a_wrong_number_of_signals_is_a_fault(values):
    with pytest.raises(ValueError, match="unpack"):
        _unit()[0].follow(values)


def test_opening_and_speed_are_those_of_both_fingers():
    unit, plant = _unit()
    unit.follow([1.0])
    mujoco.mj_step(plant.model, plant.data, 20)
    unit.refresh(0.04)
    assert CLOSED_M < unit.state[2] < CLOSED_M + 2 * TRAVEL_M
    assert unit.state[3] > 0.0
    mujoco.mj_step(plant.model, plant.data, 300)
    unit.refresh(0.64)
    assert unit.state[2] == pytest.approx(CLOSED_M + 2 * TRAVEL_M, abs=2e-3)
    unit.sense()
    assert unit.state[4] == 0.0  # nothing between the pads


def test_in_hold_and_tripped_it_keeps_its_pressure():  # law 17
    world = BoxesWorld()
    world.claim("gripper_left", 1)
    world.command("gripper_left", 1, DeviceOrder.DRIVE, [1.0])
    world.step(1_000_000_000)
    assert world.state("gripper_left")[1] == DriveState.TRIPPED
    assert world.state("gripper_left")[2] == pytest.approx(CLOSED_M + 2 * TRAVEL_M, abs=2e-3)
