import mujoco
import numpy as np
import pytest

from onika.workcell.contacts import Contact, Contacts, Thing
from onika.workcell.layout import boxes, text
from onika.workcell.plant import Plant
from onika.workcell.watched_hand import LET_GO_NS, WatchedHand

BOX = Thing("box", "square")
S = 1_000_000_000


class Hand:
    """A hand in a plant, whose valves and arm are put as a test wants."""

    def __init__(self, is_open=True):
        self.plant = Plant(text(boxes(0, 0.0), ("left",), drawn=False))
        self.signal(1.0 if is_open else -1.0)
        self.contacts = Contacts(self.plant)
        mujoco.mj_forward(self.plant.model, self.plant.data)
        self.watched = WatchedHand(self.plant, self.contacts, "left", 0)
        self.finger = next(iter(self.contacts.fingers("left")))

    def signal(self, value):
        self.plant.data.ctrl[self.plant.signals(["gripper_left.valve1", "gripper_left.valve2"])] = value
        return self

    def turn(self, joint, by):
        self.plant.data.joint(f"arm_left.joint{joint}").qpos[0] += by
        mujoco.mj_forward(self.plant.model, self.plant.data)

    def means(self, now_ns):
        return self.watched.means(Contact(self.watched.thing, BOX, (self.finger, 0), 0), now_ns)


def test_a_box_that_it_has_is_meant_and_a_moment_longer():  # R-E16
    hand = Hand(is_open=False)
    hand.watched.look([BOX], S)
    assert list(hand.watched.held) == [BOX]
    assert hand.means(S)
    hand.signal(1.0)
    hand.watched.look([], 2 * S)
    assert hand.watched.held == {}
    assert hand.means(2 * S + LET_GO_NS - 1)
    assert not hand.means(2 * S + LET_GO_NS)


def test_a_box_that_slips_is_lost_once():  # R-E16
    hand = Hand(is_open=False).watched
    hand.look([BOX], 0)
    hand.look([], S // 20)
    assert hand.lost == []
    hand.look([], S)
    assert hand.lost == [BOX]
    hand.look([], 2 * S)
    assert hand.lost == []


def test_a_box_that_falls_when_the_hand_opens_is_dropped_once():  # R-E16
    hand = Hand(is_open=False)
    hand.watched.look([BOX], 0)
    hand.signal(1.0).watched.look([], S)
    assert hand.watched.dropped() == []
    hand.plant.data.joint("box_square").qpos[2] -= 0.02
    mujoco.mj_forward(hand.plant.model, hand.plant.data)
    assert hand.watched.dropped() == [BOX]
    assert hand.watched.dropped() == []


@pytest.mark.parametrize("has_come", [True, False])
def test_it_is_found_empty_where_it_has_come_to_take_something(has_come):  # R-E16
    hand = Hand()
    if has_come:
        hand.turn(1, 0.5)
    hand.signal(-1.0).watched.look([], S)
    assert hand.watched.is_found_empty() is has_come
    assert not hand.watched.is_found_empty()
    assert np.allclose(hand.plant.data.joint("gripper_left.finger1").qpos, 0.0)
