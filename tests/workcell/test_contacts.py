import mujoco
import pytest

from onika.workcell.contacts import Contacts, Thing
from onika.workcell.layout import boxes, text
from onika.workcell.plant import Plant

BOX = Thing("box", "square")


@pytest.fixture
def plant():
    plant = Plant(text(boxes(0, 0.0), ("left", "right"), drawn=False))
    mujoco.mj_step(plant.model, plant.data, nstep=20)  # boxes sink until the table bears them
    return plant


def test_what_lies_about_is_no_contact_and_what_is_held_is_one_with_all_it_touches(plant):  # R-E16
    contacts = Contacts(plant)
    assert contacts.touching() == []
    held = contacts.touching({BOX})
    assert {(contact.one, contact.other) for contact in held} == {(BOX, Thing("table"))}


def test_the_moved_thing_of_two_comes_first_and_how_they_press_is_known(plant):  # R-E16
    plant.data.joint("box_square").qpos[:3] = plant.data.body("arm_right.link3").xpos
    mujoco.mj_forward(plant.model, plant.data)
    contacts = Contacts(plant)
    contact = contacts.touching()[0]
    assert (contact.one, contact.other) == (Thing("arm", "right"), BOX)
    assert (contacts.normal(contact) ** 2).sum() == pytest.approx(1.0)
    assert contacts.touching(is_deep=True)


def test_arms_have_a_side_where_there_are_two():  # R-E16
    assert str(Thing("hand", "left").text(is_alone=True)) == "the hand"
    assert str(Thing("hand", "left").text(is_alone=False)) == "the left hand"
    assert str(BOX.text(is_alone=True)) == "the box with the square"


def test_each_finger_has_shapes_of_its_own(plant):
    assert sorted(set(Contacts(plant).fingers("left").values())) == [1, 2]
