import mujoco
import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.frames import pose_of_nine, rotation_about
from onika.laws.inverse import serial_inverse
from onika.workcell.box import SIZE_M
from onika.workcell.grasp import Grasp
from onika.workcell.gripper import CLOSED_M, FORCE_N, TRAVEL_M
from onika.workcell.layout import LAYOUT_M, boxes, text
from onika.workcell.pile import Pile
from onika.workcell.plant import Plant
from onika.workcell.table import TOP_M

TRIANGLE = 1
AT_TRIANGLE = (*LAYOUT_M["triangle"], TOP_M + SIZE_M[2] / 2)


class Hand:
    """A hand of a PUMA that is put anywhere at once, and the boxes before it."""

    def __init__(self):
        self.plant = Plant(text(boxes(0, 0.0), ("left",), drawn=False))
        self.pile = Pile(self.plant)
        self.grasp = Grasp(self.plant, "gripper_left", self.pile)
        self.arm = self.plant.data.qpos[self.plant.joints([f"arm_left.joint{k}" for k in range(1, 7)])[0]]
        self.fingers = self.plant.data.qpos[self.plant.joints([f"gripper_left.finger{k}" for k in (1, 2)])[0]]
        self.inverse = serial_inverse(puma560.DH, None, puma560.TOOL, puma560.QMIN, puma560.QMAX)
        self.fingers[:] = TRAVEL_M

    def at(self, x, y, z, turn=0.0):
        pose = pose_of_nine([0.0, 0.0, -1.0, 0.0, 1.0, 0.0, x, y, z])
        pose[:3, :3] = rotation_about(0.0, 0.0, 1.0, turn) @ pose[:3, :3]
        self.arm[:] = self.inverse.nearest(pose, [0.0, -0.7, 2.9, 0.0, 1.0, 1.4])
        self.tick()
        return self

    def grip(self, signal, ticks=200):
        self.plant.data.ctrl[self.plant.signals([f"gripper_left.valve{k}" for k in (1, 2)])] = signal
        for _ in range(ticks):
            self.tick()
        return self

    def tick(self):
        mujoco.mj_kinematics(self.plant.model, self.plant.data)
        self.grasp.move()
        self.grasp.carry()
        self.grasp.feel()

    @property
    def box(self):
        return self.pile.pose(TRIANGLE)[:3, 3]

    @property
    def force(self):
        return self.plant.data.sensordata[self.plant.sensors([f"gripper_left.touch{k}" for k in (1, 2)])].tolist()


def test_a_box_between_the_jaws_is_taken_carried_and_let_go():  # R-K03, law 18
    hand = Hand().grip(1.0).at(*AT_TRIANGLE).grip(-1.0)
    assert hand.grasp.carried.keys() == {TRIANGLE}
    assert CLOSED_M + hand.fingers.sum() == pytest.approx(SIZE_M[0])
    assert hand.force == [FORCE_N] * 2
    hand.at(0.5, 0.3, -0.1)
    assert hand.box == pytest.approx([0.5, 0.3, -0.1], abs=1e-9)
    hand.grip(1.0)
    assert hand.box == pytest.approx([0.5, 0.3, AT_TRIANGLE[2]], abs=1e-9)
    assert hand.grasp.carried == {}
    assert hand.fingers.tolist() == [TRAVEL_M] * 2
    assert hand.force == [0.0] * 2


def test_what_stands_on_a_box_comes_with_it():
    hand = Hand().grip(1.0)
    above = np.eye(4)
    above[:3, 3] = AT_TRIANGLE
    above[2, 3] += SIZE_M[2]
    hand.pile.put(3, above)
    hand.at(*AT_TRIANGLE).grip(-1.0).at(0.6, 0.1, 0.0)
    assert hand.pile.pose(3)[:3, 3] == pytest.approx([0.6, 0.1, SIZE_M[2]], abs=1e-9)


def test_it_is_squared_and_centred_as_real_jaws_do():
    hand = Hand().grip(1.0)
    x, y, z = AT_TRIANGLE
    hand.at(x + 0.008, y, z, turn=0.1).grip(-1.0)
    relative = hand.grasp.carried[TRIANGLE]
    assert relative[:3, :3] == pytest.approx(np.rint(relative[:3, :3]), abs=1e-12)
    assert relative[1, 3] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    ("dx", "dy", "dz", "turn"), [(0.02, 0, 0, 0), (0, 0.06, 0, 0), (0, 0, 0.03, 0), (0, 0, 0, 0.5), (0, 0, 0, 1.57)]
)
def test_a_box_beside_the_jaws_or_turned_against_them_is_not_taken(dx, dy, dz, turn):
    x, y, z = AT_TRIANGLE
    hand = Hand().grip(1.0).at(x + dx, y + dy, z + dz, turn).grip(-1.0)
    assert hand.grasp.carried == {}
    assert hand.box == pytest.approx(AT_TRIANGLE)
    assert hand.fingers.tolist() == [0.0] * 2
    assert hand.force == [0.0] * 2


def test_a_hand_that_comes_closed_takes_nothing():
    hand = Hand().grip(-1.0).at(*AT_TRIANGLE).grip(-1.0)
    assert hand.grasp.carried == {}


def test_a_hand_that_is_found_closed_on_a_box_has_it():
    hand = Hand().grip(1.0).at(*AT_TRIANGLE).grip(-1.0)
    other = Grasp(hand.plant, "gripper_left", Pile(hand.plant))
    other.take_up()
    assert other.carried.keys() == {TRIANGLE}


def test_a_box_in_another_hand_stays_there():
    hand = Hand().grip(1.0).at(*AT_TRIANGLE)
    hand.pile.held.add(TRIANGLE)
    assert hand.grip(-1.0).grasp.carried == {}


def test_fingers_take_a_tenth_of_a_second_and_say_their_speed():
    hand = Hand().grip(-1.0, ticks=10)
    assert hand.fingers[0] == pytest.approx(TRAVEL_M - 0.004)
    speed = hand.plant.data.qvel[hand.plant.joints([f"gripper_left.finger{k}" for k in (1, 2)])[1]]
    assert speed == pytest.approx([-0.2, -0.2])
    hand.grip(-1.0)
    assert speed.tolist() == [0.0, 0.0]
