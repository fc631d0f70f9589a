import math

import numpy as np
import pytest

from onika.laws import adept_one, puma560
from onika.laws.arm import Arm
from onika.laws.filter import Derivative
from onika.laws.frames import pose_of_nine
from onika.laws.inverse import inverse_for
from onika.laws.path import Line, joint_duration, quintic
from onika.ring.device import Drive, DriveEvent, Order
from onika.workcell.boxes import BoxesWorld
from onika.workcell.layout import LAYOUT_M
from onika.workcell.table import TOP_M

DT, MS = 0.002, 1_000_000
GRASP, ABOVE = TOP_M + 0.0254, -0.125
LIFTED = [0.0, -0.7, 2.9, 0.0, 1.0, 1.36]


class Operator:
    """A whole control system in one loop: gravity model, joint servo, path, straight line and inverse kinematics."""

    def __init__(self, world, side="left", epoch=1):
        self.world, self.epoch = world, epoch
        self.arm, self.hand = f"arm_{side}", f"gripper_{side}"
        sheet = world.claim(self.arm, epoch)
        world.claim(self.hand, epoch)
        base = np.reshape(sheet.identity["BASE"], (4, 4))
        self.law = Arm(puma560.DH, puma560.DYN, puma560.LOAD, base, puma560.TOOL)
        self.inverse = inverse_for(puma560.DH, base, puma560.TOOL, puma560.QMIN, puma560.QMAX)
        self.q = world.state(self.arm)[2:]
        self.reference, self.speed = self.q.copy(), np.zeros(6)
        self.derivative = Derivative(6, DT, 60.0)
        self.derivative.reset(self.q)
        self.signal, self.worst = -1.0, 0.0

    def command(self):
        measured = self.derivative.update(self.q)
        torque = self.law.bias(self.q, measured) + self.law.viscous * self.speed
        torque += puma560.KP * (self.reference - self.q) + puma560.KD * (self.speed - measured)
        self.world.command(self.arm, self.epoch, Order.DRIVE, torque)
        self.world.command(self.hand, self.epoch, Order.DRIVE, [self.signal])

    def tick(self):
        self.command()
        self.world.step(self.world.now_ns + self.world.step_ns)
        self.worst = max(self.worst, float(np.abs(self.reference - self.q).max()))

    def settle(self):
        self.speed[:] = 0.0
        for _ in range(250):
            self.tick()
            if np.abs(self.reference - self.q).max() < 1e-3 and np.abs(self.derivative.value).max() < 0.01:
                return

    def turn(self, q):
        start = self.reference.copy()
        duration = joint_duration(start, q, 0.6 * puma560.QDMAX)
        for k in range(math.ceil(duration / DT)):
            value, rate = quintic((k + 1) * DT, duration)
            self.reference[:], self.speed[:] = start + value * (q - start), rate * (q - start)
            self.tick()
        self.settle()

    def go(self, pose):
        line = Line(self.law.forward(self.reference), pose)
        duration = line.duration(0.3, 1.0)
        for k in range(math.ceil(duration / DT)):
            q = self.inverse.nearest(line.at(quintic((k + 1) * DT, duration)[0]), self.reference)
            assert not isinstance(q, str), q
            self.speed[:], self.reference[:] = (q - self.reference) / DT, q
            self.tick()
        self.settle()

    def grip(self, signal):
        self.signal = signal
        for _ in range(200):
            self.tick()

    def above(self, sign):
        near = LIFTED if self.arm == "arm_left" else [*LIFTED[:5], -1.78]
        q = self.inverse.nearest(pose_at(*LAYOUT_M[sign], ABOVE), near)
        assert not isinstance(q, str), q
        return q


def pose_at(x, y, z):
    return pose_of_nine([0.0, 0.0, -1.0, 0.0, 1.0, 0.0, x, y, z])


