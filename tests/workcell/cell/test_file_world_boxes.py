"""The box assembly as it is shipped: its arms are those of the laws, its circuit closes by touch."""

import mujoco
import numpy as np
import pytest

from kit.worlds.assembler import pose_at
from kit.worlds.box_cells import LAYOUT_M, SIZE_M, TOP_M, base_of, boxes_world
from onika.laws import adept_one, puma560
from onika.laws.inverse import serial_inverse
from onika.laws.textbook import serial_arm
from onika.ring.device import DeviceOrder

NEAR = np.array((0.0, -0.7, 2.9, 0.0, 1.0, 1.36))
STACK = tuple(LAYOUT_M)
every_kind = pytest.mark.parametrize(("kind", "robot"), [("arm", puma560), ("scara", adept_one)])


def claimed(*devices):
    world = boxes_world()
    for device in devices:
        world.claim(device, 1)
    return world


def plant_of(kind, robot, side="left"):
    """The plant with an arm of this kind, and where its joints stand in qpos and qvel."""
    plant = claimed(f"{kind}_{side}", f"gripper_{side}")._plant
    return plant, *plant.joints([f"{side}.joint{k}" for k in range(1, robot.NDOF + 1)])


def test_nothing_is_at_fault_and_all_is_called_as_people_call_it():  # R-X19
    world = claimed("arm_left")
    assert world.faults == ()
    assert list(world.parts()) == ["panic_left", "panic_right"]
    assert [str(sentence) for sentence in world.standing()] == ["the lamp is dark"]


# ---- arms and hands ----


