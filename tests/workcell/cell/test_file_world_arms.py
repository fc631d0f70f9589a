"""A SCARA in place of a PUMA, and a world without forces."""

import numpy as np
import pytest

from kit.worlds.assembler import DT, Assembler
from kit.worlds.box_cells import boxes_world
from onika.laws import adept_one, puma560
from onika.laws.filter import Derivative
from onika.laws.textbook import serial_arm
from onika.ring.device import DeviceOrder, DriveState
from onika.workcell.composed import composition

MS = 1_000_000


def claimed(*names, epoch=1):
    world = boxes_world()
    for name in names:
        world.claim(name, epoch)
    return world


# ---- another arm, another mode ----


def scara_at(world, q):
    """Drive the SCARA there with gravity and servo alone, for one second; gives where it stands."""
    law = serial_arm(adept_one.DH, adept_one.DYN, adept_one.LOAD)
    state = world.state("scara_left")
    derivative = Derivative(4, DT, 60.0)
    derivative.reset(state[2:])
    for _ in range(500):
        speed = derivative.update(state[2:])
        torque = law.bias(state[2:], speed) + adept_one.KP * (q - state[2:]) - adept_one.KD * speed
        world.command("scara_left", 1, DeviceOrder.DRIVE, torque)
        world.step(world.now_ns + world.step_ns)
    return state[2:]


def test_a_scara_stands_where_it_is_claimed_with_the_same_hand():  # R-K03
    world = claimed("scara_left", "gripper_left")
    goal = np.add(adept_one.HOME, [0.1, -0.1, 0.05, 0.1])
    assert scara_at(world, goal) == pytest.approx(goal, abs=2e-3)
    world.command("gripper_left", 1, DeviceOrder.DRIVE, [1.0])
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


def test_what_there_is_to_draw_is_worked_out_once_for_the_arms_that_stand_there(monkeypatch):  # R-X19, law 16
    world, compiled = claimed("arm_left"), []
    note_what_is_compiled(world, compiled, monkeypatch)
    assert world.scene() == world.scene()
    world.release("arm_left", 1)
    arms = world.scene()
    world.claim("scara_left", 1)
    assert world.scene() == world.scene() != arms
    assert compiled == [{"is_drawn": True}, {"is_drawn": False}, {"is_drawn": True}]


def note_what_is_compiled(world, compiled, monkeypatch):
    former = world._composition._compiled_world
    world._composition._models.clear()
    monkeypatch.setattr(composition, "_LARGEST_KEPT", 0)  # as models with large meshes
    monkeypatch.setattr(
        world._composition, "_compiled_world", lambda *words, **more: compiled.append(more) or former(*words, **more)
    )


def test_what_another_arm_takes_is_worked_out_beside_and_then_it_stands_there_at_once(monkeypatch):  # R-X19, law 16
    world, compiled = claimed("arm_left"), []
    note_what_is_compiled(world, compiled, monkeypatch)
    assert world.preparation("arm_left") is None and world.preparation("lamp") is None
    preparation = world.preparation("scara_left")
    before = world.fingerprint(), world.poses().tobytes()
    preparation.take(world.preparation("scara_left").work_out())
    assert (world.fingerprint(), world.poses().tobytes()) == before
    assert len(compiled) == 2
    world.release("arm_left", 1)
    world.claim("scara_left", 1)
    assert world.scene() and world.preparation("scara_left") is None
    assert world.snapshot() and len(compiled) == 2


@pytest.mark.parametrize(
    ("inside", "wanted", "sentence"),
    [
        ("arm_left", "scara_left", "expected a free place for 'scara_left', found 'arm_left' in use"),
        ("arm_left", "arm_left_kin", "'arm_left_kin' is kinematic, found 'arm_left' in use, which is physical"),
        ("arm_right", "arm_left_kin", "'arm_left_kin' is kinematic, found 'arm_right' in use, which is physical"),
        ("scara_left_kin", "arm_right", "'arm_right' is physical, found 'scara_left_kin' in use, which is kinematic"),
    ],
)
def test_two_arms_at_one_place_and_mixed_modes_are_refused(inside, wanted, sentence):  # law 18
    world = claimed(inside)
    mark = world.fingerprint()
    with pytest.raises(ValueError, match=sentence):
        world.claim(wanted, 2)
    assert world.fingerprint() == mark
    world.release(inside, 1)
    assert world.claim(wanted, 2).name == wanted


def test_the_world_goes_on_where_it_was_when_its_forces_are_taken_and_given_back():  # law 18
    world = boxes_world()
    assembler = Assembler(world)
    assembler.turn(np.add(puma560.HOME, [0.3, 0.4, 0.3, 0.2, 0.5, 0.1]))
    there, boxes = assembler.q.copy(), world.poses()[1:5]
    world.release("arm_left", 1)
    world.claim("arm_left_kin", 2)
    world.step(world.now_ns + 100 * MS)
    assert world.state("arm_left_kin")[2:] == pytest.approx(there, abs=1e-3)
    assert np.allclose(world.poses()[1:5], boxes, atol=1e-3)
    world.command("arm_left_kin", 2, DeviceOrder.DRIVE, there + 0.05)
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
    assert shown(world, "scara_left_kin") is DriveState.TRIPPED
    world.command("scara_left_kin", 2, DeviceOrder.CLEAR, ())
    assert shown(world, "scara_left_kin") is DriveState.HELD


def test_the_panic_button_belongs_to_the_place():  # R-K06
    world = claimed("arm_left_kin")
    goal = puma560.HOME + 0.5
    world.command("arm_left_kin", 1, DeviceOrder.DRIVE, goal)
    world.step(world.now_ns + 20 * MS)
    world.touch("panic_left", 1)
    at = world.state("arm_left_kin")[2:].copy()
    world.command("arm_left_kin", 1, DeviceOrder.DRIVE, goal)
    world.step(world.now_ns + 100 * MS)
    assert shown(world, "arm_left_kin") is DriveState.PRESSED
    assert np.array_equal(world.state("arm_left_kin")[2:], at)
    world.release("arm_left_kin", 1)
    world.claim("scara_left", 2)
    assert shown(world, "scara_left") is DriveState.PRESSED


def test_reset_puts_a_world_without_forces_back_too():
    world, fresh = claimed("arm_left_kin"), claimed("arm_left_kin")
    world.command("arm_left_kin", 1, DeviceOrder.DRIVE, puma560.HOME + 0.1)
    world.step(40 * MS)
    world.reset()
    assert np.array_equal(world.poses(), fresh.poses())


# ---- the panic button ----


def shown(world, device="arm_left"):
    return DriveState(int(world.state(device)[1]))
