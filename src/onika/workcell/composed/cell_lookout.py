"""A lookout over a world that is files: arms that touch what no program means them to, parts that fall (E16, X19).

The hand of an arm with a gripper may touch whatever moves freely; it takes it. Whatever else an arm or its hand touches
is a mishap, and so is a part that comes to lie on the floor while no hand has it. What a file's arm does to itself is
not looked at, for the shapes of many models reach into each other.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.model.world import WorldText
from onika.ring.device import MishapEvent
from onika.words.reason import Reason
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.usable_parts import prefix_of
from onika.workcell.contacts import DEEP_M
from onika.workcell.lookout import MOST, Advance
from onika.workcell.plant import Plant

_EVERY_NS = 8_000_000  # how often it looks: what touches something is not gone again sooner
_AGAIN_NS = 500_000_000  # how long two things were apart that meet anew

_ARM, _HAND, _FREE, _FIXED, _FLOOR = "arm", "hand", "free", "fixed", "floor"


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
        return self.kind in (_ARM, _HAND)

    @property
    def text(self) -> Reason:
        """What it is called."""
        if self.kind == _ARM:
            return Reason.of("workcell.named_robot", name=self.arm)
        if self.kind == _HAND:
            return Reason.of("workcell.hand_of", arm=self.arm)
        if self.kind == _FLOOR:
            return Reason.of("workcell.the_floor")
        return Reason.of("workcell.named_part", part=self.name) if self.name else Reason.of("workcell.surroundings")


Pair = tuple[CellThing, CellThing]

_SURROUNDINGS = CellThing(_FIXED)


class CellLookout:
    """Watches one world, compiled as often as it is.

    devices_of  the devices at a place that are in use
    lit         the shapes that shine just now
    """

    def __init__(
        self, world: WorldText, devices_of: Callable[[str], tuple[str, ...]], lit: Callable[[], tuple[str, ...]]
    ) -> None:
        self._world = world
        self._devices_of = devices_of
        self._lit = lit
        self._told = 0
        self._mishaps: list[MishapEvent] = []
        self._felt: dict[Pair, int] = {}
        """When two things that touch, or did, were felt last."""

    def watch(
        self,
        plant: Plant,
        arms: Mapping[JointUnit, bool],
        advance: Advance,
        now: Callable[[], int],
        *,
        has_forces: bool,
    ) -> Advance:
        """Look at this plant again and again from now on; gives what makes a step and looks.

        arms        those that stand there, each with whether its robot has a gripper
        has_forces  whether things press on each other there; else they reach into each other
        """
        self._plant, self._has_forces = plant, has_forces
        things = [*_things(plant.model, self._world, arms)]
        self._kinds = list(dict.fromkeys(things))
        self._of_shape = np.array([self._kinds.index(thing) for thing in things], dtype=int)
        self._matters = np.array([[_matters(one, other) for other in self._kinds] for one in self._kinds])
        self._look(now(), is_first=True)
        due_ns = now() + _EVERY_NS

        def step(model: Any, data: Any) -> None:
            nonlocal due_ns
            advance(model, data)
            now_ns = now()
            if now_ns >= due_ns:
                due_ns = now_ns + _EVERY_NS
                self._look(now_ns)

        return step

    def take(self) -> list[MishapEvent]:
        """What has happened since the last call, in the order in which it was understood."""
        mishaps, self._mishaps = self._mishaps, []
        return mishaps

    def _look(self, now_ns: int, *, is_first: bool = False) -> None:
        if not self._has_forces:
            mujoco.mj_collision(self._plant.model, self._plant.data)
        pairs = self._touching()
        in_hand = {other for one, other in pairs if one.kind == _HAND and other.kind == _FREE}
        for pair in sorted(pairs):
            is_new = now_ns - self._felt.get(pair, -_AGAIN_NS) >= _AGAIN_NS
            self._felt[pair] = now_ns
            if is_new and not is_first:
                self._judge(pair, in_hand, now_ns)

    def _touching(self) -> set[Pair]:
        contact = self._plant.data.contact
        things = self._of_shape[contact.geom]
        counts = self._matters[things[:, 0], things[:, 1]]
        if not self._has_forces:
            counts = counts & (contact.dist < -DEEP_M)
        return {self._ordered(*pair) for pair in things[counts].tolist()}

    def _ordered(self, first: int, other: int) -> Pair:
        """An arm or a hand first, then a part."""
        pair = sorted((self._kinds[first], self._kinds[other]), key=_rank)
        return pair[0], pair[1]

    def _judge(self, pair: Pair, in_hand: set[CellThing], now_ns: int) -> None:
        one, other = pair
        if one.moves and other.moves:
            self._note("workcell.meets", pair, now_ns)
        elif one.moves and (one.kind, other.kind) != (_HAND, _FREE):
            self._note("workcell.touches", pair, now_ns)
        elif not one.moves and one not in in_hand:
            self._note("workcell.falls", pair, now_ns)

    def _note(self, key: str, pair: Pair, at_ns: int) -> None:
        if self._told >= MOST:
            return
        self._told += 1
        one, other = pair
        called = {"what": one.text} if key == "workcell.falls" else {"who": one.text, "what": other.text}
        places = dict.fromkeys(thing.name for thing in pair if thing.moves)
        devices = tuple(device for place in places for device in self._devices_of(place))
        poses = self._plant.poses().tobytes()
        self._mishaps.append(MishapEvent(Reason.of(key, **called), at_ns, devices, poses, self._lit()))


def _rank(thing: CellThing) -> tuple[int, CellThing]:
    return (_HAND, _ARM, _FREE, _FIXED, _FLOOR).index(thing.kind), thing


def _matters(one: CellThing, other: CellThing) -> bool:
    """Whether their contacts are looked at: not those of one robot with itself, nor of parts that lie about."""
    if one.moves or other.moves:
        return not (one.moves and other.moves and one.name == other.name)
    return {one.kind, other.kind} == {_FREE, _FLOOR}


def _things(model: Any, world: WorldText, arms: Mapping[JointUnit, bool]) -> Iterable[CellThing]:
    """What each shape belongs to."""
    of_body: dict[int, CellThing] = {}
    for unit, has_gripper in arms.items():
        bodies = [int(model.jnt_bodyid[model.joint(name).id]) for name in unit.joint_names]
        hand = CellThing(_HAND if has_gripper else _ARM, unit.side, unit.sheet.name)
        of_body |= dict.fromkeys(_carried(model, bodies[0]), CellThing(_ARM, unit.side, unit.sheet.name))
        of_body |= dict.fromkeys(_carried(model, bodies[-1]), hand)
    for shape in range(model.ngeom):
        body = int(model.geom_bodyid[shape])
        if body in of_body:
            yield of_body[body]
        elif model.geom(shape).name == "floor":
            yield CellThing(_FLOOR)
        else:
            yield _part(world, model.body(body).name if body else model.geom(shape).name)


def _part(world: WorldText, name: str) -> CellThing:
    """The part that a body, or a shape without one, belongs to by its name."""
    for part in world.parts:
        prefix = prefix_of(part.name)
        if prefix and name.startswith(prefix):
            return CellThing(_FIXED if part.free is None else _FREE, part.name)
    return _SURROUNDINGS


def _carried(model: Any, first: int) -> list[int]:
    """A body and all that it carries."""
    carried = {first}
    for body in range(first + 1, model.nbody):  # whoever carries stands before
        if int(model.body_parentid[body]) in carried:
            carried.add(body)
    return sorted(carried)
