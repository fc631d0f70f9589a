"""A lookout over a world that is files: arms that touch what no program means them to, parts that fall (E16, X19).

The hand of an arm with a gripper may touch whatever moves freely; it takes it. Whatever else an arm or its hand touches
is a mishap, and so is a part that comes to lie on the floor while no hand has it. What a file's arm does to itself is
not looked at, for the shapes of many models reach into each other.
"""

from collections.abc import Callable, Mapping

import mujoco
import numpy as np

from onika.model.world import WorldText
from onika.ring.device import MishapEvent
from onika.words.reason import Reason
from onika.workcell.cell.cell_thing import FLOOR, FREE, HAND, CellThing, rank, things_of
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.contacts import DEEP_M
from onika.workcell.lookout import MOST, Advance, with_looks
from onika.workcell.plant import Plant

_AGAIN_NS = 500_000_000  # how long two things were apart that meet anew

Pair = tuple[CellThing, CellThing]


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
        things = [*things_of(plant.model, self._world, arms)]
        self._kinds = list(dict.fromkeys(things))
        self._of_shape = np.array([self._kinds.index(thing) for thing in things], dtype=int)
        self._matters = np.array([[_matters(one, other) for other in self._kinds] for one in self._kinds])
        self._look(now(), is_first=True)
        return with_looks(advance, self._look, now)

    def take(self) -> list[MishapEvent]:
        """What has happened since the last call, in the order in which it was understood."""
        mishaps, self._mishaps = self._mishaps, []
        return mishaps

    def _look(self, now_ns: int, *, is_first: bool = False) -> None:
        if not self._has_forces:
            mujoco.mj_collision(self._plant.model, self._plant.data)
        pairs = self._touching()
        in_hand = {other for one, other in pairs if one.kind == HAND and other.kind == FREE}
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
        pair = sorted((self._kinds[first], self._kinds[other]), key=rank)
        return pair[0], pair[1]

    def _judge(self, pair: Pair, in_hand: set[CellThing], now_ns: int) -> None:
        one, other = pair
        if one.moves and other.moves:
            self._note("workcell.meets", pair, now_ns)
        elif one.moves and (one.kind, other.kind) != (HAND, FREE):
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


def _matters(one: CellThing, other: CellThing) -> bool:
    """Whether their contacts are looked at: not those of one robot with itself, nor of parts that lie about."""
    if one.moves or other.moves:
        return not (one.moves and other.moves and one.name == other.name)
    return {one.kind, other.kind} == {FREE, FLOOR}
