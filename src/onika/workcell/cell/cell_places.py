"""What stands where in a world from files at the start, and what is elsewhere now, in words (law 18)."""

from collections.abc import Iterator, Mapping, Sequence

from onika.laws.frames import Array
from onika.model.world import WorldText
from onika.ring.displacement import Displacement
from onika.words.reason import Reason
from onika.workcell.cell.cell_hands import CellHands
from onika.workcell.cell.cell_thing import called_arm, called_hand, called_part
from onika.workcell.composed import part_places
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.robot_unit import RobotUnit
from onika.workcell.gripping.forceless import Forceless
from onika.workcell.plant import Plant
from onika.workcell.unit import DeviceUnit


class CellPlaces:
    """The places of one plant, in which these arms stand."""

    def __init__(self, world: WorldText, plant: Plant, arms: Mapping[JointUnit, bool]) -> None:
        self._world, self._plant = world, plant
        is_alone = len(arms) == 1
        self._arms = {unit: called_arm(world, unit, is_alone=is_alone) for unit in arms}
        self._hands = {unit: called_hand(world, unit, is_alone=is_alone) for unit in arms}

    def places(self, start: Array) -> Iterator[Reason]:
        """What stands where at the start."""
        yield from part_places.places(self._world.parts, self._plant, start, self._called)
        for called in self._arms.values():
            yield Reason.of("workcell.arm_place", arm=called)

    def displaced(
        self, hands: CellHands, forceless: Forceless | None, present: Sequence[DeviceUnit]
    ) -> Iterator[Displacement]:
        """What does not stand there now: what hands hold first, then parts, then robots, which may be anywhere."""
        found = {unit: hands.held(unit, forceless) for unit in self._arms}
        held = {unit: part for unit, part in found.items() if part is not None}
        for unit, part in held.items():
            text = Reason.of("workcell.hand_holds", hand=self._hands[unit], box=self._called(part))
            yield Displacement(text)
        yield from part_places.displaced(self._world.parts, self._plant, self._called, [*held.values()])
        for robot in present:
            if isinstance(robot, RobotUnit) and robot.is_away:
                yield Displacement(self._away(robot), is_harmless=True)

    def _away(self, robot: RobotUnit) -> Reason:
        if isinstance(robot, JointUnit) and robot in self._arms:
            return Reason.of("workcell.arm_away", arm=self._arms[robot])
        return robot.away

    def _called(self, part: str) -> Reason:
        return called_part(self._world, part)
