"""Who touches whom in a compiled world from files."""

import mujoco

from kit.worlds.grasping_cells import Cell
from onika.workcell.cell.cell_contacts import CellContacts


def contacts_of(world):
    return CellContacts(world._plant, world._composition.world, world._stands.arms())


def test_an_arm_or_its_hand_comes_first_and_what_lies_about_touches_nothing_worth_it():  # R-E16
    world = Cell(has_forces=True).world
    world.step(world.now_ns + 20_000_000)
    contacts = contacts_of(world)
    assert contacts.touching() == []
    data = world._plant.data
    data.joint("cube.free").qpos[:3] = data.body("left.lower").xpos
    data.joint("cube.free").qpos[0] += 0.1
    mujoco.mj_forward(world._plant.model, data)
    pairs = {(contact.one.kind, contact.other.name) for contact in contacts.touching(is_deep=True)}
    assert pairs == {("arm", "cube")}


def test_what_is_held_is_looked_at_too():  # R-E16
    world = Cell(has_forces=True).world
    world.step(world.now_ns + 20_000_000)
    contacts = contacts_of(world)
    cube = contacts.part("cube")
    (pair,) = {(contact.one.name, contact.other.name) for contact in contacts.touching([cube])}
    assert pair == ("cube", "table")
    assert contacts.hand("left").kind == "hand"
