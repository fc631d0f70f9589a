"""What is in the way of an arm when its drive begins to hold, and where its hand stands, in words."""

from collections.abc import Iterator

import mujoco
import numpy as np

from onika.laws import puma560
from onika.laws.frames import Array
from onika.words.reason import Reason
from onika.workcell.contacts import Contact, Contacts, Thing
from onika.workcell.plant import Plant

PRESSED_N = 5.0
"""How hard two things press on each other of which one is in the other's way; a box that lies there presses less."""


class Hindrance:
    """The contacts of one plant, looked at when somebody asks.

    has_forces  whether things press on each other there; else they reach into each other
    """

    def __init__(self, plant: Plant, *, has_forces: bool) -> None:
        self._plant = plant
        self._contacts = Contacts(plant)
        self._has_forces = has_forces

    def told(self, side: str, held: str, *, is_alone: bool) -> tuple[Reason, ...]:
        """What the arm at a side, its hand, or the box in that (by its sign) presses against."""
        own = {Thing("arm", side), Thing("hand", side)}
        box = Thing("box", held) if held else None
        return tuple(self._text(pair, own, box, is_alone) for pair in sorted(self._pairs(own, box)))

    def place(self, side: str, *, is_alone: bool) -> Reason:
        """Where the middle between the fingers of a hand is."""
        body, pose = self._plant.body(f"gripper_{side}.hand"), np.eye(4)
        pose[:3, 3], pose[:3, :3] = self._plant.data.xpos[body], self._plant.data.xmat[body].reshape(3, 3)
        x, y, z = ((pose @ puma560.TOOL)[:3, 3] * 100.0).tolist()  # a message takes plain numbers
        return Reason.of("workcell.stands_at", who=Thing("hand", side).text(is_alone=is_alone), x=x, y=y, z=z)

    def _pairs(self, own: set[Thing], box: Thing | None) -> Iterator[tuple[Thing, Thing]]:
        """Those of what belongs to the arm and of what does not."""
        carried = {box} if box else set()
        forces: dict[tuple[Thing, Thing], float] = {}
        if not self._has_forces:
            self._contacts.collide()
        for contact in self._contacts.touching(carried, is_deep=not self._has_forces):
            pair = (contact.one, contact.other)
            if len({thing in own or thing in carried for thing in pair}) == 2:
                forces[pair] = forces.get(pair, 0.0) + self._force(contact)
        yield from (pair for pair, force in forces.items() if force >= PRESSED_N or not self._has_forces)

    def _force(self, contact: Contact) -> float:
        force: Array = np.zeros(6)
        mujoco.mj_contactForce(self._plant.model, self._plant.data, contact.at, force)
        return abs(float(force[0]))

    def _text(self, pair: tuple[Thing, Thing], own: set[Thing], box: Thing | None, is_alone: bool) -> Reason:
        who, what = pair if pair[0] in own or pair[0] == box else pair[::-1]
        if who == box:
            hand = next(thing for thing in own if thing.kind == "hand")
            called = {"what": who, "hand": hand, "other": what}
            key = "workcell.carried_touches"
        else:
            called = {"who": who, "what": what}
            key = "workcell.meets" if what.moves else "workcell.touches"
        return Reason.of(key, **{name: thing.text(is_alone=is_alone) for name, thing in called.items()})
