"""The fingers of a gripper as they are watched: whether they are to close, how far they are, what is between them.

A program means what a hand touches from within its fingers while it closes or is closed, and a moment longer. All else
that a hand touches is in its way.
"""

from collections.abc import Iterable

import numpy as np

from onika.laws.frames import Array
from onika.workcell.cell.cell_contacts import CellContact, CellContacts
from onika.workcell.cell.cell_thing import FREE, CellThing
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.gripping.finger_way import FingerWay
from onika.workcell.gripping.tool_frame import ToolFrame

LET_GO_NS = 500_000_000
"""How long after a hand is told to open a part may still touch it from within."""

_ALONG = 0.7  # cosine: how nearly contacts press along the way of the fingers, where they press from within
_SLIP_NS = 100_000_000  # how long a part that is held may be felt by one finger only
_CAME_M = 0.02  # how far a hand has come while it was open that is to take something; else it only waves
_DROP_M = 0.015  # how far a part may fall that is put down
_FALLING_NS = 1_000_000_000
_EMPTY_M = 0.002  # how near to where it is told to be a hand is that has met nothing


class WatchedGripper:
    """One gripper of one plant; `thing` is what it is in there."""

    def __init__(
        self, unit: FingerUnit, way: FingerWay, tool: ToolFrame, contacts: CellContacts, thing: CellThing, now_ns: int
    ) -> None:
        self.unit, self.thing = unit, thing
        self._way, self._tool, self._contacts = way, tool, contacts
        self._narrow, self._wide = unit.facts.gripper.closed[1], unit.facts.gripper.open[1]
        self._aim = unit.aim
        self._closes = self._aim < self._wide
        self._changed_ns = now_ns
        self._may_be_empty = False
        self._opened_at = self._place()
        self._felt: dict[CellThing, int] = {}
        self._last: dict[CellThing, Array] = {}
        """Where each part was when it was last between the fingers."""
        self.held: dict[CellThing, Array] = {}
        """The parts that it has, each with the place where it was taken."""
        self.let_go: dict[CellThing, Array] = {}
        """Those that it has just opened from, each with the place where that was."""
        self.lost: list[CellThing] = []
        """Those that it has lost since it was looked at before."""

    def look(self, squeezed: Iterable[CellThing], now_ns: int) -> None:
        """See what it has become, with the parts that it has between its fingers now."""
        self.lost = []
        self._hear(now_ns)
        if not self._closes:
            self.held, self._felt = {}, {}
            return
        for part in squeezed:
            self._felt[part] = now_ns
            self._last[part] = self._contacts.place(part)
            if part not in self.held:
                self.held[part] = self._last[part]
        self.lost = [part for part, felt_ns in self._felt.items() if now_ns - felt_ns > _SLIP_NS]
        for part in self.lost:
            del self.held[part], self._felt[part]

    def is_found_empty(self) -> bool:
        """Whether it has closed, since it was told to, and there is nothing in it; said once."""
        if not self._may_be_empty or self.held or self._opening() > self._aim + _EMPTY_M:
            return False
        self._may_be_empty = False
        return True

    def dropped(self) -> list[CellThing]:
        """The parts that it has let go in the air; each is said once."""
        falling = [part for part, place in self.let_go.items() if place[2] - self._contacts.place(part)[2] > _DROP_M]
        for part in falling:
            del self.let_go[part]
        return falling

    def means(self, contact: CellContact, now_ns: int) -> bool:
        """Whether a program means that this hand touches this part."""
        if contact.shapes[0] not in self._way.fingers:
            return False
        if contact.other in self.held:
            return True
        is_fresh = now_ns - self._changed_ns < LET_GO_NS
        if not self._closes and contact.other in self.let_go:
            return is_fresh
        return (self._closes or is_fresh) and self._is_within(contact)

    def squeezed(self, touching: Iterable[CellContact]) -> list[CellThing]:
        """The parts that both fingers touch from within."""
        fingers: dict[CellThing, set[int]] = {}
        for contact in touching:
            if contact.one == self.thing and contact.other.kind == FREE and self._is_within(contact):
                fingers.setdefault(contact.other, set()).add(self._way.fingers[contact.shapes[0]])
        return [part for part, numbers in fingers.items() if len(numbers) == 2]

    def _hear(self, now_ns: int) -> None:
        """Whether it is told to be otherwise than before."""
        aim, before = self.unit.aim, self._aim
        self._aim = aim
        closes = self._closes if aim == before else aim < before
        if closes is not self._closes:
            self._closes, self._changed_ns = closes, now_ns
            self._may_be_empty = closes and float(np.linalg.norm(self._place() - self._opened_at)) > _CAME_M
            if not closes:
                self._opened_at = self._place()
            self.let_go = {} if closes else {part: self._let_go_at(part) for part in self.held}
        elif not closes and now_ns - self._changed_ns > _FALLING_NS:
            self.let_go = {}

    def _let_go_at(self, part: CellThing) -> Array:
        """Where a part was that is let go; without forces it has fallen at once."""
        here, last = self._contacts.place(part), self._last.get(part)
        return last if last is not None and last[2] - here[2] > _DROP_M else here

    def _is_within(self, contact: CellContact) -> bool:
        """Whether a finger presses along its way on a part that is between both."""
        if contact.shapes[0] not in self._way.fingers:
            return False
        tool = self._tool.pose()
        along = tool[:3, 1]
        if abs(float(along @ self._contacts.normal(contact))) < _ALONG:
            return False
        return abs(float(along @ (self._contacts.place(contact.other) - tool[:3, 3]))) < self._opening() / 2.0

    def _opening(self) -> float:
        return self._narrow + self._way.share() * (self._wide - self._narrow)

    def _place(self) -> Array:
        place: Array = self._tool.pose()[:3, 3].copy()
        return place
