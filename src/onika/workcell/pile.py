"""The boxes where there are no forces: where they lie, what stands on what, and where one comes to rest that falls."""

import math
from collections.abc import Iterable

import numpy as np

from onika.laws.frames import Array, quaternion_of_rotation, rotation_of_quaternion
from onika.workcell.box import SIGNS, SIZE_M
from onika.workcell.plant import Plant
from onika.workcell.table import top_at

_WIDE, _DEEP, _HIGH = (size / 2 for size in SIZE_M)
_TOUCHING = 0.002  # how far above another box one may be that still stands on it


class Pile:
    """All boxes of one plant by their numbers in `SIGNS`; `held` are those in a hand."""

    def __init__(self, plant: Plant) -> None:
        self._rows: list[Array] = [plant.data.joint(f"box_{sign}").qpos for sign in SIGNS]
        self.held: set[int] = set()

    def lying(self) -> list[int]:
        """The boxes in no hand."""
        return [number for number in range(len(SIGNS)) if number not in self.held]

    def pose(self, number: int) -> Array:
        """Where a box is."""
        row, pose = self._rows[number], np.eye(4)
        pose[:3, 3], pose[:3, :3] = row[:3], rotation_of_quaternion(row[3:])
        return pose

    def put(self, number: int, pose: Array) -> None:
        """Put a box there."""
        row = self._rows[number]
        row[:3], row[3:] = pose[:3, 3], quaternion_of_rotation(pose[:3, :3])

    def standing_on(self, number: int) -> list[int]:
        """The boxes that stand on this one, on those, and so on."""
        above = [
            other
            for other in self.lying()
            if other != number
            and abs(self._bottom(other) - self._top(number)) <= _TOUCHING
            and self._overlap(number, other)
        ]
        return above + [box for other in above for box in self.standing_on(other)]

    def drop(self, numbers: Iterable[int]) -> None:
        """Out of the hand and straight down, upright, onto whatever is below; the lowest first."""
        falling = sorted(numbers, key=self._bottom)
        self.held.update(falling)  # nothing rests on what is still in the air
        for number in falling:
            self._fall(number)
            self.held.discard(number)

    def _fall(self, number: int) -> None:
        row = self._rows[number]
        turn = rotation_of_quaternion(row[3:])
        yaw = math.atan2(turn[1, 0], turn[0, 0])
        below = [
            self._top(other) for other in self.lying() if self._rows[other][2] < row[2] and self._overlap(number, other)
        ]
        row[2] = max([top_at(float(row[0]), float(row[1])), *below]) + _HIGH
        row[3:] = math.cos(yaw / 2.0), 0.0, 0.0, math.sin(yaw / 2.0)

    def _top(self, number: int) -> float:
        return float(self._rows[number][2]) + _HIGH

    def _bottom(self, number: int) -> float:
        return float(self._rows[number][2]) - _HIGH

    def _overlap(self, first: int, other: int) -> bool:
        """Whether two boxes, seen from above, cover each other: no side of either parts them."""
        turns = [rotation_of_quaternion(self._rows[k][3:])[:2, :2] for k in (first, other)]
        apart = self._rows[other][:2] - self._rows[first][:2]
        for turn in turns:
            for axis in turn.T:
                reach = sum(_WIDE * abs(float(axis @ t[:, 0])) + _DEEP * abs(float(axis @ t[:, 1])) for t in turns)
                if abs(float(axis @ apart)) >= reach:
                    return False
        return True
