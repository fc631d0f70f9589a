"""Which robot stands at each place of a world, and whether it has forces; follows from what is claimed (law 18)."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from onika.words.reason import Reason
from onika.workcell.composed.base_unit import BaseUnit
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.robot_unit import ANY, EITHER, FORCELESS, RobotUnit


class Stands:
    """The robots of each place, of which one stands there; the first does until a device of another one is claimed.

    `standing` says who stands at each place at first, nobody where it is empty; `robots` who may. The drives of a place
    are those of its cabinet, whatever robot is plugged in: its first arm has the same one as the first of another.
    """

    def __init__(
        self, robots: Mapping[str, Sequence[str]], standing: Mapping[str, str], units: Sequence[RobotUnit]
    ) -> None:
        self.units = tuple(units)
        self.acting = dict(standing)
        self.mode = ""
        self._firsts = {place: names[0] for place, names in robots.items()}
        self._cabinet = _cabinet(self.units)

    def drives(self) -> list[RobotUnit]:
        """For each drive the device that it drives now, or else would."""
        present = set(self.present())
        return [next((unit for unit in row if unit in present), row[0]) for row in self._cabinet]

    def present(self) -> list[RobotUnit]:
        """The devices of the robots that stand there, in the mode of the world."""
        return [
            unit
            for unit in self.units
            if self.acting[unit.side] and _is_of(unit, self.acting[unit.side]) and unit.mode in (EITHER, self.mode)
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
            if first.side == other.side and not _is_of(first, other.robot):
                yield Reason.of("workcell.one_place", first=first.sheet.name, other=other.sheet.name)
            elif not _agree(first.mode, other.mode):
                yield Reason.of(
                    "workcell.modes_unlike",
                    first=first.sheet.name,
                    mode=_called(first),
                    other=other.sheet.name,
                    other_mode=_called(other),
                )

    def remarks(self, devices: Sequence[str]) -> Iterator[Reason]:
        """Hands of which none is borne by an arm of these devices, which is odd in one flow and forbids nothing."""
        wanted = [unit for unit in self.units if unit.sheet.name in devices]
        arms = [unit for unit in wanted if isinstance(unit, JointUnit) and unit.facts.start]
        hands = [unit for unit in wanted if isinstance(unit, FingerUnit)]
        if arms and not {unit.side for unit in arms} & {unit.side for unit in hands}:
            names = tuple(unit.sheet.name for unit in arms)
            for hand in hands:
                side = Reason.plain(hand.side)
                yield Reason.of("workcell.hand_apart", hand=hand.sheet.name, side=side, arms=names)

    def with_device(self, unit: RobotUnit) -> dict[str, str]:
        """Who would stand at each place while this device acts."""
        robot = unit.robot or self.acting[unit.side] or self._firsts[unit.side]
        return {**self.acting, unit.side: robot}

    def admit(self, unit: RobotUnit) -> bool:
        """Let this device act; whether anything changed. Raises ValueError where one in use stands against it."""
        for other in self.units:
            if other is unit or other.epoch is None:
                continue
            device, in_use = unit.sheet.name, other.sheet.name
            if other.side == unit.side and not _is_of(unit, other.robot):
                raise ValueError(Reason.of("workcell.place_taken", device=device, other=in_use))
            if not _agree(unit.mode, other.mode):
                mode, other_mode = _called(unit), _called(other)
                raise ValueError(
                    Reason.of("workcell.mode_in_use", device=device, mode=mode, other=in_use, other_mode=other_mode)
                )
        wanted = self.mode if unit.mode == EITHER else unit.mode
        acting = self.with_device(unit)
        if acting == self.acting and wanted == self.mode:
            return False
        self.acting, self.mode = acting, wanted
        for newcomer in self.present():
            if newcomer.count:
                newcomer.state[1] = newcomer.drive.shown
        return True


def _cabinet(units: Sequence[RobotUnit]) -> list[list[RobotUnit]]:
    """The devices in rows: those of a row stand at one place, never at once, and get one drive."""
    rows: dict[tuple[object, ...], list[RobotUnit]] = {}
    seen: dict[tuple[object, ...], int] = {}
    for unit in units:
        family = next((kind for kind in (BaseUnit, FingerUnit) if isinstance(unit, kind)), RobotUnit)
        is_arm = isinstance(unit, JointUnit) and bool(unit.facts.start)
        of_robot = (unit.side, family, is_arm, unit.robot, unit.mode)
        number = seen[of_robot] = seen.get(of_robot, -1) + 1
        is_alone = not unit.count
        row = rows.setdefault((unit.sheet.name,) if is_alone else (unit.side, family, is_arm, number), [])
        row.append(unit)
        unit.drive = row[0].drive
    return [*rows.values()]


def _is_of(unit: RobotUnit, robot: str) -> bool:
    """Whether a device is there when this robot is."""
    return robot == ANY or unit.robot in (ANY, robot)


def _agree(mode: str, other: str) -> bool:
    return mode == other or EITHER in (mode, other)


def _called(unit: RobotUnit) -> Reason:
    return Reason.of("workcell.kinematic") if unit.mode == FORCELESS else Reason.of("workcell.physical")
