"""Where things stand in the box assembly, and the documents made of them (§6.2)."""

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from onika.laws.frames import Array
from onika.workcell.arm import ArmKind, arm
from onika.workcell.box import SIGNS, AssemblyBox
from onika.workcell.gripper import GripperPart
from onika.workcell.paint import paints
from onika.workcell.part import ARMS, WorldPart, document
from onika.workcell.puma import PUMA
from onika.workcell.scara import SCARA
from onika.workcell.table import TOP_M, floor, table
from onika.workcell.view import LOOK, view

LAYOUT_M = {"waves": (0.70, 0.0), "triangle": (0.70, 0.28), "square": (0.70, -0.28), "cross": (0.50, -0.18)}
"""Where the boxes stand at the start, x and y in the world."""

SHAKEN_M = 0.001
"""How far a box may stand from its place where things are a little elsewhere each time."""

SIDES = ("left", "right")
"""The arms: the left one's frame 0 is the world's, the right one faces it across the table."""

KINDS: Mapping[str, ArmKind] = {"arm": PUMA, "scara": SCARA}
"""The arms that may stand at either side, by the first word of their names: `arm_left`, `scara_left` ..."""

STANDARD = "arm"
"""The kind that stands where nothing else is said."""

RIGHT_BASE_M = 1.25
"""Distance between the arms along x; both reach all boxes and their places in the stack."""


def base(side: str) -> Array:
    """Frame 0 of an arm in the world, double[4,4]."""
    pose = np.eye(4)
    if side == "right":
        pose[:2, :2] *= -1.0
        pose[0, 3] = RIGHT_BASE_M
    return pose


def boxes(seed: int, offsets_m: float) -> tuple[AssemblyBox, ...]:
    """The four boxes, each moved by up to plus or minus `offsets_m` on x and y, drawn from `seed`."""
    moved = np.random.default_rng(seed).uniform(-offsets_m, offsets_m, (len(SIGNS), 2)).tolist()
    return tuple(
        AssemblyBox(sign, LAYOUT_M[sign][0] + dx, LAYOUT_M[sign][1] + dy, TOP_M)
        for sign, (dx, dy) in zip(SIGNS, moved, strict=True)
    )


def text(
    stack: Iterable[AssemblyBox], sides: tuple[str, ...], drawn: bool, kinds: Mapping[str, str] | None = None
) -> str:
    """The MJCF document of these boxes and the arms of these sides, to be stepped or to be drawn.

    `kinds` says by its side which arm is of another kind than the standard one.
    """
    return document("boxes", _parts(stack, sides, drawn, kinds or {}), LOOK if drawn else "")


def _parts(
    stack: Iterable[AssemblyBox], sides: tuple[str, ...], drawn: bool, kinds: Mapping[str, str]
) -> Iterator[WorldPart]:
    if drawn:
        yield paints()
        yield view(len(sides))
    yield floor(drawn)
    yield table(drawn)
    for box in stack:
        yield box.part(drawn)
    for side in sides:
        kind, touch = kinds.get(side, STANDARD), ARMS[SIDES.index(side)]
        yield arm(KINDS[kind], f"{kind}_{side}", base(side), touch, GripperPart(f"gripper_{side}"), drawn)
