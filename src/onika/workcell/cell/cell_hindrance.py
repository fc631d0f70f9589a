"""What is in the way of an arm of a file when its drive begins to hold, and where its tool stands, in words."""

from collections.abc import Mapping

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.model.world import WorldText
from onika.words.reason import Reason
from onika.workcell.cell.cell_contacts import DEEP_M
from onika.workcell.cell.cell_thing import FREE, HAND, CellThing, called_arm, called_hand, contact_of, rank, things_of
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.gripping.tool_frame import ToolFrame
from onika.workcell.plant import Plant

PRESSED_N = 5.0
"""How hard two things press on each other of which one is in the other's way; what lies there presses less."""


class CellHindrance:
    """The contacts of one plant, looked at when somebody asks.

    arms        those that stand there, each with whether its robot has a hand
    has_forces  whether things press on each other there; else they reach into each other
    """

    def __init__(self, plant: Plant, world: WorldText, arms: Mapping[JointUnit, bool], *, has_forces: bool) -> None:
        self._plant, self._world, self._arms, self._has_forces = plant, world, arms, has_forces
        self._things = [*things_of(plant.model, world, arms)]

    def told(self, unit: JointUnit, held: str | None = None) -> tuple[Reason, ...]:
        """What an arm, its hand, or the part in that (by its name), presses against, be it the arm itself."""
        forces: dict[tuple[CellThing, CellThing], float] = {}
        if not self._has_forces:
            mujoco.mj_collision(self._plant.model, self._plant.data)
        contact = self._plant.data.contact
        for at, (first, second) in enumerate(contact.geom.tolist()):
            pair = (self._things[first], self._things[second])
            is_own = [_is_own(thing, unit.side, held) for thing in pair]
            is_met = any(is_own) and (not all(is_own) or self._is_in_its_own_way(*pair))
            if is_met and (self._has_forces or contact.dist[at] < -DEEP_M):
                who, what = pair if is_own[0] else pair[::-1]
                who, what = (max(pair, key=rank),) * 2 if all(is_own) else (who, what)
                forces[who, what] = forces.get((who, what), 0.0) + self._force(at)
        felt = (pair for pair, force in forces.items() if force >= PRESSED_N or not self._has_forces)
        return tuple(self._text(unit, *pair) for pair in sorted(felt, key=lambda pair: (rank(pair[0]), rank(pair[1]))))

    def place(self, unit: JointUnit) -> Reason:
        """Where the point of its tool is."""
        x, y, z = (float(metres) * 100.0 for metres in ToolFrame(self._plant, unit).pose()[:3, 3])
        called = called_hand if self._arms[unit] and self._has_hand_name(unit) else called_arm
        who = called(self._world, unit, is_alone=len(self._arms) == 1)
        return Reason.of("workcell.stands_at", who=who, x=x, y=y, z=z)

    def _is_in_its_own_way(self, one: CellThing, other: CellThing) -> bool:
        """Whether an arm stops itself there: neighbours reach into each other in many models, without any force."""
        is_meant = FREE in (one.kind, other.kind) or one.kind == other.kind == HAND
        return self._has_forces and not is_meant

    def _has_hand_name(self, unit: JointUnit) -> bool:
        return any(place.name == unit.side and place.hand_names for place in self._world.places)

    def _force(self, at: int) -> float:
        force: Array = np.zeros(6)
        mujoco.mj_contactForce(self._plant.model, self._plant.data, at, force)
        return abs(float(force[0]))

    def _text(self, unit: JointUnit, who: CellThing, what: CellThing) -> Reason:
        if who.kind == FREE:
            hand = called_hand(self._world, unit, is_alone=len(self._arms) == 1)
            return Reason.of("workcell.carried_touches", what=who.text, hand=hand, other=what.text)
        return contact_of(who, what)


def _is_own(thing: CellThing, place: str, held: str | None) -> bool:
    if thing.kind == FREE:
        return thing.name == held
    return thing.moves and thing.name == place
