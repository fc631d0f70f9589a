"""What can touch in a world that is files: arms, their hands, parts, the floor; and the shapes that belong to each."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from onika.model.world import Names, PlaceBlock, WorldText
from onika.words.reason import NOTHING, Reason
from onika.words.sentence import LANGUAGES
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
    text: Reason = field(default=NOTHING, compare=False)
    """What it is called."""

    @property
    def moves(self) -> bool:
        """Whether a program moves it."""
        return self.kind in (ARM, HAND)


def called(names: Names, otherwise: Reason) -> Reason:
    """What people call something in each language; in one in which it has no name, by that of another."""
    if not names:
        return otherwise
    given = dict(names)
    texts = {language: given.get(language, names[0][1]) for language in LANGUAGES}
    return Reason.of("workcell.called", en=texts["en"], es=texts["es"])


def called_part(world: WorldText, name: str) -> Reason:
    """What a part is called."""
    names = next((part.names for part in world.parts if part.name == name), ())
    return called(names, Reason.of("workcell.named_part", part=name))


def called_arm(world: WorldText, unit: JointUnit, *, is_alone: bool) -> Reason:
    """What an arm is called: as its place says, without which one it is where there is no other; else its device."""
    names = _place(world, unit.side).names
    if names and is_alone:
        return Reason.of("workcell.the_arm")
    return called(names, Reason.of("workcell.named_robot", name=unit.sheet.name))


def called_hand(world: WorldText, unit: JointUnit, *, is_alone: bool) -> Reason:
    """What the hand of an arm is called."""
    place = _place(world, unit.side)
    if place.hand_names and is_alone:
        return Reason.of("workcell.the_hand")
    arm = called(place.names, Reason.of("workcell.named_robot", name=unit.sheet.name))
    return called(place.hand_names, Reason.of("workcell.hand_of", arm=arm))


def contact_of(who: CellThing, what: CellThing) -> Reason:
    """What is said of an arm, a hand or a part that touches something; the foot of an arm is the arm itself."""
    if who == what or who.text == what.text:
        return Reason.of("workcell.meets_itself", who=who.text)
    return Reason.of("workcell.meets" if what.moves else "workcell.touches", who=who.text, what=what.text)


def things_of(model: Any, world: WorldText, arms: Mapping[JointUnit, bool]) -> Iterator[CellThing]:
    """What each shape belongs to; with each arm, whether its robot has a hand."""
    of_body: dict[int, CellThing] = {}
    is_alone = len(arms) == 1
    standing = {unit.prefix: called_arm(world, unit, is_alone=is_alone) for unit in arms if unit.prefix}
    for unit, has_gripper in arms.items():
        bodies = [int(model.jnt_bodyid[model.joint(name).id]) for name in unit.joint_names]
        device = unit.sheet.name
        arm = CellThing(ARM, unit.side, device, called_arm(world, unit, is_alone=is_alone))
        hand = CellThing(HAND, unit.side, device, called_hand(world, unit, is_alone=is_alone)) if has_gripper else arm
        of_body |= dict.fromkeys(_carried(model, bodies[0]), arm)
        of_body |= dict.fromkeys(_carried(model, bodies[-1]), hand)
    for shape in range(model.ngeom):
        body = int(model.geom_bodyid[shape])
        if body in of_body:
            yield of_body[body]
        elif model.geom(shape).name == "floor":
            yield CellThing(FLOOR, text=Reason.of("workcell.the_floor"))
        else:
            yield _part(world, model.body(body).name if body else model.geom(shape).name, standing)


def rank(thing: CellThing) -> tuple[int, CellThing]:
    """What is named first of two that touch: a hand, an arm, a part."""
    return (HAND, ARM, FREE, FIXED, FLOOR).index(thing.kind), thing


def _place(world: WorldText, name: str) -> PlaceBlock:
    return next(place for place in world.places if place.name == name)


def _part(world: WorldText, name: str, standing: Mapping[str, Reason]) -> CellThing:
    """The part that a body, or a shape without one, belongs to by its name; or the foot of an arm."""
    for prefix, text in standing.items():
        if name.startswith(prefix):
            return CellThing(FIXED, prefix, text=text)
    for part in world.parts:
        prefix = prefix_of(part.name)
        if prefix and name.startswith(prefix):
            text = called_part(world, part.name)
            return CellThing(FIXED if part.free is None else FREE, part.name, text=text)
    return CellThing(FIXED, text=Reason.of("workcell.surroundings"))


def _carried(model: Any, first: int) -> list[int]:
    """A body and all that it carries."""
    carried = {first}
    for body in range(first + 1, model.nbody):  # whoever carries stands before
        if int(model.body_parentid[body]) in carried:
            carried.add(body)
    return sorted(carried)
