import mujoco
import numpy as np
import pytest

from onika.workcell.box import SIGNS, SIZE_M
from onika.workcell.circuit import Circuit
from onika.workcell.layout import boxes, text
from onika.workcell.plant import Plant
from onika.workcell.table import TOP_M


def _contacts(order=SIGNS, shifts=((0.0, 0.0),) * 4, half_turn=None, lifted=0.0):
    """Pile the boxes by hand, let them settle for 0.2 s and read the six contacts."""
    plant = Plant(text(boxes(0, 0.0), (), drawn=False))
    for level, (sign, (dx, dy)) in enumerate(zip(order, shifts, strict=True)):
        qpos = plant.data.joint(f"box_{sign}").qpos
        qpos[:3] = 0.7 + dx, dy, TOP_M + SIZE_M[2] * (level + 0.5) + lifted * level
        if sign == half_turn:
            qpos[3:] = 0.0, 0.0, 0.0, 1.0
    if not lifted:
        mujoco.mj_step(plant.model, plant.data, 100)
    mujoco.mj_forward(plant.model, plant.data)
    plant.sense()
    flags = np.full(6, 9.0)
    Circuit(plant).scan(flags)
    return flags.tolist()


def test_the_right_pile_closes_all_six():  # R-K01
    assert _contacts() == [1.0] * 6


@pytest.mark.parametrize("order", [("waves", "square", "triangle", "cross"), ("triangle", "waves", "square", "cross")])
def test_a_wrong_order_leaves_contacts_open(order):
    assert 0.0 in _contacts(order)


def test_boxes_that_do_not_touch_close_nothing():
    assert _contacts(lifted=0.003) == [0.0] * 6


@pytest.mark.parametrize(("shift", "closed"), [(0.004, 1.0), (0.009, 0.0)])
def test_a_foot_must_stand_within_six_millimetres_of_its_patch(shift, closed):
    flags = _contacts(shifts=((0.0, 0.0), (0.0, 0.0), (shift, 0.0), (shift, 0.0)))
    assert flags == [1.0, 1.0, closed, closed, 1.0, 1.0]


def test_a_box_turned_half_round_has_its_poles_exchanged():
    assert _contacts(half_turn="square") == [1.0, 1.0, 0.0, 0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("order", "lifted", "shift", "closed"),
    [
        (SIGNS, 0.0, 0.0, [1.0] * 6),
        (SIGNS, 0.0, 0.004, [1.0, 1.0, 1.0, 1.0, 1.0, 1.0]),
        (SIGNS, 0.0, 0.009, [1.0, 1.0, 0.0, 0.0, 1.0, 1.0]),
        (SIGNS, 0.001, 0.0, [0.0] * 6),
        (("triangle", "waves", "square", "cross"), 0.0, 0.0, [0.0, 0.0, 0.0, 0.0, 1.0, 1.0]),
    ],
)
def test_without_forces_places_alone_close_the_contacts(order, lifted, shift, closed):  # R-K03, law 18
    plant = Plant(text(boxes(0, 0.0), (), drawn=False))
    for level, sign in enumerate(order):
        dx = shift if level > 1 else 0.0
        plant.data.joint(f"box_{sign}").qpos[:3] = 0.7 + dx, 0.0, TOP_M + SIZE_M[2] * (level + 0.5) + lifted * level
    mujoco.mj_kinematics(plant.model, plant.data)
    circuit, flags = Circuit(plant), np.full(6, 9.0)
    circuit.press()
    circuit.scan(flags)
    assert flags.tolist() == closed
