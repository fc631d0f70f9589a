"""Who touches whom in a compiled world: the shapes of arms, hands, boxes, table and floor, by what they belong to."""

from collections.abc import Collection
from dataclasses import dataclass
from typing import Any, NamedTuple

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.words.reason import Reason
from onika.workcell.box import SIGNS
from onika.workcell.plant import Plant

DEEP_M = 0.001
"""How far shapes reach into each other that touch where there are no forces to keep them apart."""

_CALLED = {
    ("arm", ""): "workcell.the_arm",
    ("arm", "left"): "workcell.the_left_arm",
    ("arm", "right"): "workcell.the_right_arm",
    ("hand", ""): "workcell.the_hand",
    ("hand", "left"): "workcell.the_left_hand",
    ("hand", "right"): "workcell.the_right_hand",
    ("box", "waves"): "workcell.the_box_waves",
    ("box", "triangle"): "workcell.the_box_triangle",
    ("box", "square"): "workcell.the_box_square",
    ("box", "cross"): "workcell.the_box_cross",
    ("table", ""): "workcell.the_table",
    ("floor", ""): "workcell.the_floor",
}

_RANKS = {kind: rank for rank, kind in enumerate(("hand", "arm", "box", "table", "floor"))}


@dataclass(frozen=True, slots=True, order=True)
class Thing:
    """What can touch: an arm or a hand by its side, a box by its sign, the table, the floor."""

    kind: str
    name: str = ""

    @property
    def moves(self) -> bool:
        """Whether a program moves it."""
        return self.kind in ("arm", "hand")

    def text(self, *, is_alone: bool) -> Reason:
        """What it is called; an arm, and its hand, without a side where there is no other one."""
        return Reason.of(_CALLED[self.kind, "" if self.moves and is_alone else self.name])


class Contact(NamedTuple):
    """One contact of two things, the moved one first where one is; `at` is its number in this instant."""

    one: Thing
    other: Thing
    shapes: tuple[int, int]
    at: int


class Contacts:
    """The contacts of one plant that somebody may want to know of; boxes that lie about touch nothing worth it."""

    def __init__(self, plant: Plant) -> None:
        self._plant = plant
        model = plant.model
        self._things = [_thing(model, shape) for shape in range(model.ngeom)]
        self._matters = np.array([[_matters(one, other) for other in self._things] for one in self._things])

    def fingers(self, side: str) -> dict[int, int]:
        """The shapes of a hand's fingers, each with the number of its finger."""
        model, shapes = self._plant.model, {}
        for number in (1, 2):
            body = self._plant.body(f"gripper_{side}.finger{number}")
            shapes.update({shape: number for shape in range(model.ngeom) if int(model.geom_bodyid[shape]) == body})
        return shapes

    def place(self, thing: Thing) -> Array:
        """Where the middle of a box is."""
        middle: Array = self._plant.data.body(f"box_{thing.name}").xpos.copy()
        return middle

    def collide(self) -> None:
        """Look for contacts where no physics does."""
        mujoco.mj_collision(self._plant.model, self._plant.data)

    def touching(self, held: Collection[Thing] = (), *, is_deep: bool = False) -> list[Contact]:
        """What touches now, also those boxes that are held; `is_deep`: only what reaches into each other."""
        contacts = self._plant.data.contact
        pairs = contacts.geom
        counts = self._matters[pairs[:, 0], pairs[:, 1]]
        if held:
            are_held = np.array([thing in held for thing in self._things])
            counts = counts | are_held[pairs[:, 0]] | are_held[pairs[:, 1]]
        if is_deep:
            counts &= contacts.dist < -DEEP_M
        if not counts.any():
            return []
        return [self._contact(at, *pairs[at].tolist()) for at in np.flatnonzero(counts).tolist()]

    def normal(self, contact: Contact) -> Array:
        """The line along which it presses."""
        normal: Array = self._plant.data.contact.frame[contact.at][:3]
        return normal

    def _contact(self, at: int, first: int, second: int) -> Contact:
        one, other = self._things[first], self._things[second]
        if _RANKS[other.kind] < _RANKS[one.kind] or (other.kind == one.kind and other.name < one.name):
            return Contact(other, one, (second, first), at)
        return Contact(one, other, (first, second), at)


def _matters(one: Thing, other: Thing) -> bool:
    return one != other and (one.moves or other.moves or {one.kind, other.kind} == {"box", "floor"})


def _thing(model: Any, shape: int) -> Thing:
    body = model.body(int(model.geom_bodyid[shape])).name
    kind, _, name = body.partition(".")[0].partition("_")
    if kind == "box" and name in SIGNS:
        return Thing("box", name)
    if name:
        return Thing("hand" if kind == "gripper" else "arm", name)
    return Thing(model.geom(shape).name)
