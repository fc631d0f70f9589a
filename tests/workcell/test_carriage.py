import numpy as np
import pytest

from onika.workcell.carriage import APART_M, DRAGGED_M, PUSHED_M, Carriage

MS = 1_000_000


def carriage(*, is_lifted=False, other=None):
    return Carriage(0, b"", (), np.zeros(3), other, is_lifted, 0)


def at(x):
    return np.array([x, 0.0, 0.0])


def test_what_is_brushed_and_left_behind_was_not_meant():  # R-E16
    brush = carriage()
    assert not brush.look(at(APART_M / 2), None, 200 * MS, touches=False)
    assert not brush.look(at(APART_M * 2), None, 50 * MS, touches=False)
    assert brush.look(at(APART_M * 2), None, 200 * MS, touches=False)
    assert brush.is_over


def test_what_a_box_is_lifted_from_is_left_behind_on_purpose():  # R-E16
    lift = carriage(is_lifted=True)
    assert not lift.look(at(APART_M * 2), None, 200 * MS, touches=False)
    assert lift.is_over


@pytest.mark.parametrize("is_lifted", [True, False])
def test_who_goes_on_touching_drags_and_that_is_told_once(is_lifted):  # R-E16
    drag = carriage(is_lifted=is_lifted)
    assert not drag.look(at(DRAGGED_M * 0.9), None, MS, touches=True)
    assert drag.look(at(DRAGGED_M * 1.1), None, 2 * MS, touches=True)
    assert not drag.look(at(DRAGGED_M * 1.2), None, 3 * MS, touches=True)


def test_a_box_that_gives_way_is_pushed():  # R-E16
    push = carriage(other=np.zeros(3))
    assert not push.look(at(0.0), at(PUSHED_M * 0.9), MS, touches=True)
    assert push.look(at(0.0), at(PUSHED_M * 1.1), 2 * MS, touches=True)
