"""What can touch in a world that is files: arms, their hands, parts, the floor; and the shapes that belong to each."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from onika.model.world import WorldText
from onika.words.reason import Reason
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.usable_parts import prefix_of

ARM, HAND, FREE, FIXED, FLOOR = "arm", "hand", "free", "fixed", "floor"


@dataclass(frozen=True, slots=True, order=True)
class CellThing:
    """What can touch: an arm or its hand by its place, a part by its name, the floor, and all that has no name."""

    kind: str
    name: str = ""
    arm: str = ""
    """The device of the arm."""

    @property
    def moves(self) -> bool:
        """Whether a program moves it."""
        return self.kind in (ARM, HAND)

    @property
    def text(self) -> Reason:
        """What it is called."""
        if self.kind == ARM:
            return Reason.of("workcell.named_robot", name=self.arm)
        if self.kind == HAND:
            return Reason.of("workcell.hand_of", arm=self.arm)
        if self.kind == FLOOR:
            return Reason.of("workcell.the_floor")
        return Reason.of("workcell.named_part", part=self.name) if self.name else Reason.of("workcell.surroundings")


def things_of(model: Any, world: WorldText, arms: Mapping[JointUnit, bool]) -> Iterator[CellThing]:
    """What each shape belongs to; with each arm, whether its robot has a hand."""
    of_body: dict[int, CellThing] = {}
    for unit, has_gripper in arms.items():
        bodies = [int(model.jnt_bodyid[model.joint(name).id]) for name in unit.joint_names]
        hand = CellThing(HAND if has_gripper else ARM, unit.side, unit.sheet.name)
        of_body |= dict.fromkeys(_carried(model, bodies[0]), CellThing(ARM, unit.side, unit.sheet.name))
        of_body |= dict.fromkeys(_carried(model, bodies[-1]), hand)
    for shape in range(model.ngeom):
        body = int(model.geom_bodyid[shape])
        if body in of_body:
            yield of_body[body]
        elif model.geom(shape).name == "floor":
            yield CellThing(FLOOR)
        else:
            yield _part(world, model.body(body).name if body else model.geom(shape).name)


def rank(thing: CellThing) -> tuple[int, CellThing]:
    """What is named first of two that touch: a hand, an arm, a part."""
    return (HAND, ARM, FREE, FIXED, FLOOR).index(thing.kind), thing


def _part(world: WorldText, name: str) -> CellThing:
    """The part that a body, or a shape without one, belongs to by its name."""
    for part in world.parts:
        prefix = prefix_of(part.name)
        if prefix and name.startswith(prefix):
            return CellThing(FIXED if part.free is None else FREE, part.name)
    return CellThing(FIXED)


def _carried(model: Any, first: int) -> list[int]:
    """A body and all that it carries."""
    carried = {first}
    for body in range(first + 1, model.nbody):  # whoever carries stands before
        if int(model.body_parentid[body]) in carried:
            carried.add(body)
    return sorted(carried)
