"""Who touches whom in a compiled world from files, by what the shapes belong to."""

from collections.abc import Collection, Mapping
from typing import NamedTuple

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.model.world import WorldText
from onika.workcell.cell.cell_thing import FLOOR, FREE, HAND, CellThing, rank, things_of
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.usable_parts import FREE_JOINT, prefix_of
from onika.workcell.plant import Plant

DEEP_M = 0.001
"""How far things reach into each other that touch and are not meant to, where there are no forces."""

_FAR_LINKS = 3  # bodies of an arm nearer than so many links reach into each other in many models


class CellContact(NamedTuple):
    """One contact of two things, the moved one first where one is; `at` is its number in this instant."""

    one: CellThing
    other: CellThing
    shapes: tuple[int, int]
    at: int


class CellContacts:
    """The contacts of one plant that somebody may want to know of; parts that lie about touch nothing worth it."""

    def __init__(self, plant: Plant, world: WorldText, arms: Mapping[JointUnit, bool]) -> None:
        self._plant = plant
        self._things = [*things_of(plant.model, world, arms)]
        self._kinds = list(dict.fromkeys(self._things))
        self._of_shape = np.array([self._kinds.index(thing) for thing in self._things], dtype=int)
        self._matters = np.array([[_matters(one, other) for other in self._kinds] for one in self._kinds])
        self._own = np.array([[_is_own(one, other) for other in self._kinds] for one in self._kinds])
        self._usual: set[tuple[int, int]] = set()

    def part(self, name: str) -> CellThing:
        """The thing that a part is."""
        return next(thing for thing in self._kinds if (thing.kind, thing.name) == (FREE, name))

    def hand(self, place: str) -> CellThing | None:
        """The hand at a place."""
        return next((thing for thing in self._kinds if (thing.kind, thing.name) == (HAND, place)), None)

    def place(self, part: CellThing) -> Array:
        """Where a part is that moves."""
        row: Array = self._plant.data.joint(prefix_of(part.name) + FREE_JOINT).qpos[:3]
        return row.copy()

    def collide(self) -> None:
        """Look for contacts where no physics does."""
        mujoco.mj_collision(self._plant.model, self._plant.data)

    def touching(self, held: Collection[CellThing] = (), *, is_deep: bool = False) -> list[CellContact]:
        """What touches now, also those parts that are held; `is_deep`: only what reaches into each other."""
        contacts = self._plant.data.contact
        things = self._of_shape[contact_pairs(contacts)]
        counts = self._matters[things[:, 0], things[:, 1]]
        if held:
            are_held = np.array([thing in held for thing in self._kinds])
            is_other = things[:, 0] != things[:, 1]
            counts = counts | ((are_held[things[:, 0]] | are_held[things[:, 1]]) & is_other)
        if is_deep:
            counts = counts & (contacts.dist < -DEEP_M)
        return [self._contact(at, *contacts.geom[at].tolist()) for at in np.flatnonzero(counts).tolist()]

    def of_themselves(self, *, is_first: bool) -> list[CellThing]:
        """The arms that touch themselves where they did not at first, between links that are not neighbours."""
        contacts, model = self._plant.data.contact, self._plant.model
        pairs = contact_pairs(contacts)
        things = self._of_shape[pairs]
        own = self._own[things[:, 0], things[:, 1]] & (contacts.dist < -DEEP_M)
        arms: list[CellThing] = []
        for first, other in pairs[own].tolist():
            bodies = int(model.geom_bodyid[first]), int(model.geom_bodyid[other])
            if is_first:
                self._usual.add(bodies)
            elif bodies not in self._usual and self._links_between(*bodies) >= _FAR_LINKS:
                arms.append(max(self._things[first], self._things[other], key=rank))
        return [*dict.fromkeys(arms)]

    def normal(self, contact: CellContact) -> Array:
        """The line along which it presses."""
        normal: Array = self._plant.data.contact.frame[contact.at][:3]
        return normal

    def _links_between(self, first: int, other: int) -> int:
        parents = self._plant.model.body_parentid
        low, high, count = min(first, other), max(first, other), 0
        while high > low:
            high, count = int(parents[high]), count + 1
        return count if high == low else _FAR_LINKS

    def _contact(self, at: int, first: int, second: int) -> CellContact:
        one, other = self._things[first], self._things[second]
        if rank(other) < rank(one):
            return CellContact(other, one, (second, first), at)
        return CellContact(one, other, (first, second), at)


def contact_pairs(contacts: mujoco.MjData) -> np.ndarray[tuple[int, int], np.dtype[np.int32]]:
    """The shapes of all contacts, int32[n,2]."""
    return np.asarray(contacts.geom).reshape(-1, 2)


def _matters(one: CellThing, other: CellThing) -> bool:
    """Whether their contacts are looked at: not those of one robot with itself, nor of parts that lie about."""
    if one.moves or other.moves:
        return not (one.moves and other.moves and one.name == other.name)
    return {one.kind, other.kind} == {FREE, FLOOR}


def _is_own(one: CellThing, other: CellThing) -> bool:
    """Whether both belong to one arm, and not both to its hand."""
    return one.moves and other.moves and one.name == other.name and not one.kind == other.kind == HAND
