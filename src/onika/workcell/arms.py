"""The arms of the workcell: which one stands at each side of the table, and whether the world has forces.

At a side stands one arm: of the kind, and in the mode, of the device that was claimed there last. All arms of a world
are in one mode (law 18). Whoever asks for another arm than the one in use there, or for the other mode, is refused.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from onika.words.reason import Reason
from onika.workcell.arm_unit import ArmUnit
from onika.workcell.kinematic_unit import KinematicUnit
from onika.workcell.layout import KINDS, SIDES, STANDARD, base
from onika.workcell.unit import DeviceUnit


class Arms:
    """All arms there can be; `acting` is the one at each side, even before the side is in the world."""

    def __init__(self) -> None:
        self.units = tuple(
            make(side, base(side), kind) for side in SIDES for kind in KINDS for make in (ArmUnit, KinematicUnit)
        )
        self.acting: dict[str, ArmUnit] = {side: self._find(side, STANDARD, "") for side in SIDES}
        for unit in self.units:
            unit.drive = self.acting[unit.side].drive  # the cabinet at a side is one, whatever arm is plugged in

    @property
    def kinematic(self) -> bool:
        """Whether the world is without forces."""
        return any(unit.mode for unit in self.acting.values())

    def __iter__(self) -> Iterator[ArmUnit]:
        """The acting arms."""
        return iter(self.acting.values())

    def moving(self, sides: tuple[str, ...]) -> tuple[KinematicUnit, ...]:
        """The acting arms of these sides that are moved without forces."""
        acting = (self.acting[side] for side in sides)
        return tuple(unit for unit in acting if isinstance(unit, KinematicUnit))

    def kinds(self) -> Mapping[str, str]:
        """The kind of arm at each side."""
        return {side: unit.kind for side, unit in self.acting.items()}

    def objections(self, devices: Sequence[str]) -> Iterator[Reason]:
        """Why arms of these devices cannot be used together: two at one side, or two modes (law 18)."""
        wanted = [unit for unit in self.units if unit.sheet.name in devices]
        for first, other in combinations(wanted, 2):
            if first.side == other.side:
                yield Reason.of("workcell.one_place", first=first.sheet.name, other=other.sheet.name)
            elif first.mode != other.mode:
                yield Reason.of(
                    "workcell.modes_unlike",
                    first=first.sheet.name,
                    mode=_mode(first),
                    other=other.sheet.name,
                    other_mode=_mode(other),
                )

    def remarks(self, devices: Sequence[str], hands: Sequence[DeviceUnit]) -> Iterator[Reason]:
        """Hands of which none is borne by an arm of these devices."""
        arms = [unit for unit in self.units if unit.sheet.name in devices]
        if arms and not {unit.side for unit in arms} & {unit.side for unit in hands}:
            names = tuple(unit.sheet.name for unit in arms)
            for hand in hands:
                side = Reason.of("workcell.left") if hand.side == "left" else Reason.of("workcell.right")
                yield Reason.of("workcell.hand_apart", hand=hand.sheet.name, side=side, arms=names)

    def admit(self, unit: ArmUnit) -> bool:
        """Let this arm act; whether anything changed by that. Raises ValueError where one in use stands against it."""
        for other in self:
            if other is unit or other.epoch is None:
                continue
            if other.side == unit.side:
                raise ValueError(Reason.of("workcell.place_taken", device=unit.sheet.name, other=other.sheet.name))
            if other.mode != unit.mode:
                raise ValueError(
                    Reason.of(
                        "workcell.mode_in_use",
                        device=unit.sheet.name,
                        mode=_mode(unit),
                        other=other.sheet.name,
                        other_mode=_mode(other),
                    )
                )
        if self.acting[unit.side] is unit:
            return False
        self.acting[unit.side] = unit
        for side, other in self.acting.items():
            self.acting[side] = self._find(side, other.kind, unit.mode)
        for arm in self:
            arm.state[1] = arm.drive.shown
        return True

    def _find(self, side: str, kind: str, mode: str) -> ArmUnit:
        return next(unit for unit in self.units if (unit.side, unit.kind, unit.mode) == (side, kind, mode))


def _mode(unit: ArmUnit) -> Reason:
    return Reason.of("workcell.kinematic") if unit.mode else Reason.of("workcell.physical")