def actions(operator):
    """The twenty-four actions of chapter 6, as (verb, argument)."""
    waves = LAYOUT_M["waves"]
    rows = [(operator.grip, 1.0)]
    for level, sign in enumerate(("triangle", "square", "cross"), 1):
        rows += [
            (operator.turn, operator.above(sign)),
            (operator.go, pose_at(*LAYOUT_M[sign], GRASP)),
            (operator.grip, -1.0),
            (operator.turn, operator.above(sign)),
            (operator.turn, operator.above("waves")),
            (operator.go, pose_at(*waves, TOP_M + 0.0508 * (level + 0.5) + 0.0008)),
            (operator.grip, 1.0),
            (operator.turn, operator.above("waves")),
        ]
    return rows[:-1]


def run(operator, left_out=()):
    for number, (verb, argument) in enumerate(actions(operator)):
        if number not in left_out:
            verb(argument)


def lit(world):
    return world.state("lamp")[2:].all()


def claimed(*names, epoch=1):
    world = BoxesWorld()
    for name in names:
        world.claim(name, epoch)
    return world


# ---- the assembly ----


@pytest.mark.parametrize(("seed", "side"), [(1, "left"), (2, "right")])
def test_twenty_four_actions_light_the_lamp(seed, side):  # R-K01, R-K02
    world = BoxesWorld(seed, 0.001)
    operator = Operator(world, side)
    assert len(actions(operator)) == 24
    run(operator)
    assert lit(world)
    assert world.lit == ("lamp",)
    assert operator.worst < 0.01
    assert [event.state for event in world.take_events()] == [Drive.DRIVEN, Drive.DRIVEN]


def test_a_forgotten_close_leaves_it_dark():  # R-K01
    world = BoxesWorld(1, 0.001)
    operator = Operator(world)
    run(operator, left_out=(11,))
    assert not lit(world)
    assert world.lit == ()
    assert world.state("lamp")[2:].tolist() != [1.0] * 6


def test_a_grasped_box_is_held_by_friction_and_felt_by_the_pads():
    world = BoxesWorld()
    operator = Operator(world)
    run(operator, left_out=range(5, 24))
    hand = world.state("gripper_left")
    assert hand[2] == pytest.approx(0.0762, abs=1e-3)
    assert hand[4] == pytest.approx(60.0, rel=0.1)
    assert world.poses()[2, 2] > GRASP + 0.15


def test_two_arms_work_in_one_world_and_one_holds_while_the_other_moves():  # R-K02
    world = BoxesWorld()
    left, right = Operator(world, "left", 1), Operator(world, "right", 2)
    target = left.above("triangle")
    start = left.reference.copy()
    for k in range(300):
        value, rate = quintic(k * DT, 0.6)
        left.reference[:], left.speed[:] = start + 0.3 * value * (target - start), 0.3 * rate * (target - start)
        left.command()
        right.tick()
    assert np.abs(left.q - left.reference).max() < 0.01
    assert np.abs(right.q - puma560.HOME).max() < 1e-3


# ---- time and sameness ----


def test_equal_runs_are_equal_to_the_last_bit():
    marks = []
    for _ in range(2):
        world = BoxesWorld(3, 0.001)
        operator = Operator(world)
        operator.grip(1.0)
        world.claim("arm_right", 2)
        operator.turn(puma560.HOME + 0.1)
        marks.append(world.fingerprint())
    assert marks[0] == marks[1]
    assert BoxesWorld(4, 0.001).fingerprint() != BoxesWorld(3, 0.001).fingerprint()


def test_one_long_step_is_many_short_ones():
    long, short = claimed("arm_left"), claimed("arm_left")
    long.step(400 * MS)
    for k in range(1, 201):
        short.step(2 * k * MS)
    assert long.fingerprint() == short.fingerprint()
    assert np.array_equal(long.state("arm_left"), short.state("arm_left"))


def test_time_goes_in_whole_steps_and_not_beyond_what_is_asked():
    world = claimed("arm_left")
    world.step(7 * MS)
    assert world.now_ns == 6 * MS
    assert world.state("arm_left")[0] == pytest.approx(0.006)
    world.step(7 * MS)
    assert world.now_ns == 6 * MS


