"""Where the things of the box assembly stand at the start, and what is elsewhere now, in words (law 18)."""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from onika.laws import puma560
from onika.laws.frames import Array, inverse_pose, rotation_of_quaternion
from onika.ring.displacement import Displacement
from onika.words.reason import Reason
from onika.workcell.arm_unit import ArmUnit
from onika.workcell.box import SIZE_M, AssemblyBox
from onika.workcell.contacts import Thing
from onika.workcell.grasp import JAWS_M
from onika.workcell.gripper import CLOSED_M
from onika.workcell.plant import Plant

NEAR_M = 0.004
"""How far a box may be from its place and still stand there: what it settles by, and no more."""

TURNED_RAD = 0.05
"""How far a box may be turned and still stand as it stood."""

POSTURE = 0.02
"""How far a joint may be from where it began (rad; m where it slides)."""

_HIGH = SIZE_M[2] / 2
_PRESSED_M = 0.003  # how far a finger may be from where it meets a box and still hold it


class StartPlaces:
    """The places of these boxes, and of the arms that are there."""

    def __init__(self, boxes: Sequence[AssemblyBox]) -> None:
        self._boxes = tuple(boxes)

    def places(self, arms: Sequence[ArmUnit]) -> Iterator[Reason]:
        """What stands where at the start."""
        for box in self._boxes:
            yield Reason.of("workcell.box_place", box=_box(box), x_cm=100 * box.x, y_cm=100 * box.y)
        for arm in arms:
            yield Reason.of("workcell.arm_place", arm=_named("arm", arm, arms))

    def displaced(self, plant: Plant, arms: Sequence[ArmUnit]) -> Iterator[Displacement]:
        """What does not stand there: what a hand holds first, then boxes, then arms, which may be anywhere."""
        holders = {arm: held for arm in arms if (held := self.held(plant, arm.side)) is not None}
        for arm, held in holders.items():
            yield Displacement(Reason.of("workcell.hand_holds", hand=_named("hand", arm, arms), box=_box(held)))
        for box in self._boxes:
            if box not in holders.values():
                yield from _away(box, _pose(plant, box))
        for arm in arms:
            if np.abs(arm.posture - arm.robot.HOME).max() > POSTURE:
                yield Displacement(Reason.of("workcell.arm_away", arm=_named("arm", arm, arms)), is_harmless=True)

    def held(self, plant: Plant, side: str) -> AssemblyBox | None:
        """The box between the jaws of the hand at a side that is closed on it."""
        hand = f"gripper_{side}"
        fingers, _ = plant.joints([f"{hand}.finger1", f"{hand}.finger2"])
        signal = plant.data.ctrl[plant.signals([f"{hand}.valve1"])]
        opening = float(plant.data.qpos[fingers].mean())
        if signal[0] > 0.0 or abs(opening - (SIZE_M[0] - CLOSED_M) / 2) > _PRESSED_M:
            return None
        tip = inverse_pose(_tip(plant, hand))
        return next((box for box in self._boxes if _is_between(tip @ _pose(plant, box))), None)


def _named(kind: str, arm: ArmUnit, arms: Sequence[ArmUnit]) -> Reason:
    """What an arm, or its hand, is called; where there are two the name says which."""
    return Thing(kind, arm.side).text(is_alone=len(arms) == 1)


def _box(box: AssemblyBox) -> Reason:
    return Thing("box", box.sign).text(is_alone=True)


def _away(box: AssemblyBox, pose: Array) -> Iterator[Displacement]:
    """How far a box is from its place; or that it is turned there."""
    away = float(np.linalg.norm(pose[:3, 3] - (box.x, box.y, box.z + _HIGH)))
    if away > NEAR_M:
        yield Displacement(Reason.of("workcell.box_away", box=_box(box), cm=100 * away))
    elif min(pose[0, 0], pose[2, 2]) < math.cos(TURNED_RAD):
        yield Displacement(Reason.of("workcell.box_turned", box=_box(box)))


def _pose(plant: Plant, box: AssemblyBox) -> Array:
    row, pose = plant.data.joint(box.name).qpos, np.eye(4)
    pose[:3, 3], pose[:3, :3] = row[:3], rotation_of_quaternion(row[3:])
    return pose


def _tip(plant: Plant, hand: str) -> Array:
    body, pose = plant.body(f"{hand}.hand"), np.eye(4)
    pose[:3, 3], pose[:3, :3] = plant.data.xpos[body], plant.data.xmat[body].reshape(3, 3)
    tip: Array = pose @ puma560.TOOL
    return tip


def _is_between(pose: Array) -> bool:
    return all(abs(pose[k, 3]) <= JAWS_M[k] for k in range(3))
