"""What every world does with its drives: what holds and trips one, in the boxes and on a slide of its own."""

import math
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from mujoco import mj_step

from kit.worlds.assembler import DT, Assembler
from kit.worlds.box_cells import boxes_world
from onika.laws import puma560
from onika.laws.path import quintic
from onika.ring.device import DeviceOrder, DeviceSheet, DriveEvent, DriveState
from onika.ring.drive import DriveInput, DriveMode
from onika.words.reason import NOTHING
from onika.workcell.driven_world import DrivenWorld
from onika.workcell.panic_button import PanicButton
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit

MS = 1_000_000


def claimed(*names, epoch=1):
    world = boxes_world()
    for name in names:
        world.claim(name, epoch)
    return world


# ---- the drive in the world ----


def test_silence_holds_at_the_first_step_beyond_fifty_and_trips_beyond_two_hundred_and_fifty():  # law 17
    world = claimed("arm_left")
    world.step(100 * MS)
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    world.step(600 * MS)
    last = 100 * MS
    driven, held, tripped = world.take_events()
    assert held.stands.key == "workcell.stands_at"
    assert [driven, replace(held, stands=NOTHING), tripped] == [
        DriveEvent("arm_left", DriveState.DRIVEN, 100 * MS, 98 * MS, -1, DriveInput.DRIVE.value),
        DriveEvent("arm_left", DriveState.HELD, 152 * MS, 150 * MS, last, DriveInput.SILENCE.value),
        DriveEvent("arm_left", DriveState.TRIPPED, 352 * MS, 350 * MS, last, DriveInput.LONG_SILENCE.value),
    ]
    assert world.take_events() == []


def test_commands_that_keep_coming_keep_it_driven():
    world = claimed("arm_left")
    for _ in range(20):
        world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
        world.step(world.now_ns + 50 * MS)
    assert [event.state for event in world.take_events()] == [DriveState.DRIVEN]


def test_a_commanded_hold_does_not_trip_and_the_arm_stays_where_it_was():
    world = boxes_world()
    assembler = Assembler(world)
    assembler.turn(np.add(puma560.HOME, [0.3, 0.4, 0.3, 0.2, 0.5, 0.1]))
    there = assembler.q.copy()
    world.command("arm_left", 1, DeviceOrder.HOLD, ())
    world.step(world.now_ns + 1000 * MS)
    assert world.state("arm_left")[1] == DriveState.HELD
    assert np.allclose(assembler.q, there, atol=2e-3)


@pytest.mark.parametrize("device", ["arm_left", "gripper_left"])
@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("driven", [True, False])
def test_a_command_that_is_not_finite_is_never_applied_and_trips(device, bad, driven):  # law 5
    world = claimed(device)
    count = 6 if device == "arm_left" else 1
    if driven:
        world.command(device, 1, DeviceOrder.DRIVE, np.zeros(count))
    world.command(device, 1, DeviceOrder.DRIVE, np.full(count, bad))
    assert world.state(device)[1] == DriveState.TRIPPED
    world.step(100 * MS)
    assert np.isfinite(world.state(device)).all()
    assert np.allclose(world.state("arm_left")[2:], puma560.HOME, atol=2e-3)
    assert world.take_events()[-1].cause == DriveInput.UNSOUND.value


def test_a_stop_is_latched_until_reset_or_until_it_goes_on():  # law 27
    world = claimed("arm_left", "gripper_left")
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    world.stop()
    for order in (DeviceOrder.CLEAR, DeviceOrder.DRIVE):
        world.command("arm_left", 1, order, np.zeros(6))
        assert world.state("arm_left")[1] == DriveState.HELD
    world.step(500 * MS)
    assert [event.cause for event in world.take_events()] == [DriveInput.DRIVE.value, DriveInput.STOP.value]
    world.go_on()
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == DriveState.DRIVEN


def test_reset_puts_everything_back_and_clears_latches_and_time_goes_on():
    world, fresh = boxes_world(5), boxes_world(5)
    assembler = Assembler(world)
    Assembler(fresh)
    assembler.grip(1.0)
    assembler.turn(puma560.HOME + 0.2)
    world.fence(1)
    world.stop()
    now = world.now_ns
    world.reset()
    assert world.now_ns == now
    assert np.array_equal(world.state("arm_left")[1:], fresh.state("arm_left")[1:])
    assert np.array_equal(world.poses(), fresh.poses())
    assert world.fingerprint()[8:] == fresh.fingerprint()[8:]


# ---- the panic button ----


def shown(world, device="arm_left"):
    return DriveState(int(world.state(device)[1]))


def test_a_pressed_panic_button_holds_its_arm_where_it_is_and_no_other():  # R-K06
    world = boxes_world()
    left, right = Assembler(world, "left", 1), Assembler(world, "right", 2)
    target = left.reference + 0.3
    for k in range(150):
        value, rate = quintic(k * DT, 0.6)
        for arm in (left, right):
            arm.reference[:], arm.speed[:] = puma560.HOME + value * 0.3, rate * np.full(6, 0.3)
        left.command()
        right.tick()
    world.touch("panic_left", 1)
    at = left.q.copy()
    for _ in range(250):
        left.command()
        right.tick()
    assert (shown(world), shown(world, "gripper_left"), shown(world, "arm_right")) == (
        DriveState.PRESSED,
        DriveState.DRIVEN,
        DriveState.DRIVEN,
    )
    assert np.abs(left.q - at).max() < 0.05  # it brakes
    assert np.abs(left.q - target).max() > 0.1
    assert world.take_events()[-1].cause == DriveInput.PRESS.value


