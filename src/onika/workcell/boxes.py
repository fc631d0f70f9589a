"""The world of the box assembly: four boxes on a table, up to two arms, and a lamp that lights by touch (§6.2)."""

from collections.abc import Callable, Sequence
from typing import Any

import mujoco
from mujoco import mj_step

from onika.ring.device import MishapEvent
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveInput
from onika.words.reason import Reason
from onika.workcell import layout
from onika.workcell.arm_unit import ArmUnit
from onika.workcell.arms import Arms
from onika.workcell.driven_world import DrivenWorld
from onika.workcell.gripper_unit import GripperUnit
from onika.workcell.hindrance import Hindrance
from onika.workcell.kinematics import Kinematics
from onika.workcell.lamp_unit import LampUnit
from onika.workcell.layout import SIDES
from onika.workcell.lookout import Lookout
from onika.workcell.panic_button import PanicButton
from onika.workcell.part import STEP_S
from onika.workcell.plant import Plant
from onika.workcell.scene import Shape3d, shapes
from onika.workcell.snapshot import WorldSnapshot, encode
from onika.workcell.start_places import StartPlaces
from onika.workcell.unit import DeviceUnit


class BoxesWorld(DrivenWorld):
    """A world in steps of 2 ms of its own time; devices are claimed, commanded and read by name.

    `offsets_m` moves each box by up to plus or minus that much on x and y, drawn from `seed`. An arm is part of the
    world from the first claim of it or of its gripper on. Which kind stands there, and whether the world has forces or
    is in the kinematic mode, follows from the arms that are claimed: `arm_left`, `arm_left_kin`, `scara_left` ...
    """

    step_ns = round(STEP_S * 1e9)

    def __init__(self, seed: int = 0, offsets_m: float = 0.0) -> None:
        self._boxes = layout.boxes(seed, offsets_m)
        self._start_places = StartPlaces(self._boxes)
        self._lamp = LampUnit()
        self._arms = Arms()
        self._hands = {side: GripperUnit(side) for side in SIDES}
        everything: list[DeviceUnit] = [*self._arms.units, *self._hands.values(), self._lamp]
        super().__init__(everything, [PanicButton(arm) for arm in self._arms])
        self._sides: tuple[str, ...] = ()
        self._lookout: Lookout | None = None
        self._hindrance: Hindrance | None = None
        self._plant = Plant(self._text(drawn=False))
        self._bind()
        self._begin()

    @classmethod
    def shaken(cls, seed: int) -> "BoxesWorld":
        """The same world with each box up to a millimetre from its place, as they never stand twice alike."""
        return cls(seed, layout.SHAKEN_M)

    def objections(self, devices: Sequence[str]) -> tuple[Reason, ...]:
        """Why these devices cannot be used together; none: they can."""
        return tuple(self._arms.objections(devices))

    def remarks(self, devices: Sequence[str]) -> tuple[Reason, ...]:
        """What is odd about these devices in one flow, and forbids nothing: hands, and arms that do not bear them."""
        hands = [unit for unit in self._hands.values() if unit.sheet.name in devices]
        return tuple(self._arms.remarks(devices, hands))

    def reset(self) -> None:
        """Boxes and arms back to their start, at rest; all drives hold. Time, claims and pressed buttons go on."""
        for unit in self._acting:
            self._feed(unit, DriveInput.RESET)
        self._press_again()
        mujoco.mj_resetData(self._plant.model, self._plant.data)
        for unit in self._present:
            unit.restart()
        self._sense_ns = self.now_ns
        self._begin()

    def places(self) -> tuple[Reason, ...]:
        """What stands where at the start."""
        return tuple(self._start_places.places(self._standing()))

    def displaced(self) -> tuple[Displacement, ...]:
        """What does not stand there now."""
        return tuple(self._start_places.displaced(self._plant, self._standing()))

    def watch_mishaps(self) -> None:
        """From now on notice what no program means: arms and hands, and what they carry, that touch something."""
        self._lookout = Lookout(self._claimed_at, lambda: self.lit)
        self._begin()

    def take_mishaps(self) -> list[MishapEvent]:
        """What was noticed since the last call."""
        return [] if self._lookout is None else self._lookout.take()

    def standing(self) -> tuple[Reason, ...]:
        """In sentences what is worth knowing of how everything stands."""
        lamp = Reason.of("workcell.lamp_lit") if self._lamp.lit else Reason.of("workcell.lamp_dark")
        return (lamp,)

    def scene(self) -> list[Shape3d]:
        """What there is to draw; changes when an arm is added."""
        return shapes(Plant(self._text(drawn=True)))

    @property
    def lit(self) -> tuple[str, ...]:
        """The lamp, while its circuit is closed."""
        return ("lamp",) if self._lamp.lit else ()

    def snapshot(self) -> bytes:
        """This instant for `onika.workcell.picture`."""
        qpos = tuple(self._plant.data.qpos.tolist())
        return encode(WorldSnapshot(self._text(drawn=True), qpos, self.now_ns * 1e-9, self._lamp.lit))

    def _standing(self) -> list[ArmUnit]:
        """The arms that are there."""
        return [self._arms.acting[side] for side in self._sides]

    def _halted(self, unit: DeviceUnit) -> tuple[Reason, tuple[Reason, ...]] | tuple[()]:
        """Where an arm stands that begins to hold, and what is in its way; nothing of what is no arm."""
        if not isinstance(unit, ArmUnit) or unit.side not in self._sides:
            return ()
        if self._hindrance is None:
            self._hindrance = Hindrance(self._plant, has_forces=not self._arms.kinematic)
        held, is_alone = self._start_places.held(self._plant, unit.side), len(self._sides) < 2
        told = self._hindrance.told(unit.side, "" if held is None else held.sign, is_alone=is_alone)
        return self._hindrance.place(unit.side, is_alone=is_alone), told

    def _admit(self, unit: DeviceUnit) -> None:
        """Make room for a device: its arm may be new in the world, of another kind or in the other mode."""
        acting = set(self._present)
        changed = isinstance(unit, ArmUnit) and self._arms.admit(unit)
        if unit.side in ("", *self._sides) and not changed:
            return
        self._sides = tuple(side for side in SIDES if side in (unit.side, *self._sides))
        # between two steps: compile anew, then everything takes its state back by name
        before = self._plant
        self._plant = Plant(self._text(drawn=False))
        self._bind()
        newcomers = [unit for unit in self._present if unit not in acting]
        for newcomer in newcomers:
            newcomer.restart()
        self._plant.take(before)
        for newcomer in newcomers:
            newcomer.capture()
        self._begin()

    def _text(self, drawn: bool) -> str:
        return layout.text(self._boxes, self._sides, drawn, self._arms.kinds())

    def _bind(self) -> None:
        self._hindrance = None
        arms = self._arms.acting
        acting: list[DeviceUnit] = [unit for side in SIDES for unit in (arms[side], self._hands[side])] + [self._lamp]
        for button in self._buttons.values():
            button.units = tuple(arms[unit.side] for unit in button.units)
        self._bind_units(acting, [unit for unit in acting if unit.side in ("", *self._sides)])

    def _begin(self) -> None:
        """Go on from the plant's present positions: with physics, or without forces."""
        self._plant.vary(self._factors)
        self._plant.settle()
        self._advance: Callable[[Any, Any], None] = mj_step
        carried: Callable[[str], tuple[str, ...]] | None = None
        self._feel = self._plant.sense
        if self._arms.kinematic:
            hands = [self._hands[side].sheet.name for side in self._sides]
            kinematics = Kinematics(self._plant, self._arms.moving(self._sides), hands)
            self._advance, self._feel = kinematics.step, kinematics.feel
            self._plant.settle()
            carried = kinematics.carried
        if self._lookout is not None:
            self._advance = self._lookout.watch(self._plant, self._sides, self._advance, lambda: self.now_ns, carried)
        self._publish()

    def _claimed_at(self, side: str) -> tuple[str, ...]:
        """The devices at a side that somebody uses."""
        return tuple(unit.sheet.name for unit in self._present if unit.side == side and unit.epoch is not None)
