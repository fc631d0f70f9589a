"""Which robot stands at each place of a world, and whether it has forces; follows from what is claimed (law 18)."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from onika.words.reason import Reason
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.robot_unit import EITHER, FORCELESS, RobotUnit


class Stands:
    """The robots of each place, of which one stands there; the first does until a device of another one is claimed."""

    def __init__(self, robots: Mapping[str, Sequence[str]], units: Sequence[RobotUnit]) -> None:
        self.units = tuple(units)
        self.acting = {place: names[0] for place, names in robots.items()}
        self.mode = ""

    def present(self) -> list[RobotUnit]:
        """The devices of the robots that stand there, in the mode of the world."""
        return [
            unit for unit in self.units if self.acting[unit.side] == unit.robot and unit.mode in (EITHER, self.mode)
        ]

    def arms(self) -> dict[JointUnit, bool]:
        """The arms that stand there, each with whether its robot has a hand as well."""
        present = self.present()
        joints = [unit for unit in present if isinstance(unit, JointUnit)]
        handed = {unit.side for unit in present if isinstance(unit, FingerUnit)}
        handed |= {unit.side for unit in joints if not unit.facts.start}
        return {unit: unit.side in handed for unit in joints if unit.facts.start}

    def objections(self, devices: Sequence[str]) -> Iterator[Reason]:
        """Why these devices cannot be used together: two robots at one place, or two modes."""
        wanted = [unit for unit in self.units if unit.sheet.name in devices]
        for first, other in combinations(wanted, 2):
            if first.side == other.side and first.robot != other.robot:
                yield Reason.of("workcell.one_place", first=first.sheet.name, other=other.sheet.name)
            elif not _agree(first.mode, other.mode):
                yield Reason.of(
                    "workcell.modes_unlike",
                    first=first.sheet.name,
                    mode=_called(first),
                    other=other.sheet.name,
                    other_mode=_called(other),
                )

    def admit(self, unit: RobotUnit) -> bool:
        """Let this device act; whether anything changed. Raises ValueError where one in use stands against it."""
        for other in self.units:
            if other is unit or other.epoch is None:
                continue
            device, in_use = unit.sheet.name, other.sheet.name
            if other.side == unit.side and other.robot != unit.robot:
                raise ValueError(Reason.of("workcell.place_taken", device=device, other=in_use))
            if not _agree(unit.mode, other.mode):
                mode, other_mode = _called(unit), _called(other)
                raise ValueError(
                    Reason.of("workcell.mode_in_use", device=device, mode=mode, other=in_use, other_mode=other_mode)
                )
        wanted = self.mode if unit.mode == EITHER else unit.mode
        if self.acting[unit.side] == unit.robot and wanted == self.mode:
            return False
        self.acting[unit.side], self.mode = unit.robot, wanted
        return True


def _agree(mode: str, other: str) -> bool:
    return mode == other or EITHER in (mode, other)


def _called(unit: RobotUnit) -> Reason:
    return Reason.of("workcell.kinematic") if unit.mode == FORCELESS else Reason.of("workcell.physical")
