"""A gripper without forces: fingers that go at an even speed, parts that go with the hand (law 18, requirement X19).

A part is taken that is between the fingers as they close on it: narrow enough, and well between them. One that stands
nearly square to them is squared and centred, as jaws do it. Whatever stands on it comes along.
"""

from typing import NamedTuple

import numpy as np

from onika.laws.frames import Array, inverse_pose
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.gripping.finger_way import FingerWay
from onika.workcell.gripping.loose_parts import LooseParts
from onika.workcell.gripping.tool_frame import ToolFrame

ASKEW = 0.94
"""Cosine of how far a part may be turned against the hand to be squared: 20 degrees."""

SPEED_M_S = 0.4
"""How fast fingers go apart or together."""

_WELL_WITHIN = 0.787  # as a share of the part's half size: how far its middle may be from the point between the fingers
_NEAR_M = 0.004  # how far fingers are from where they are told to be that something blocks, and from a part's width
_RESTS_M_S = 0.01
_LET_GO_M = 0.001  # how much wider than a part a hand is told to be that lets it go


class _Between(NamedTuple):
    """A part between the fingers: its number, where it would be held in the frame of the tool, and its width."""

    number: int
    pose: Array
    width: float
    away: float


class Grasp:
    """One gripper in one plant, and what it carries: parts by number, and their poses in the frame of its tool."""

    def __init__(self, unit: FingerUnit, way: FingerWay, tool: ToolFrame, parts: LooseParts, step_s: float) -> None:
        self.unit, self._way, self._tool, self._parts = unit, way, tool, parts
        self._step_s = step_s
        self._narrow, self._wide = unit.facts.gripper.closed[1], unit.facts.gripper.open[1]
        self.opening = self._narrow + way.share() * (self._wide - self._narrow)
        self.speed = 0.0
        self.carried: dict[int, Array] = {}
        self._width = self._narrow

    @property
    def force(self) -> float:
        """What the fingers press with (N)."""
        return self.unit.pressing if self.carried else 0.0

    def take_up(self) -> None:
        """A hand that is found at rest, and not as closed as it is told to be, has the part between its fingers."""
        self._take(self._blocking())
        if self.carried and abs(self._width - self.opening) > _NEAR_M:
            self._width = self.opening  # its file says other widths than its fingers have
        if self.carried:
            self.opening = self._width
        self._way.go(self._share(), 0.0)

    def holds(self) -> int | None:
        """The part that is between its fingers, which rest there, less closed than told to be."""
        blocking = self._blocking()
        return min(blocking, key=lambda part: part.away).number if blocking else None

    def move(self) -> None:
        """Fingers one step on; a part that is let go falls, one that is met on closing is taken."""
        aim, step, before = self.unit.aim, SPEED_M_S * self._step_s, self.opening
        if self.carried and aim > self._width + _LET_GO_M:
            self.let_go()
        if aim >= before:
            self.opening = min(before + step, aim)
        else:
            self.opening = self._closing(max(before - step, aim))
        self.speed = (self.opening - before) / self._step_s
        self._way.go(self._share(), self.speed / (self._wide - self._narrow))

    def carry(self) -> None:
        """Put what it carries where the hand has come to."""
        if self.carried:
            tool = self._tool.pose()
            for number, pose in self.carried.items():
                self._parts.put(number, tool @ pose)

    def let_go(self) -> None:
        """What it carries falls."""
        self._parts.drop(self.carried)
        self.carried = {}

    def _closing(self, wanted: float) -> float:
        """How far it is open a step later, on its way to be closer."""
        if not self.carried:
            self._take([part for part in self._between() if wanted <= part.width <= self.opening])
        return max(wanted, self._width) if self.carried else wanted

    def _blocking(self) -> list[_Between]:
        is_blocked = self.unit.aim < self.opening - _NEAR_M and abs(float(self.unit.state[3])) < _RESTS_M_S
        return self._between() if is_blocked else []

    def _share(self) -> float:
        return (self.opening - self._narrow) / (self._wide - self._narrow)

    def _take(self, between: list[_Between]) -> None:
        """Take the nearest of these parts, with all that stands on it."""
        if not between:
            return
        part = min(between, key=lambda part: part.away)
        to_tool = inverse_pose(self._tool.pose())
        moved = part.pose @ inverse_pose(to_tool @ self._parts.pose(part.number))
        taken = (part.number, *self._parts.standing_on(part.number))
        self.carried = {number: moved @ to_tool @ self._parts.pose(number) for number in taken}
        self._parts.held |= set(self.carried)
        self._width = part.width

    def _between(self) -> list[_Between]:
        to_tool = inverse_pose(self._tool.pose())
        seen = {number: to_tool @ self._parts.pose(number) for number in self._parts.lying()}
        parts = [self._held(number, pose) for number, pose in seen.items()]
        return [part for part in parts if part is not None]

    def _held(self, number: int, pose: Array) -> _Between | None:
        """How a part would be held; None where it is not between the fingers."""
        square = pose.copy()
        squared = np.rint(pose[:3, :3])
        if np.abs(pose[:3, :3] * squared).max(axis=1).min() >= ASKEW:
            square[:3, :3] = squared
        lowest, highest = self._parts.extent(number, square[:3, :3])
        middle, half = (lowest + highest) / 2.0, (highest - lowest) / 2.0
        width = 2.0 * float(half[1])
        if not self._narrow <= width <= self._wide:
            return None
        off = np.abs(pose[:3, 3] + middle)
        room = np.array((_WELL_WITHIN * half[0], self._wide / 2.0 - half[1], _WELL_WITHIN * half[2]))
        if np.any(off > room):
            return None
        square[1, 3] = -middle[1]
        return _Between(number, square, width, float(np.linalg.norm(off)))
