import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.frames import pose_of_nine
from onika.laws.inverse import serial_inverse
from onika.workcell.box import SIGNS, SIZE_M
from onika.workcell.layout import LAYOUT_M, SIDES, base, boxes, text
from onika.workcell.plant import Plant
from onika.workcell.table import TOP_M

CENTRES = [TOP_M + SIZE_M[2] * (k + 0.5) for k in range(4)]


@pytest.mark.parametrize("side", SIDES)
def test_both_arms_reach_every_box_and_every_place_in_the_stack_and_above(side):  # R-K02
    inverse = serial_inverse(puma560.DH, base(side), puma560.TOOL, puma560.QMIN, puma560.QMAX)
    places = [(*LAYOUT_M[sign], z) for sign in SIGNS for z in (CENTRES[0], -0.125)]
    places += [(*LAYOUT_M["waves"], z + 0.0008) for z in CENTRES]
    for place in places:
        q = inverse.nearest(pose_of_nine([0.0, 0.0, -1.0, 0.0, 1.0, 0.0, *place]), puma560.HOME)
        assert not isinstance(q, str), f"{place}: {q}"


def test_where_another_kind_is_named_it_stands_in_place_of_the_standard_one():  # R-K03
    plant = Plant(text(boxes(0, 0.0), SIDES, drawn=False, kinds={"left": "scara"}))
    assert plant.body("scara_left.link4")
    assert plant.body("arm_right.link6")
    with pytest.raises(KeyError):
        plant.body("arm_left.link6")


def test_upright_arms_touch_neither_each_other_nor_anything_else():  # R-K02
    plant = Plant(text(boxes(0, 0.0), SIDES, drawn=False))
    for side in SIDES:
        where, _ = plant.joints([f"arm_{side}.joint{k}" for k in range(1, 7)])
        plant.data.qpos[where] = puma560.HOME
    plant.settle()
    of_boxes = {plant.body(f"box_{sign}") for sign in SIGNS}
    for pair in plant.data.contact.geom.tolist():
        assert of_boxes & {int(plant.model.geom_bodyid[shape]) for shape in pair}


def test_offsets_are_drawn_from_the_seed_and_stay_within_their_bound():
    assert boxes(7, 0.002) == boxes(7, 0.002)
    assert boxes(7, 0.002) != boxes(8, 0.002)
    for seed in range(20):
        for box in boxes(seed, 0.002):
            assert np.abs(np.subtract((box.x, box.y), LAYOUT_M[box.sign])).max() <= 0.002
    assert [(box.x, box.y) for box in boxes(7, 0.0)] == [LAYOUT_M[sign] for sign in SIGNS]
