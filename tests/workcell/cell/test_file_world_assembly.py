"""The assembly itself; that equal runs are equal; who claims a device."""

import numpy as np
import pytest

from kit.worlds.assembler import DT, GRASP_M, Assembler
from kit.worlds.box_cells import boxes_world
from onika.laws import puma560
from onika.laws.path import quintic
from onika.ring.device import DeviceOrder, DriveState

MS = 1_000_000


def lit(world):
    return world.state("lamp")[2:].all()


def claimed(*names, epoch=1):
    world = boxes_world()
    for name in names:
        world.claim(name, epoch)
    return world


# ---- the assembly ----


@pytest.mark.parametrize(("seed", "side"), [pytest.param(1, "left", marks=pytest.mark.slow), (2, "right")])
def test_twenty_four_actions_light_the_lamp(seed, side):  # R-K01, R-K02
    world = boxes_world(seed)
    assembler = Assembler(world, side)
    assert len(assembler.actions()) == 24
    assembler.assemble()
    assert lit(world)
    assert world.lit == ("box_cross.lamp",)
    assert assembler.worst < 0.01
    assert [event.state for event in world.take_events()] == [DriveState.DRIVEN, DriveState.DRIVEN]


def test_a_forgotten_close_leaves_it_dark():  # R-K01
    world = boxes_world(1)
    assembler = Assembler(world)
    assembler.assemble(left_out=(11,))
    assert not lit(world)
    assert world.lit == ()
    assert world.state("lamp")[2:].tolist() != [1.0] * 6


def test_a_grasped_box_is_held_by_friction_and_felt_by_the_pads():
    world = boxes_world()
    assembler = Assembler(world)
    assembler.assemble(left_out=range(5, 24))
    hand = world.state("gripper_left")
    assert hand[2] == pytest.approx(0.0762, abs=1e-3)
    assert hand[4] == pytest.approx(60.0, rel=0.1)
    assert world.poses()[2, 2] > GRASP_M + 0.15


def test_two_arms_work_in_one_world_and_one_holds_while_the_other_moves():  # R-K02
    world = boxes_world()
    left, right = Assembler(world, "left", 1), Assembler(world, "right", 2)
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
        world = boxes_world(3)
        assembler = Assembler(world)
        assembler.grip(1.0)
        world.claim("arm_right", 2)
        assembler.turn(puma560.HOME + 0.1)
        marks.append(world.fingerprint())
    assert marks[0] == marks[1]
    assert boxes_world(4).fingerprint() != boxes_world(3).fingerprint()


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
    world = boxes_world()
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
    world = boxes_world()
    state = world.state("arm_left")
    world.claim("arm_left", 1)
    world.claim("arm_right", 1)
    world.step(10 * MS)
    assert world.state("arm_left") is state
    assert state[0] == pytest.approx(0.010)


def test_an_arm_comes_between_two_steps_and_nothing_else_notices():  # law 18
    world, alone = boxes_world(), boxes_world()
    first, other = Assembler(world), Assembler(alone)
    for assembler in (first, other):
        assembler.signal = 1.0
        assembler.reference[:] += 0.05
        for _ in range(100):
            assembler.tick()
    bodies = world.poses()
    world.claim("gripper_right", 2)
    assert len(world.poses()) == len(bodies) + 10
    assert np.allclose(world.poses()[: len(bodies)], bodies, atol=2e-3)  # poses are those of the step before
    assert np.array_equal(world.state("arm_left"), alone.state("arm_left"))
    assert world.state("arm_left")[1] == DriveState.DRIVEN
    for _ in range(100):
        first.tick()
        other.tick()
    assert np.allclose(world.state("arm_left"), alone.state("arm_left"), atol=1e-9)
    assert np.allclose(world.state("gripper_left"), alone.state("gripper_left"), atol=1e-9)
    assert np.allclose(world.state("arm_right")[2:], puma560.HOME, atol=1e-4)


def test_a_released_device_holds_and_is_free_again():
    world = claimed("arm_left")
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    world.release("arm_left", 2)
    assert world.state("arm_left")[1] == DriveState.DRIVEN
    world.release("arm_left", 1)
    assert world.state("arm_left")[1] == DriveState.HELD
    world.step(400 * MS)
    assert world.state("arm_left")[1] == DriveState.HELD
    world.claim("arm_left", 2)
    world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == DriveState.HELD


def test_only_the_present_writer_keeps_a_device_driven():
    world = claimed("arm_left", epoch=2)
    world.command("arm_left", 2, DeviceOrder.DRIVE, np.zeros(6))
    for _ in range(30):
        world.command("arm_left", 1, DeviceOrder.DRIVE, np.zeros(6))
        world.step(world.now_ns + 2 * MS)
    assert world.state("arm_left")[1] == DriveState.HELD


def test_a_dead_writers_devices_trip_and_its_late_commands_are_ignored():  # law 17
    world = claimed("arm_left", "gripper_left")
    world.claim("arm_right", 2)
    for device, epoch in (("arm_left", 1), ("arm_right", 2)):
        world.command(device, epoch, DeviceOrder.DRIVE, np.zeros(6))
    world.fence(1)
    states = [world.state(name)[1] for name in ("arm_left", "gripper_left", "arm_right")]
    assert states == [DriveState.TRIPPED, DriveState.TRIPPED, DriveState.DRIVEN]
    world.command("arm_left", 1, DeviceOrder.CLEAR, ())
    assert world.state("arm_left")[1] == DriveState.TRIPPED
    with pytest.raises(ValueError, match="died"):
        world.claim("arm_left", 1)
    world.claim("arm_left", 3)
    world.command("arm_left", 3, DeviceOrder.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == DriveState.TRIPPED
    world.command("arm_left", 3, DeviceOrder.CLEAR, ())
    world.command("arm_left", 3, DeviceOrder.DRIVE, np.zeros(6))
    assert world.state("arm_left")[1] == DriveState.DRIVEN