def test_a_pressed_panic_button_is_cleared_only_after_it_was_let_go():  # R-K06
    world = claimed("arm_left")
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    world.touch("panic_left", 1.0)
    for order in (DeviceOrder.CLEAR, DeviceOrder.HOLD, DeviceOrder.DRIVE):
        world.command("arm_left", 1, order, np.zeros(6))
        assert shown(world) is DriveState.PRESSED
    world.touch("panic_left", 0.0)
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    assert shown(world) is DriveState.TRIPPED
    world.command("arm_left", 1, DeviceOrder.CLEAR, ())
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    assert shown(world) is DriveState.DRIVEN


@pytest.mark.parametrize("leave", ["go_on", "reset"])
def test_a_button_stays_pressed_over_a_stop_and_over_its_end(leave):  # R-K06, law 27
    world = claimed("arm_left")
    world.stop()
    world.touch("panic_left", 1.0)
    assert shown(world) is DriveState.HELD
    getattr(world, leave)()
    assert shown(world) is DriveState.PRESSED


def test_a_part_that_is_not_there_is_refused_with_those_that_are():
    world = boxes_world()
    assert list(world.parts()) == ["panic_left", "panic_right"]
    with pytest.raises(ValueError, match=r"panic_left: 1 pressed, 0 let go; panic_right: .*, found 'panic'"):
        world.touch("panic", 1.0)
    with pytest.raises(ValueError, match="found 2"):
        world.touch("panic_left", 2.0)
    assert not world.take_events()


def test_commands_of_the_wrong_shape_are_faults():
    world = claimed("arm_left", "gripper_left", "lamp")
    for device, order, values in (
        ("arm_left", DeviceOrder.DRIVE, [0.0]),
        ("gripper_left", DeviceOrder.DRIVE, [0.0, 0.0]),
        ("arm_left", 9, ()),
        ("lamp", DeviceOrder.DRIVE, [1.0]),
        ("lamp", DeviceOrder.HOLD, ()),
    ):
        with pytest.raises(ValueError, match=r"expected|9"):
            world.command(device, 1, order, values)
    assert not world.take_events()


def test_nobody_drives_what_nobody_claims():
    world = boxes_world()
    for epoch in (-1, 0, 1):
        world.command("arm_left", epoch, DeviceOrder.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == DriveState.HELD
    assert not world.take_events()


def test_the_world_says_how_the_drives_of_its_arms_and_hands_stand():  # R-X24, law 17
    world = claimed("arm_left", "gripper_left")
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    assert world.modes() == {"arm_left": DriveMode.DRIVEN, "gripper_left": DriveMode.HELD}
    world.stop()
    assert set(world.modes().values()) == {DriveMode.STOPPED}


# ---- another world ----

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
        self._plant = Plant(mujoco.MjModel.from_xml_string(RAIL))
        self._advance, self._feel = mj_step, self._plant.sense
        self._bind_units([self.car], [self.car])


def test_a_device_follows_whoever_claims_it():  # R-E09
    world = RailWorld()
    world.claim("car", 1)
    world.command("car", 1, DeviceOrder.DRIVE, [0.1])
    for _ in range(50):
        world.step(world.now_ns + world.step_ns * 10)
        world.command("car", 1, DeviceOrder.DRIVE, [0.1])
    assert world.state("car")[2] == pytest.approx(0.1, abs=1e-3)
    world.command("car", 2, DeviceOrder.DRIVE, [5.0])
    world.step(world.now_ns + world.step_ns)
    assert world.state("car")[2] == pytest.approx(0.1, abs=1e-3)


def test_silence_holds_and_then_trips():  # R-F01
    world = RailWorld()
    world.claim("car", 1)
    world.command("car", 1, DeviceOrder.DRIVE, [0.1])
    world.step(400_000_000)
    states = [DriveState(event.state) for event in world.take_events()]
    assert states == [DriveState.DRIVEN, DriveState.HELD, DriveState.TRIPPED]
    assert world.car.holds_told > 0


# ---- what is otherwise in it ----


def test_what_is_varied_stays_so_when_an_arm_comes():  # R-X23
    world = boxes_world()
    world.vary("mass", 2.0)
    heavy = world._plant.model.body_mass[world._plant.body("box_waves.box")]
    world.claim("arm_left", 1)
    assert world._plant.model.body_mass[world._plant.body("box_waves.box")] == pytest.approx(heavy)
    plain = boxes_world()._plant
    assert heavy == pytest.approx(2.0 * plain.model.body_mass[plain.body("box_waves.box")])


@pytest.mark.parametrize(
    ("name", "factor", "words"),
    [("colour", 2.0, "expected one of friction and mass"), ("mass", 0.0, "0.01 to 100"), ("mass", math.nan, "0.01 to")],
)
def test_what_cannot_be_varied_is_refused_with_what_can(name, factor, words):  # R-X23
    with pytest.raises(ValueError, match=words):
        boxes_world().vary(name, factor)
