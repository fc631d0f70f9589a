"""The parts that move freely where there are no forces: their size, what stands on what, and where one comes to rest.

A part comes to rest on what is below it, upright: the axis of it that is nearest to the vertical becomes vertical.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array, quaternion_of_rotation, rotation_of_quaternion
from onika.model.world import PartBlock
from onika.workcell.composed.usable_parts import FREE_JOINT, prefix_of
from onika.workcell.plant import Plant

_NEAR_M = 0.002  # how far above another part one may be that still stands on it
_BELOW = 0.7  # cosine: how steeply something is below what rests on it
_RESTS_M = 1e-6
_LEAST_M = 5e-4  # how far a part falls at least between two looks, beside what it does not rest on
_DEPTH_M = 10.0  # how far down something is looked for
_FIRST_ROUND = (int(mujoco.mjtGeom.mjGEOM_SPHERE), int(mujoco.mjtGeom.mjGEOM_CAPSULE))


class LooseParts:
    """All parts of one plant that move freely, by number; `held` are those in a hand."""

    def __init__(self, plant: Plant, parts: Sequence[PartBlock]) -> None:
        model = plant.model
        self._model, self._data = model, plant.data
        named = [(part, _joint(model, part)) for part in parts if part.free is not None]
        there = [(part, joint) for part, joint in named if joint >= 0]
        self.names = tuple(part.name for part, _ in there)
        self._rows = [_row(model, plant.data, joint) for _, joint in there]
        roots = [int(model.body_rootid[model.jnt_bodyid[joint]]) for _, joint in there]
        self._shapes = [_shapes(model, root) for root in roots]
        is_fixed = model.body_weldid[model.geom_bodyid] == 0
        self._ground = [k for k in range(model.ngeom) if is_fixed[k] and _touches(model, k)]
        self.held: set[int] = set()

    def lying(self) -> list[int]:
        """The parts in no hand."""
        return [number for number in range(len(self._rows)) if number not in self.held]

    def pose(self, number: int) -> Array:
        """Where a part is, double[4,4]."""
        row, pose = self._rows[number], np.eye(4)
        pose[:3, 3], pose[:3, :3] = row[:3], rotation_of_quaternion(row[3:])
        return pose

    def put(self, number: int, pose: Array) -> None:
        """Put a part there."""
        row = self._rows[number]
        row[:3], row[3:] = pose[:3, 3], quaternion_of_rotation(pose[:3, :3])

    def extent(self, number: int, turn: Array) -> tuple[Array, Array]:
        """How far a part reaches about its own place in a frame in which it is turned so: lowest and highest x y z."""
        here = self.pose(number)
        ends = [_ends(self._model, self._data, shape, here, turn) for shape in self._shapes[number]]
        lows, highs = zip(*ends, strict=True)
        lowest, highest = np.min(lows, axis=0), np.max(highs, axis=0)
        return lowest, highest

    def standing_on(self, number: int) -> list[int]:
        """The parts that stand on this one, on those, and so on."""
        return [*dict.fromkeys(self._standing_on(number, {number}))]

    def drop(self, numbers: Iterable[int]) -> None:
        """Out of the hand and straight down, upright, onto whatever is below; the lowest first."""
        falling = sorted(numbers, key=lambda number: float(self._rows[number][2]))
        self.held.update(falling)  # nothing rests on what is still in the air
        for number in falling:
            self._fall(number)
            self.held.discard(number)

    def _standing_on(self, number: int, seen: set[int]) -> Iterator[int]:
        for other in self.lying():
            if other not in seen and self._stands(other, number):
                seen.add(other)
                yield other
                yield from self._standing_on(other, seen)

    def _stands(self, upper: int, lower: int) -> bool:
        gaps = self._gaps(self._shapes[upper], self._shapes[lower], _NEAR_M)
        return any(gap <= _NEAR_M and steep > _BELOW for gap, steep in gaps)

    def _fall(self, number: int) -> None:
        row = self._rows[number]
        row[3:] = quaternion_of_rotation(_upright(rotation_of_quaternion(row[3:])))
        others = [*self._ground, *(shape for other in self.lying() for shape in self._shapes[other])]
        start, lowest = float(row[2]), float(row[2]) - _DEPTH_M
        while row[2] > lowest:
            mujoco.mj_kinematics(self._model, self._data)
            gaps = [*self._gaps(self._shapes[number], others, _DEPTH_M)]
            below = [gap for gap, steep in gaps if steep > _BELOW]
            if below and min(below) < _RESTS_M:
                row[2] -= min(*below, 0.0)
                return
            beside = [max(gap, _LEAST_M) for gap, _ in gaps]
            row[2] -= min([*below, *beside], default=_DEPTH_M)
        row[2] = start  # there is nothing below

    def _gaps(self, shapes: Sequence[int], others: Sequence[int], most: float) -> Iterator[tuple[float, float]]:
        """How far shapes are from others that they can touch, and how steeply those are below them (cosine)."""
        model, ends = self._model, np.zeros(6)
        for shape in shapes:
            for other in others:
                if not _meet(model, shape, other):
                    continue
                gap = float(mujoco.mj_geomDistance(model, self._data, shape, other, most, ends))
                if gap < most:
                    yield gap, self._steepness(shape, other, gap, float(ends[2] - ends[5]))

    def _steepness(self, shape: int, other: int, gap: float, rise: float) -> float:
        if abs(gap) > _RESTS_M:
            return rise / gap
        places = self._data.geom_xpos  # they touch in a point: that says no direction
        return 1.0 if places[shape][2] > places[other][2] else -1.0


def _joint(model: Any, part: PartBlock) -> int:
    return int(mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, prefix_of(part.name) + FREE_JOINT))


def _row(model: Any, data: Any, joint: int) -> Array:
    first = int(model.jnt_qposadr[joint])
    row: Array = data.qpos[first : first + 7]
    return row


def _touches(model: Any, shape: int) -> bool:
    return bool(model.geom_contype[shape] or model.geom_conaffinity[shape])


def _meet(model: Any, shape: int, other: int) -> bool:
    kinds, meets = model.geom_contype, model.geom_conaffinity
    return bool((kinds[shape] & meets[other]) | (kinds[other] & meets[shape]))


def _shapes(model: Any, root: int) -> list[int]:
    """The shapes of a part that touch; all of them where none does."""
    own = [k for k in range(model.ngeom) if int(model.body_rootid[model.geom_bodyid[k]]) == root]
    return [k for k in own if _touches(model, k)] or own


def _ends(model: Any, data: Any, shape: int, here: Array, turn: Array) -> tuple[Array, Array]:
    """The lowest and highest x y z of a shape about its part's place, in a frame in which the part is turned so."""
    to_part = turn @ here[:3, :3].T
    middle = to_part @ (data.geom_xpos[shape] - here[:3, 3])
    axes = to_part @ data.geom_xmat[shape].reshape(3, 3)
    size, kind = model.geom_size[shape], int(model.geom_type[shape])
    if kind in _FIRST_ROUND:
        half = np.full(3, size[0]) + (np.abs(axes[:, 2]) * size[1] if kind == _FIRST_ROUND[1] else 0.0)
    elif kind == int(mujoco.mjtGeom.mjGEOM_CYLINDER):
        half = np.abs(axes[:, 2]) * size[1] + size[0] * np.sqrt(np.maximum(1.0 - axes[:, 2] ** 2, 0.0))
    elif kind == int(mujoco.mjtGeom.mjGEOM_ELLIPSOID):
        half = np.linalg.norm(axes * size, axis=1)
    else:  # a box, or the box around a mesh
        box = model.geom_aabb[shape]
        middle, half = middle + axes @ box[:3], np.abs(axes) @ box[3:]
    return middle - half, middle + half


def _upright(turn: Array) -> Array:
    """Turned as little as it takes for the axis that is nearest to the vertical to be vertical."""
    nearest = int(np.abs(turn[2]).argmax())
    axis = turn[:, nearest] * (1.0 if turn[2, nearest] > 0.0 else -1.0)
    about = np.array((axis[1], -axis[0], 0.0))  # axis x z
    sine = float(np.linalg.norm(about))
    if sine < 1e-12:
        return turn
    about /= sine
    x, y, cosine = float(about[0]), float(about[1]), float(axis[2])
    rest = 1.0 - cosine
    tip = np.array(
        (
            (cosine + x * x * rest, x * y * rest, y * sine),
            (x * y * rest, cosine + y * y * rest, -x * sine),
            (-y * sine, x * sine, cosine),
        )
    )
    upright: Array = tip @ turn
    return upright
