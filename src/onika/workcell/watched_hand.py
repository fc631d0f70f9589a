"""A hand as it is watched from outside: whether it is to be open, how far it is, and which box it has between its jaws.

A program means what a hand touches from within its jaws while it closes or is closed, and a moment longer: a box. All
else that a hand touches is in its way.
"""

from collections.abc import Iterable

import numpy as np

from onika.laws.frames import Array
from onika.workcell.contacts import Contact, Contacts, Thing
from onika.workcell.gripper import CLOSED_M
from onika.workcell.plant import Plant

LET_GO_NS = 500_000_000
"""How long after a hand is told to open a box may still touch it from within."""

_ALONG = 0.7  # cosine: how nearly contacts press along the way of the fingers, where they press from within
_SLIP_NS = 100_000_000  # how long a box that is held may be felt by one finger only
_CAME_M = 0.02  # how far a hand has come while it was open that is to take something; else it only waves
_DROP_M = 0.015  # how far a box may fall that is put down
_FALLING_NS = 1_000_000_000
_EMPTY_M = 0.001  # how near to its end a finger is that has met nothing


class WatchedHand:
    """One hand of one plant."""

    def __init__(self, plant: Plant, contacts: Contacts, side: str, now_ns: int) -> None:
        name = f"gripper_{side}"
        self.thing = Thing("hand", side)
        self.arm = Thing("arm", side)
        where, _ = plant.joints([f"{name}.finger1", f"{name}.finger2"])
        self._fingers = plant.data.qpos[where]
        self._signal = plant.data.ctrl[plant.signals([f"{name}.valve1", f"{name}.valve2"])]
        body = plant.body(f"{name}.hand")
        self._place, self._turn = plant.data.xpos[body], plant.data.xmat[body].reshape(3, 3)
        self._finger_of = contacts.fingers(side)
        self._contacts = contacts
        self._closes = self.is_closing
        self._changed_ns = now_ns
        self._may_be_empty = False
        self._opened_at = self._place.copy()
        self._felt: dict[Thing, int] = {}
        self.held: dict[Thing, Array] = {}
        """The boxes that it has, each with the place where it was taken."""
        self.let_go: dict[Thing, Array] = {}
        """Those that it has just opened from, each with the place where that was."""
        self.lost: list[Thing] = []
        """Those that it has lost since it was looked at before."""

    @property
    def is_closing(self) -> bool:
        """Whether it is told to be closed."""
        return bool(self._signal[0] < 0.0)

    def look(self, squeezed: Iterable[Thing], now_ns: int) -> None:
        """See what it has become, with the boxes that it has between its fingers now."""
        self.lost = []
        if self._closes is not self.is_closing:
            self._closes, self._changed_ns = self.is_closing, now_ns
            way = float(np.linalg.norm(self._place - self._opened_at))
            self._may_be_empty = self._closes and way > _CAME_M
            if not self._closes:
                self._opened_at = self._place.copy()
            self.let_go = {} if self._closes else {box: self._contacts.place(box) for box in self.held}
        elif not self._closes and now_ns - self._changed_ns > _FALLING_NS:
            self.let_go = {}
        if not self._closes:
            self.held, self._felt = {}, {}
            return
        for box in squeezed:
            self._felt[box] = now_ns
            if box not in self.held:
                self.held[box] = self._contacts.place(box)
        self.lost = [box for box, felt_ns in self._felt.items() if now_ns - felt_ns > _SLIP_NS]
        for box in self.lost:
            del self.held[box], self._felt[box]

    def is_found_empty(self) -> bool:
        """Whether it has closed, since it was told to, and there is nothing in it; said once."""
        if not self._may_be_empty or self.held or float(self._fingers.max()) > _EMPTY_M:
            return False
        self._may_be_empty = False
        return True

    def dropped(self) -> list[Thing]:
        """The boxes that it has let go in the air; each is said once."""
        falling = [box for box, place in self.let_go.items() if place[2] - self._contacts.place(box)[2] > _DROP_M]
        for box in falling:
            del self.let_go[box]
        return falling

    def means(self, contact: Contact, now_ns: int) -> bool:
        """Whether a program means that this hand touches this box."""
        if contact.shapes[0] not in self._finger_of:
            return False
        if contact.other in self.held:
            return True
        is_fresh = now_ns - self._changed_ns < LET_GO_NS
        if not self._closes and contact.other in self.let_go:
            return is_fresh
        return (self._closes or is_fresh) and self._is_within(contact)

    def squeezed(self, touching: Iterable[Contact]) -> list[Thing]:
        """The boxes that both fingers touch from within."""
        fingers: dict[Thing, set[int]] = {}
        for contact in touching:
            if contact.one == self.thing and contact.other.kind == "box" and self._is_within(contact):
                fingers.setdefault(contact.other, set()).add(self._finger_of[contact.shapes[0]])
        return [box for box, numbers in fingers.items() if len(numbers) == 2]

    def _is_within(self, contact: Contact) -> bool:
        """Whether a finger presses along its way on a box that is between both."""
        if contact.shapes[0] not in self._finger_of:
            return False
        along = self._turn[:, 1]
        if abs(float(along @ self._contacts.normal(contact))) < _ALONG:
            return False
        opening = CLOSED_M / 2 + float(self._fingers.max())
        return abs(float(along @ (self._contacts.place(contact.other) - self._place))) < opening
