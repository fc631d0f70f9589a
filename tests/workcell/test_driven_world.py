"""What every world of devices with drives does with claims, commands and silence, tried on one slide."""

import numpy as np
import pytest
from mujoco import mj_step

from onika.ring.device import DeviceOrder, DeviceSheet, DriveState
from onika.ring.drive import DriveInput
from onika.workcell.driven_world import DrivenWorld
from onika.workcell.panic_button import PanicButton
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit

RAIL = (
    '<mujoco><option timestep="0.002"/><worldbody><body name="car"><geom size="0.1" mass="1"/>'
    '<joint name="rail" type="slide" axis="1 0 0"/></body></worldbody>'
    '<actuator><position name="pull" joint="rail" kp="400" kv="40"/></actuator></mujoco>'
)


class Car(DeviceUnit):
    def __init__(self):
        super().__init__(DeviceSheet("car", ("time", "drive", "q"), ("q",), {}), "rail", holds=True)
        self.holds_told = 0

    def bind(self, plant):
        self._q, self._signal = plant.data.qpos, plant.data.ctrl

    def follow(self, values):
        self._signal[:] = values
        return bool(np.isfinite(values).all())

    def hold(self):
        self.holds_told += 1

    def refresh(self, time):
        self.state[0], self.state[2] = time, self._q[0]


class RailWorld(DrivenWorld):
    step_ns = 2_000_000

    def __init__(self):
        self.car = Car()
        super().__init__([self.car], [PanicButton(self.car)])
        self._plant = Plant(RAIL)
        self._advance, self._feel = mj_step, self._plant.sense
        self._bind_units([self.car], [self.car])


@pytest.fixture
def world():
    return RailWorld()


def test_a_device_follows_whoever_claims_it(world):  # R-E09
    world.claim("car", 1)
    world.command("car", 1, DeviceOrder.DRIVE, [0.1])
    for _ in range(50):
        world.step(world.now_ns + world.step_ns * 10)
        world.command("car", 1, DeviceOrder.DRIVE, [0.1])
    assert world.state("car")[2] == pytest.approx(0.1, abs=1e-3)
    world.command("car", 2, DeviceOrder.DRIVE, [5.0])
    world.step(world.now_ns + world.step_ns)
    assert world.state("car")[2] == pytest.approx(0.1, abs=1e-3)


def test_silence_holds_and_then_trips(world):  # R-F01
    world.claim("car", 1)
    world.command("car", 1, DeviceOrder.DRIVE, [0.1])
    world.step(400_000_000)
    states = [DriveState(event.state) for event in world.take_events()]
    assert states == [DriveState.DRIVEN, DriveState.HELD, DriveState.TRIPPED]
    assert world.car.holds_told > 0


def test_its_panic_button_stops_it(world):
    world.claim("car", 1)
    world.touch("panic_rail", 1.0)
    assert world.state("car")[1] == DriveState.PRESSED
    world.stop()
    world.go_on()
    world.touch("panic_rail", 0.0)
    assert world.state("car")[1] == DriveState.TRIPPED
    assert world.take_events()[0].cause == DriveInput.PRESS.value


def test_what_is_unknown_is_refused(world):  # R-B07
    with pytest.raises(ValueError, match="expected one of car"):
        world.claim("arm", 1)
    with pytest.raises(ValueError, match="expected 1 values"):
        world.claim("car", 1)
        world.command("car", 1, DeviceOrder.DRIVE, [0.1, 0.2])


def test_a_dead_writer_claims_nothing_any_more(world):
    world.claim("car", 1)
    world.fence(1)
    assert world.state("car")[1] == DriveState.TRIPPED
    with pytest.raises(ValueError, match="which died"):
        world.claim("car", 1)