@every_kind
def test_an_arm_stands_where_the_laws_say(kind, robot):  # R-K01, R-K03
    plant, where, _ = plant_of(kind, robot, "right")
    base = base_of("right")
    assert base == pytest.approx(np.array([[-1, 0, 0, 1.25], [0, -1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), abs=1e-12)
    law, random = serial_arm(robot.DH, base=base, tool=robot.TOOL), np.random.default_rng(1)
    hand = plant.body("right.hand.hand")
    for _ in range(20):
        q = plant.data.qpos[where] = random.uniform(robot.QMIN, robot.QMAX)
        mujoco.mj_kinematics(plant.model, plant.data)
        tip = plant.data.xpos[hand] + plant.data.xmat[hand].reshape(3, 3) @ robot.TOOL[:3, 3]
        assert np.allclose(tip, law.forward(q)[:3, 3], atol=1e-12)


@every_kind
def test_gravity_model_and_world_agree_but_for_the_hands_own_inertia(kind, robot):  # R-K01, R-K03
    plant, where, rate = plant_of(kind, robot)
    law = serial_arm(robot.DH, robot.DYN, robot.LOAD)
    q = plant.data.qpos[where] = 0.7 * robot.QMIN + 0.3 * robot.QMAX
    plant.settle()
    assert np.allclose(plant.data.qfrc_bias[rate], law.bias(q, np.zeros(robot.NDOF)), atol=1e-9)


@every_kind
def test_motors_limits_and_friction_are_those_of_the_table(kind, robot):
    plant, _, rate = plant_of(kind, robot)
    model, names = plant.model, [f"left.joint{k}" for k in range(1, robot.NDOF + 1)]
    motors = plant.signals([f"left.motor{k}" for k in range(1, robot.NDOF + 1)])
    assert np.allclose(model.actuator_forcerange[motors, 1], robot.TAUMAX)
    ranges = [model.joint(name).range for name in names]
    assert np.allclose(ranges, np.transpose((robot.QMIN, robot.QMAX)))
    assert np.allclose(model.dof_armature[rate], robot.DYN[:, 7])
    assert np.allclose(model.dof_damping[rate], robot.DYN[:, 8])


def test_the_hand_weighs_what_the_arm_reckons_with():  # R-K01
    plant = claimed("gripper_left")._plant
    hand = plant.body("left.hand.hand")
    assert plant.model.body_subtreemass[hand] == pytest.approx(puma560.LOAD[0])
    mujoco.mj_comPos(plant.model, plant.data)
    turn = plant.data.xmat[hand].reshape(3, 3)
    middle = turn.T @ (plant.data.subtree_com[hand] - plant.data.xpos[hand])
    assert middle == pytest.approx(puma560.LOAD[1:], abs=1e-12)


@pytest.mark.parametrize("side", ["left", "right"])
def test_both_arms_reach_every_box_and_every_place_in_the_stack_and_above(side):  # R-K02
    base = base_of(side)
    inverse = serial_inverse(puma560.DH, base, puma560.TOOL, puma560.QMIN, puma560.QMAX)
    centres = [TOP_M + SIZE_M * (level + 0.5) for level in range(4)]
    places = [(*place, z) for place in LAYOUT_M.values() for z in (centres[0], -0.125)]
    places += [(*LAYOUT_M["waves"], z + 0.0008) for z in centres]
    for place in places:
        q = inverse.nearest(pose_at(*place), puma560.HOME)
        assert not isinstance(q, str), f"{place}: {q}"


def test_arms_at_home_touch_neither_each_other_nor_anything_else():  # R-K02
    for left, right in (("arm_left", "arm_right"), ("scara_left", "arm_right")):
        plant = claimed(left, right, "gripper_left", "gripper_right")._plant
        plant.settle()
        boxes = {plant.body(f"box_{sign}.box") for sign in STACK}
        for pair in plant.data.contact.geom.tolist():
            assert boxes & {int(plant.model.geom_bodyid[shape]) for shape in pair}


def test_shaken_boxes_stand_within_a_millimetre_of_their_places():  # R-X07
    for seed in range(1, 6):
        places = boxes_world(seed).poses()[1:5, :2]
        ways = np.abs(places - np.array([*LAYOUT_M.values()])).max(axis=1)
        assert 0.0 < ways.max() <= 0.001 + 1e-6
        assert np.array_equal(places, boxes_world(seed).poses()[1:5, :2])


# ---- the circuit ----


def pile(world, order=STACK, shift=0.0, half_turn=None, lifted=0.0):
    """Put the boxes on each other; those above the second are shifted. The six contacts, 0.2 s later."""
    for level, sign in enumerate(order):
        qpos = world._plant.data.joint(f"box_{sign}.free").qpos
        qpos[:3] = 0.7 + (shift if level > 1 else 0.0), 0.0, TOP_M + SIZE_M * (level + 0.5) + lifted * level
        if sign == half_turn:
            qpos[3:] = 0.0, 0.0, 0.0, 1.0
    world.step(world.now_ns + (20_000_000 if lifted else 200_000_000))
    return world.state("lamp")[2:].tolist()


def test_the_right_pile_closes_all_six_and_lights_the_lamp():  # R-K01
    world = boxes_world()
    assert pile(world) == [1.0] * 6
    assert world.lit


@pytest.mark.parametrize("order", [("waves", "square", "triangle", "cross"), ("triangle", "waves", "square", "cross")])
def test_a_wrong_order_leaves_contacts_open(order):  # R-K01
    world = boxes_world()
    assert 0.0 in pile(world, order)
    assert not world.lit


def test_boxes_that_do_not_touch_close_nothing():  # R-K01
    assert pile(boxes_world(), lifted=0.005) == [0.0] * 6


@pytest.mark.parametrize(("shift", "closed"), [(0.004, 1.0), (0.009, 0.0)])
def test_a_foot_must_stand_within_six_millimetres_of_its_patch(shift, closed):  # R-K01
    assert pile(boxes_world(), shift=shift) == [1.0, 1.0, closed, closed, 1.0, 1.0]


def test_a_box_turned_half_round_has_its_poles_exchanged():  # R-K01
    assert pile(boxes_world(), half_turn="square") == [1.0, 1.0, 0.0, 0.0, 0.0, 0.0]


# ---- without forces ----


class ForcelessHand:
    """The left arm and its hand without forces, moved from place to place."""

    def __init__(self):
        self.world = claimed("arm_left_kin", "gripper_left")
        self.signal = -1.0
        self._inverse = serial_inverse(puma560.DH, np.eye(4), puma560.TOOL, puma560.QMIN, puma560.QMAX)

    def go(self, x, y, z, signal=None):
        posture = self._inverse.nearest(pose_at(x, y, z), NEAR)
        self._run(posture, 700)
        self.signal = self.signal if signal is None else signal
        self._run(posture, 200)

    def _run(self, posture, steps):
        for _ in range(steps):
            self.world.command("arm_left_kin", 1, DeviceOrder.DRIVE, posture)
            self.world.command("gripper_left", 1, DeviceOrder.DRIVE, [self.signal])
            self.world.step(self.world.now_ns + self.world.step_ns)


def test_boxes_piled_by_a_hand_without_forces_light_the_lamp():  # R-K03, law 18
    hand = ForcelessHand()
    hand.go(0.5, 0.3, 0.0, 1.0)
    for level, sign in enumerate(STACK[1:], 1):
        hand.go(*LAYOUT_M[sign], TOP_M + SIZE_M / 2, -1.0)
        x, y = LAYOUT_M["waves"]
        hand.go(x, y, 0.0)
        hand.go(x, y, TOP_M + SIZE_M * (level + 0.5) + 0.0008)
        assert hand.world.state("lamp")[2:].tolist() == [1.0] * 2 * (level - 1) + [0.0] * (8 - 2 * level)
        hand.go(x, y, TOP_M + SIZE_M * (level + 0.5) + 0.0008, 1.0)
    assert hand.world.state("lamp")[2:].tolist() == [1.0] * 6


def test_what_a_hand_without_forces_lets_go_comes_to_lie_on_the_table():  # R-K03, law 18
    hand = ForcelessHand()
    hand.go(*LAYOUT_M["triangle"], -0.125, 1.0)
    hand.go(*LAYOUT_M["triangle"], TOP_M + SIZE_M / 2, -1.0)
    hand.go(0.60, 0.10, -0.125)
    assert hand.world.poses()[2, :3] == pytest.approx((0.60, 0.10, -0.125), abs=1e-3)
    hand.go(0.60, 0.10, -0.125, 1.0)
    assert hand.world.poses()[2, :3] == pytest.approx((0.60, 0.10, TOP_M + SIZE_M / 2), abs=1e-3)
