"""Where things stand in the box assembly, and the documents made of them (§6.2)."""

from collections.abc import Iterable, Iterator

import numpy as np

from onika.laws.frames import Array
from onika.workcell.box import SIGNS, Box
from onika.workcell.gripper import Gripper
from onika.workcell.paint import paints
from onika.workcell.part import ARMS, Part, document
from onika.workcell.puma import arm
from onika.workcell.table import TOP_M, floor, table
from onika.workcell.view import LOOK, view

LAYOUT_M = {"waves": (0.70, 0.0), "triangle": (0.70, 0.28), "square": (0.70, -0.28), "cross": (0.50, -0.18)}
"""Where the boxes stand at the start, x and y in the world."""

SIDES = ("left", "right")
"""The arms: the left one's frame 0 is the world's, the right one faces it across the table."""

RIGHT_BASE_M = 1.25
"""Distance between the arms along x; both reach all boxes and their places in the stack."""


def base(side: str) -> Array:
    """Frame 0 of an arm in the world, double[4,4]."""
    pose = np.eye(4)
    if side == "right":
        pose[:2, :2] *= -1.0
        pose[0, 3] = RIGHT_BASE_M
    return pose


def boxes(seed: int, offsets_m: float) -> tuple[Box, ...]:
    """The four boxes, each moved by up to plus or minus `offsets_m` on x and y, drawn from `seed`."""
    moved = np.random.default_rng(seed).uniform(-offsets_m, offsets_m, (len(SIGNS), 2)).tolist()
    return tuple(
        Box(sign, LAYOUT_M[sign][0] + dx, LAYOUT_M[sign][1] + dy, TOP_M)
        for sign, (dx, dy) in zip(SIGNS, moved, strict=True)
    )


def text(stack: Iterable[Box], sides: tuple[str, ...], drawn: bool) -> str:
    """The MJCF document of these boxes and the arms of these sides, to be stepped or to be drawn."""
    return document("boxes", _parts(stack, sides, drawn), LOOK if drawn else "")


def _parts(stack: Iterable[Box], sides: tuple[str, ...], drawn: bool) -> Iterator[Part]:
    if drawn:
        yield paints()
        yield view(len(sides))
    yield floor(drawn)
    yield table(drawn)
    for box in stack:
        yield box.part(drawn)
    for side in sides:
        yield arm(f"arm_{side}", base(side), ARMS[SIDES.index(side)], Gripper(f"gripper_{side}"), drawn)
