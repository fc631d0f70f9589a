"""A world from files without forces: only what is told to moves, and hands know what they carry."""

import numpy as np

from kit.worlds.grasping_cells import AT_CUBE, Cell


def test_nothing_moves_but_what_is_told_to():  # law 18
    cell = Cell()
    before = [cell.place(part) for part in ("cube", "other", "post", "plate")]
    cell.go(0.3, 0.1, 0.05)
    assert [cell.place(part) for part in ("cube", "other", "post", "plate")] == before
    assert np.count_nonzero(cell.world._plant.data.qvel) == 0


def test_hands_know_what_they_carry():  # law 18, R-X19
    cell = Cell()
    cell.grip(0.06)
    cell.go(*AT_CUBE)
    forceless = cell.world._forceless
    (hand,) = forceless.hands
    assert forceless.carried(hand.unit) == ()
    cell.grip(0.0)
    assert forceless.carried(hand.unit) == ("cube",)
