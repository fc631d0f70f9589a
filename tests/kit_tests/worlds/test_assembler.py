import numpy as np
import pytest

from kit.worlds.assembler import Assembler
from kit.worlds.box_cells import LAYOUT_M, boxes_world


@pytest.fixture
def assembler():
    return Assembler(boxes_world())


def test_an_arm_is_turned_above_a_place(assembler):
    assembler.turn(assembler.above("cross"))
    assert np.abs(assembler.q - assembler.above("cross")).max() < 0.01
    assert assembler.worst < 0.02


def test_a_hand_opens_and_closes(assembler):
    hand = assembler.world.state(assembler.hand)
    assembler.grip(1.0)
    wide = hand[2]
    assembler.grip(-1.0)
    assert hand[2] < wide


def test_what_is_left_out_is_not_done(assembler):
    assembler.assemble(left_out=range(24))
    assert assembler.world.now_ns == 0


def test_a_place_out_of_reach_is_said(assembler, monkeypatch):
    monkeypatch.setitem(LAYOUT_M, "cross", (9.0, 9.0))
    with pytest.raises(ValueError, match="expected a pose within reach"):
        assembler.above("cross")