# ---- claims ----


def test_devices_are_named_before_they_are_in_the_world():
    world = BoxesWorld()
    names = [sheet.name for sheet in world.devices()]
    arms = {f"{kind}_{side}{mode}" for kind in ("arm", "scara") for side in ("left", "right") for mode in ("", "_kin")}
    assert set(names) == arms | {"gripper_left", "gripper_right", "lamp"}
    assert len(set(names)) == len(names)
    assert len(world.poses()) == 5
    assert all(world.state(name).dtype == np.float64 for name in names)


def test_a_device_unknown_or_taken_is_refused_with_a_sentence():
    world = claimed("arm_left")
    for name, sentence in (("arm_middle", "expected one of arm_left, "), ("arm_left", "claimed already")):
        with pytest.raises(ValueError, match=sentence):
            world.claim(name, 2)


def test_the_state_of_a_device_is_one_array_for_ever():
    world = BoxesWorld()
    state = world.state("arm_left")
    world.claim("arm_left", 1)
    world.claim("arm_right", 1)
    world.step(10 * MS)
    assert world.state("arm_left") is state
    assert state[0] == pytest.approx(0.010)


def test_an_arm_comes_between_two_steps_and_nothing_else_notices():  # law 18
    world, alone = BoxesWorld(), BoxesWorld()
    one, other = Operator(world), Operator(alone)
    for operator in (one, other):
        operator.signal = 1.0
        operator.reference[:] += 0.05
        for _ in range(100):
            operator.tick()
    bodies = world.poses()
    world.claim("gripper_right", 2)
    assert len(world.poses()) == len(bodies) + 10
    assert np.allclose(world.poses()[: len(bodies)], bodies, atol=2e-3)  # poses are those of the step before
    assert np.array_equal(world.state("arm_left"), alone.state("arm_left"))
    assert world.state("arm_left")[1] == Drive.DRIVEN
    for _ in range(100):
        one.tick()
        other.tick()
    assert np.allclose(world.state("arm_left"), alone.state("arm_left"), atol=1e-9)
    assert np.allclose(world.state("gripper_left"), alone.state("gripper_left"), atol=1e-9)
    assert np.allclose(world.state("arm_right")[2:], puma560.HOME, atol=1e-4)


def test_a_released_device_holds_and_is_free_again():
    world = claimed("arm_left")
    world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
    world.release("arm_left", 2)
    assert world.state("arm_left")[1] == Drive.DRIVEN
    world.release("arm_left", 1)
    assert world.state("arm_left")[1] == Drive.HELD
    world.step(400 * MS)
    assert world.state("arm_left")[1] == Drive.HELD
    world.claim("arm_left", 2)
    world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == Drive.HELD


def test_only_the_present_writer_keeps_a_device_driven():
    world = claimed("arm_left", epoch=2)
    world.command("arm_left", 2, Order.DRIVE, np.zeros(6))
    for _ in range(30):
        world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
        world.step(world.now_ns + 2 * MS)
    assert world.state("arm_left")[1] == Drive.HELD


