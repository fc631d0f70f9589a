"""A frame as the nine numbers of a Cartesian target: approach, normal, position (reading 44)."""

import math
from collections.abc import Sequence

COUNT = 9
SHAPE = "double[4,4]"
"""The shape of a variable that holds a frame: the axes and the position as columns."""

Vector = tuple[float, float, float]

_TURNS = 12
_PARALLEL = 1e-3
"""Two directions nearer to one line than this say nothing of a third that is square to one of them."""


def nine_of(rows: Sequence[Sequence[float]]) -> tuple[float, ...]:
    """The nine numbers of a frame of four rows: its third column, its first and its last, without the row below."""
    columns = list(zip(*rows[:3], strict=True))
    return tuple(float(number) for column in (columns[2], columns[0], columns[3]) for number in column)


def aimed(position: Vector, approach: Vector, normal: Vector) -> tuple[tuple[float, ...], ...]:
    """Poses at a position with this approach, turned about it in equal steps; first those turned least from `normal`.

    The approach may have any length but 0, for which ValueError is raised.
    """
    along = _unit(approach)
    first = _square(along, normal)
    second = _cross(along, first)
    steps = sorted(range(_TURNS), key=lambda step: min(step, _TURNS - step))
    angles = [2.0 * math.pi * step / _TURNS for step in steps]
    return tuple(
        (*along, *_sum(_times(math.cos(angle), first), _times(math.sin(angle), second)), *position) for angle in angles
    )


def _square(along: Vector, wish: Vector) -> Vector:
    """The direction square to `along` that is nearest to the wish; else to one of the axes of the world."""
    for direction in (wish, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)):
        rest = _sum(direction, _times(-_dot(direction, along), along))
        if math.hypot(*rest) > _PARALLEL:
            return _unit(rest)
    raise ValueError("no direction is square to it")  # pragma: no cover - one of two axes always is


def _unit(vector: Vector) -> Vector:
    length = math.hypot(*vector)
    if not length > 0.0:
        raise ValueError("a direction of no length")
    return _times(1.0 / length, vector)


def _times(factor: float, vector: Vector) -> Vector:
    x, y, z = vector
    return factor * x, factor * y, factor * z


def _sum(first: Vector, second: Vector) -> Vector:
    a, b, c = first
    x, y, z = second
    return a + x, b + y, c + z


def _dot(first: Vector, second: Vector) -> float:
    return sum(one * other for one, other in zip(first, second, strict=True))


def _cross(first: Vector, second: Vector) -> Vector:
    a, b, c = first
    x, y, z = second
    return b * z - c * y, c * x - a * z, a * y - b * x
