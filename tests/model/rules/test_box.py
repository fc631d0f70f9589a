from dataclasses import replace
from itertools import pairwise

import pytest
from hypothesis import given, strategies as st

from onika.model.port import PortKind
from onika.model.preferences import Preferences
from onika.model.rules.box import WIDTH, box_of
from onika.model.task import Task

PD = Task("pd", "pd", inconst=("KP",), invar=("Q_REF", "Q_MEZ"), outvar=("TAU",), aliases=(("TAU", "TAU_PD"),))


def test_inputs_and_outputs_have_rows_of_their_own():  # R-C02
    box = box_of(PD, Preferences())
    assert [(pin.name, pin.svar, pin.kind) for pin in box.pins] == [
        ("KP", "KP", PortKind.INCONST),
        ("Q_REF", "Q_REF", PortKind.INVAR),
        ("Q_MEZ", "Q_MEZ", PortKind.INVAR),
        ("TAU", "TAU_PD", PortKind.OUTVAR),
    ]
    assert box.pins[0].y == box.pins[3].y < box.pins[1].y < box.pins[2].y < box.height


def test_a_pin_that_is_both_stands_once():  # R-C02
    task = Task("t", "t", inconst=("A",), invar=("A",))
    assert [pin.kind for pin in box_of(task, Preferences()).pins] == [PortKind.INBOTH]


@given(st.integers(0, 40), st.integers(1, 40), st.integers(1, 30), st.integers(1, 300))
def test_the_height_grows_until_the_pins_are_far_enough_apart(pins, apart, step, least):  # R-C02, R-G01
    task = Task("t", "t", invar=tuple(f"V{n}" for n in range(pins)))
    preferred = Preferences(min_pin_separation=apart, step_size=step, min_size=least)
    box = box_of(task, preferred)
    places = [pin.y for pin in box.pins]
    assert all(b - a == apart for a, b in pairwise(places))
    assert box.height >= max([least, *places])
    assert box.width == WIDTH
    assert box_of(replace(task, invar=(*task.invar, "MORE")), preferred).height >= box.height


@pytest.mark.parametrize("in_left", [True, False])
def test_a_flipped_box_has_its_pins_on_the_other_sides(in_left):  # R-C10
    box = box_of(PD, Preferences())
    reads, writes = box.pins[1], box.pins[3]
    left, right = (reads, writes) if in_left else (writes, reads)
    assert box.reach(left, 100, 50, in_left) == (100, 50 + left.y)
    assert box.reach(right, 100, 50, in_left) == (100 + WIDTH, 50 + right.y)
    assert (box.outward(left, in_left), box.outward(right, in_left)) == (-1, 1)