def test_a_dead_writers_devices_trip_and_its_late_commands_are_ignored():  # law 17
    world = claimed("arm_left", "gripper_left")
    world.claim("arm_right", 2)
    for device, epoch in (("arm_left", 1), ("arm_right", 2)):
        world.command(device, epoch, Order.DRIVE, np.zeros(6))
    world.fence(1)
    states = [world.state(name)[1] for name in ("arm_left", "gripper_left", "arm_right")]
    assert states == [Drive.TRIPPED, Drive.TRIPPED, Drive.DRIVEN]
    world.command("arm_left", 1, Order.CLEAR, ())
    assert world.state("arm_left")[1] == Drive.TRIPPED
    with pytest.raises(ValueError, match="died"):
        world.claim("arm_left", 1)
    world.claim("arm_left", 3)
    world.command("arm_left", 3, Order.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == Drive.TRIPPED
    world.command("arm_left", 3, Order.CLEAR, ())
    world.command("arm_left", 3, Order.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == Drive.DRIVEN


# ---- another arm, another mode ----


def scara_at(world, q):
    """Drive the SCARA there with gravity and servo alone, for one second; gives where it stands."""
    law = Arm(adept_one.DH, adept_one.DYN, adept_one.LOAD)
    state = world.state("scara_left")
    derivative = Derivative(4, DT, 60.0)
    derivative.reset(state[2:])
    for _ in range(500):
        speed = derivative.update(state[2:])
        torque = law.bias(state[2:], speed) + adept_one.KP * (q - state[2:]) - adept_one.KD * speed
        world.command("scara_left", 1, Order.DRIVE, torque)
        world.step(world.now_ns + world.step_ns)
    return state[2:]


def test_a_scara_stands_where_it_is_claimed_with_the_same_hand():  # R-K03
    world = claimed("scara_left", "gripper_left")
    goal = np.add(adept_one.HOME, [0.1, -0.1, 0.05, 0.1])
    assert scara_at(world, goal) == pytest.approx(goal, abs=2e-3)
    world.command("gripper_left", 1, Order.DRIVE, [1.0])
    world.step(world.now_ns + 400 * MS)
    assert world.state("gripper_left")[2] > 0.11


def test_a_scara_holds_its_quill_when_nobody_commands_it():  # law 17
    world = claimed("scara_left")
    world.step(2000 * MS)
    assert world.state("scara_left")[2:] == pytest.approx(adept_one.HOME, abs=1e-3)


def test_the_arm_that_the_hand_brought_makes_room_for_the_one_that_is_claimed():  # R-K03
    world = claimed("gripper_left")
    before = len(world.poses())
    world.claim("scara_left", 1)
    assert len(world.poses()) == before - 2  # four links in place of six
    assert [shape.body for shape in world.scene()][-1] < before - 2


@pytest.mark.parametrize(
    ("inside", "asked", "sentence"),
    [
        ("arm_left", "scara_left", "expected a free place for 'scara_left', found 'arm_left' in use"),
        ("arm_left", "arm_left_kin", "expected a free place for 'arm_left_kin', found 'arm_left' in use"),
        ("arm_right", "arm_left_kin", "'arm_left_kin' is kinematic, found 'arm_right' in use, which is physical"),
        ("scara_left_kin", "arm_right", "'arm_right' is physical, found 'scara_left_kin' in use, which is kinematic"),
    ],
)
def test_two_arms_at_one_place_and_mixed_modes_are_refused(inside, asked, sentence):  # law 18
    world = claimed(inside)
    mark = world.fingerprint()
    with pytest.raises(ValueError, match=sentence):
        world.claim(asked, 2)
    assert world.fingerprint() == mark
    world.release(inside, 1)
    assert world.claim(asked, 2).name == asked


def test_the_world_goes_on_where_it_was_when_its_forces_are_taken_and_given_back():  # law 18
    world = BoxesWorld()
    operator = Operator(world)
    operator.turn(np.add(puma560.HOME, [0.3, 0.4, 0.3, 0.2, 0.5, 0.1]))
    there, boxes = operator.q.copy(), world.poses()[1:5]
    world.release("arm_left", 1)
    world.claim("arm_left_kin", 2)
    world.step(world.now_ns + 100 * MS)
    assert world.state("arm_left_kin")[2:] == pytest.approx(there, abs=1e-3)
    assert np.allclose(world.poses()[1:5], boxes, atol=1e-3)
    world.command("arm_left_kin", 2, Order.DRIVE, there + 0.05)
    world.step(world.now_ns + 40 * MS)
    world.release("arm_left_kin", 2)
    there = world.state("arm_left_kin")[2:].copy()
    world.claim("arm_left", 3)
    world.step(world.now_ns + 1000 * MS)
    assert world.state("arm_left")[2:] == pytest.approx(there, abs=2e-3)


def test_a_tripped_drive_stays_tripped_whatever_arm_is_plugged_in():  # law 17
    world = claimed("arm_left")
    world.fence(1)
    world.claim("scara_left_kin", 2)
    assert shown(world, "scara_left_kin") is Drive.TRIPPED
    world.command("scara_left_kin", 2, Order.CLEAR, ())
    assert shown(world, "scara_left_kin") is Drive.HELD


def test_the_panic_button_belongs_to_the_place():  # R-K06
    world = claimed("arm_left_kin")
    goal = puma560.HOME + 0.5
    world.command("arm_left_kin", 1, Order.DRIVE, goal)
    world.step(world.now_ns + 20 * MS)
    world.touch("panic_left", 1)
    at = world.state("arm_left_kin")[2:].copy()
    world.command("arm_left_kin", 1, Order.DRIVE, goal)
    world.step(world.now_ns + 100 * MS)
    assert shown(world, "arm_left_kin") is Drive.PRESSED
    assert np.array_equal(world.state("arm_left_kin")[2:], at)
    world.release("arm_left_kin", 1)
    world.claim("scara_left", 2)
    assert shown(world, "scara_left") is Drive.PRESSED


def test_reset_puts_a_world_without_forces_back_too():
    world, fresh = claimed("arm_left_kin"), claimed("arm_left_kin")
    world.command("arm_left_kin", 1, Order.DRIVE, puma560.HOME + 0.1)
    world.step(40 * MS)
    world.reset()
    assert np.array_equal(world.poses(), fresh.poses())


# ---- the drive in the world ----


def test_silence_holds_at_the_first_step_beyond_fifty_and_trips_beyond_two_hundred_and_fifty():  # law 17
    world = claimed("arm_left")
    world.step(100 * MS)
    world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
    world.step(600 * MS)
    last = 100 * MS
    assert world.take_events() == [
        DriveEvent("arm_left", Drive.DRIVEN, 100 * MS, 98 * MS, -1, "commanded to follow"),
        DriveEvent("arm_left", Drive.HELD, 152 * MS, 150 * MS, last, "no command for 50 ms"),
        DriveEvent("arm_left", Drive.TRIPPED, 352 * MS, 350 * MS, last, "no command for 250 ms"),
    ]
    assert world.take_events() == []


def test_commands_that_keep_coming_keep_it_driven():
    world = claimed("arm_left")
    for _ in range(20):
        world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
        world.step(world.now_ns + 50 * MS)
    assert [event.state for event in world.take_events()] == [Drive.DRIVEN]


def test_a_commanded_hold_does_not_trip_and_the_arm_stays_where_it_was():
    world = BoxesWorld()
    operator = Operator(world)
    operator.turn(np.add(puma560.HOME, [0.3, 0.4, 0.3, 0.2, 0.5, 0.1]))
    there = operator.q.copy()
    world.command("arm_left", 1, Order.HOLD, ())
    world.step(world.now_ns + 1000 * MS)
    assert world.state("arm_left")[1] == Drive.HELD
    assert np.allclose(operator.q, there, atol=2e-3)


@pytest.mark.parametrize("device", ["arm_left", "gripper_left"])
@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("driven", [True, False])
def test_a_command_that_is_not_finite_is_never_applied_and_trips(device, bad, driven):  # law 5
    world = claimed(device)
    count = 6 if device == "arm_left" else 1
    if driven:
        world.command(device, 1, Order.DRIVE, np.zeros(count))
    world.command(device, 1, Order.DRIVE, np.full(count, bad))
    assert world.state(device)[1] == Drive.TRIPPED
    world.step(100 * MS)
    assert np.isfinite(world.state(device)).all()
    assert np.allclose(world.state("arm_left")[2:], puma560.HOME, atol=2e-3)
    assert world.take_events()[-1].cause == "command is not finite"


def test_a_stop_is_latched_until_reset_or_until_it_goes_on():  # law 27
    world = claimed("arm_left", "gripper_left")
    world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
    world.stop()
    for order in (Order.CLEAR, Order.DRIVE):
        world.command("arm_left", 1, order, np.zeros(6))
        assert world.state("arm_left")[1] == Drive.HELD
    world.step(500 * MS)
    assert [event.cause for event in world.take_events()] == ["commanded to follow", "stop"]
    world.go_on()
    world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == Drive.DRIVEN


def test_reset_puts_everything_back_and_clears_latches_and_time_goes_on():
    world, fresh = BoxesWorld(5, 0.001), BoxesWorld(5, 0.001)
    operator = Operator(world)
    Operator(fresh)
    operator.grip(1.0)
    operator.turn(puma560.HOME + 0.2)
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
    return Drive(int(world.state(device)[1]))


def test_a_pressed_panic_button_holds_its_arm_where_it_is_and_no_other():  # R-K06
    world = BoxesWorld()
    left, right = Operator(world, "left", 1), Operator(world, "right", 2)
    target = left.reference + 0.3
    for k in range(150):
        value, rate = quintic(k * DT, 0.6)
        for one in (left, right):
            one.reference[:], one.speed[:] = puma560.HOME + value * 0.3, rate * np.full(6, 0.3)
        left.command()
        right.tick()
    world.touch("panic_left", 1)
    at = left.q.copy()
    for _ in range(250):
        left.command()
        right.tick()
    assert (shown(world), shown(world, "gripper_left"), shown(world, "arm_right")) == (
        Drive.PRESSED,
        Drive.DRIVEN,
        Drive.DRIVEN,
    )
    assert np.abs(left.q - at).max() < 0.05  # it brakes
    assert np.abs(left.q - target).max() > 0.1
    assert world.take_events()[-1].cause == "panic button pressed"


def test_a_pressed_panic_button_is_cleared_only_after_it_was_let_go():  # R-K06
    world = claimed("arm_left")
    world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
    world.touch("panic_left", 1.0)
    for order in (Order.CLEAR, Order.HOLD, Order.DRIVE):
        world.command("arm_left", 1, order, np.zeros(6))
        assert shown(world) is Drive.PRESSED
    world.touch("panic_left", 0.0)
    world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
    assert shown(world) is Drive.TRIPPED
    world.command("arm_left", 1, Order.CLEAR, ())
    world.command("arm_left", 1, Order.DRIVE, np.zeros(6))
    assert shown(world) is Drive.DRIVEN


@pytest.mark.parametrize("leave", [BoxesWorld.go_on, BoxesWorld.reset], ids=["go on", "reset"])
def test_a_button_stays_pressed_over_a_stop_and_over_its_end(leave):  # R-K06, law 27
    world = claimed("arm_left")
    world.stop()
    world.touch("panic_left", 1.0)
    assert shown(world) is Drive.HELD
    leave(world)
    assert shown(world) is Drive.PRESSED


def test_a_part_that_is_not_there_is_refused_with_those_that_are():
    world = BoxesWorld()
    assert list(world.parts()) == ["panic_left", "panic_right"]
    with pytest.raises(ValueError, match=r"panic_left: 1 pressed, 0 let go; panic_right: .*, found 'panic'"):
        world.touch("panic", 1.0)
    with pytest.raises(ValueError, match="found 2"):
        world.touch("panic_left", 2.0)
    assert not world.take_events()


def test_commands_of_the_wrong_shape_are_faults():
    world = claimed("arm_left", "gripper_left", "lamp")
    for device, order, values in (
        ("arm_left", Order.DRIVE, [0.0]),
        ("gripper_left", Order.DRIVE, [0.0, 0.0]),
        ("arm_left", 9, ()),
        ("lamp", Order.DRIVE, [1.0]),
        ("lamp", Order.HOLD, ()),
    ):
        with pytest.raises(ValueError, match=r"expected|9"):
            world.command(device, 1, order, values)
    assert not world.take_events()


def test_nobody_drives_what_nobody_claims():
    world = BoxesWorld()
    for epoch in (-1, 0, 1):
        world.command("arm_left", epoch, Order.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == Drive.HELD
    assert not world.take_events()
