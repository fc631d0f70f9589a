"""The world of the box assembly: four boxes on a table, up to two arms, and a lamp that lights by touch (§6.2)."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import mujoco
import numpy as np
import numpy.typing as npt
from mujoco import mj_step

from onika.laws.frames import Array
from onika.ring.device import DeviceOrder, DeviceSheet, DriveEvent, MishapEvent
from onika.ring.displacement import Displacement
from onika.ring.drive import NEVER_NS, DriveInput, DriveMode, input_of
from onika.words.reason import Reason
from onika.workcell import layout
from onika.workcell.arm_unit import ArmUnit
from onika.workcell.arms import Arms
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

_SENSE_NS = 20_000_000  # how often touch is felt: at the pads of hands and in the lamp's circuit
_DRIVE = int(DeviceOrder.DRIVE)  # plain numbers compare quicker than names


class BoxesWorld:
    """A world in steps of 2 ms of its own time; devices are claimed, commanded and read by name.

    `offsets_m` moves each box by up to plus or minus that much on x and y, drawn from `seed`. An arm is part of the
    world from the first claim of it or of its gripper on. Which kind stands there, and whether the world has forces or
    is in the kinematic mode, follows from the arms that are claimed: `arm_left`, `arm_left_kin`, `scara_left` ...
    """

    step_ns = round(STEP_S * 1e9)
    is_simulated = True
    """Nothing outside this program moves."""

    def __init__(self, seed: int = 0, offsets_m: float = 0.0) -> None:
        self._boxes = layout.boxes(seed, offsets_m)
        self._start_places = StartPlaces(self._boxes)
        self.now_ns = 0
        self._lamp = LampUnit()
        self._arms = Arms()
        self._hands = {side: GripperUnit(side) for side in SIDES}
        everything: list[DeviceUnit] = [*self._arms.units, *self._hands.values(), self._lamp]
        self._units: dict[str, DeviceUnit] = {unit.sheet.name: unit for unit in everything}
        self._buttons = {arm.name: arm for arm in map(PanicButton, self._arms)}
        self._sides: tuple[str, ...] = ()
        self._fenced: set[int] = set()
        self._events: list[DriveEvent] = []
        self._sense_ns = 0
        self._due_ns = NEVER_NS
        self._lookout: Lookout | None = None
        self._hindrance: Hindrance | None = None
        self._plant = Plant(self._text(drawn=False))
        self._bind()
        self._begin()

    @classmethod
    def shaken(cls, seed: int) -> "BoxesWorld":
        """The same world with each box up to a millimetre from its place, as they never stand twice alike."""
        return cls(seed, layout.SHAKEN_M)

    def devices(self) -> tuple[DeviceSheet, ...]:
        """All devices there are or can be."""
        return tuple(unit.sheet for unit in self._units.values())

    def objections(self, devices: Sequence[str]) -> tuple[Reason, ...]:
        """Why these devices cannot be used together; none: they can."""
        return tuple(self._arms.objections(devices))

    def remarks(self, devices: Sequence[str]) -> tuple[Reason, ...]:
        """What is odd about these devices in one flow, and forbids nothing: hands, and arms that do not bear them."""
        hands = [unit for unit in self._hands.values() if unit.sheet.name in devices]
        return tuple(self._arms.remarks(devices, hands))

    def claim(self, device: str, epoch: int) -> DeviceSheet:
        """Give the device to the writer `epoch`; raises ValueError for one unknown or taken, and for a dead writer."""
        unit = self._unit(device)
        if unit.epoch is not None:
            raise ValueError(Reason.of("workcell.device_claimed", device=device))
        if epoch in self._fenced:
            raise ValueError(Reason.of("workcell.writer_died", epoch=epoch))
        self._admit(unit)
        unit.epoch, unit.drive.last_ns = epoch, -1
        return unit.sheet

    def release(self, device: str, epoch: int) -> None:
        """Put the device into hold and free the claim; another writer's wish changes nothing."""
        unit = self._unit(device)
        if unit.epoch == epoch:
            self._feed(unit, DriveInput.RELEASE)
            unit.epoch = None

    def fence(self, epoch: int) -> None:
        """The writer `epoch` died: its devices trip and are free to be claimed; what it still sends is ignored."""
        self._fenced.add(epoch)
        for unit in self._acting:
            if unit.epoch == epoch:
                self._feed(unit, DriveInput.FENCE)
                unit.epoch = None

    def command(self, device: str, epoch: int, order: int, values: Sequence[float] | Array) -> None:
        """A fresh command, which acts from the next step on; one from a writer without the claim is ignored.

        `values` are as the device's sheet says and are used with DeviceOrder.DRIVE alone: doubles in an array or
        memoryview (quickest), a list or a tuple. Raises ValueError for a wrong number of values, an unknown order
        or a device that takes none, KeyError for an unknown device.
        """
        unit = self._units[device]
        if epoch == unit.follows and order == _DRIVE:
            unit.drive.last_ns = self.now_ns
            if not unit.follow(values):
                self._feed(unit, DriveInput.UNSOUND)
        elif epoch == unit.epoch:
            self._obey(unit, order, values)

    def step(self, until_ns: int) -> None:
        """Advance in whole steps up to `until_ns` at most, then publish all states."""
        model, data, h, advance = self._plant.model, self._plant.data, self.step_ns, self._advance
        now = self.now_ns
        while now + h <= until_ns:
            if now > self._due_ns:
                self._listen(now)
            for unit in self._holding:
                unit.hold()
            advance(model, data)
            now += h
            self.now_ns = now
            if now >= self._sense_ns:
                self._sense()
        time = now * 1e-9
        for unit in self._present:
            unit.refresh(time)

    def state(self, device: str) -> Array:
        """The doubles that the device publishes; the same array always, written anew by `step`."""
        return self._unit(device).state

    def stop(self) -> None:
        """Hold every drive and let no command through until `reset` or `go_on`."""
        for unit in self._acting:
            self._feed(unit, DriveInput.STOP)

    def go_on(self) -> None:
        """Leave a stop without moving anything: drives hold until they are commanded, pressed buttons stay."""
        for unit in self._acting:
            if unit.drive.mode is DriveMode.STOPPED:
                self._feed(unit, DriveInput.RESET)
        self._press_again()

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

    def modes(self) -> Mapping[str, DriveMode]:
        """How the drives of the arms and hands that are there stand."""
        return {unit.sheet.name: unit.drive.mode for unit in self._present if unit.count}

    def parts(self) -> Mapping[str, Reason]:
        """What a hand can touch in this world, and the values that it takes."""
        return {button.name: button.takes for button in self._buttons.values()}

    def touch(self, part: str, value: float) -> None:
        """Touch a part between two steps; raises ValueError for an unknown part or a value that it does not take."""
        button = self._buttons.get(part)
        if button is None:
            parts = tuple(
                Reason.of("workcell.part", name=other.name, takes=other.takes) for other in self._buttons.values()
            )
            raise ValueError(Reason.of("workcell.no_such_part", parts=parts, part=part))
        self._feed(button.unit, button.put(value))

    def take_events(self) -> list[DriveEvent]:
        """The changes of drives since the last call, oldest first."""
        events, self._events = self._events, []
        return events

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

    def poses(self) -> npt.NDArray[np.float32]:
        """Place (m) and quaternion (w, x, y, z) of each body, float32[bodies,7]."""
        return self._plant.poses()

    @property
    def lit(self) -> tuple[str, ...]:
        """The lamp, while its circuit is closed."""
        return ("lamp",) if self._lamp.lit else ()

    def snapshot(self) -> bytes:
        """This instant for `onika.workcell.picture`."""
        qpos = tuple(self._plant.data.qpos.tolist())
        return encode(WorldSnapshot(self._text(drawn=True), qpos, self.now_ns * 1e-9, self._lamp.lit))

    def fingerprint(self) -> bytes:
        """Time, positions and speeds, byte for byte: equal runs have equal fingerprints."""
        data = self._plant.data
        return b"".join((self.now_ns.to_bytes(8, "little"), data.qpos.tobytes(), data.qvel.tobytes()))

    def _standing(self) -> list[ArmUnit]:
        """The arms that are there."""
        return [self._arms.acting[side] for side in self._sides]

    def _unit(self, device: str) -> DeviceUnit:
        unit = self._units.get(device)
        if unit is None:
            raise ValueError(Reason.of("workcell.no_such_device", devices=tuple(self._units), device=device))
        return unit

    def _obey(self, unit: DeviceUnit, order: int, values: Sequence[float] | Array) -> None:
        """A command that may change the drive's mode."""
        if not unit.count:
            raise ValueError(Reason.of("workcell.no_commands", device=unit.sheet.name))
        drive_input = input_of(order)
        if drive_input is DriveInput.DRIVE and len(values) != unit.count:
            found = len(values)
            raise ValueError(Reason.of("workcell.values", count=unit.count, device=unit.sheet.name, found=found))
        if drive_input is DriveInput.DRIVE and not np.isfinite(values).all():
            drive_input = DriveInput.UNSOUND
        self._feed(unit, drive_input)
        unit.drive.last_ns = self.now_ns
        if unit.drive.mode is DriveMode.DRIVEN and drive_input is DriveInput.DRIVE:
            unit.follow(values)
        self._due_ns = min(self._due_ns, unit.drive.due_ns)

    def _press_again(self) -> None:
        for button in self._buttons.values():
            if button.is_pressed:
                self._feed(button.unit, DriveInput.PRESS)

    def _listen(self, now: int) -> None:
        for unit in self._acting:
            drive_input = unit.drive.silence(now)
            if drive_input is not None:
                self._feed(unit, drive_input)
        self._due_ns = min(unit.drive.due_ns for unit in self._acting)

    def _feed(self, unit: DeviceUnit, drive_input: DriveInput) -> None:
        """Something happened to a drive: move it, hold where it stops following, report what others see of it."""
        if unit is self._lamp:
            return
        before, was = unit.drive.shown, unit.drive.mode
        unit.drive.feed(drive_input)
        if was is DriveMode.DRIVEN and unit.drive.mode is not DriveMode.DRIVEN:
            unit.capture()
        after = unit.drive.shown
        if after is not before:
            unit.state[1] = after
            last = max(self.now_ns - self.step_ns, 0)
            times = self.now_ns, last, unit.drive.last_ns
            said = self._halted(unit) if was is DriveMode.DRIVEN else ()
            self._events.append(DriveEvent(unit.sheet.name, int(after), *times, drive_input.value, *said))
        unit.follows = unit.epoch if unit.drive.mode is DriveMode.DRIVEN else None
        self._holding = [
            present for present in self._present if present.holds and present.drive.mode is not DriveMode.DRIVEN
        ]

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
        self._acting: list[DeviceUnit] = [unit for side in SIDES for unit in (arms[side], self._hands[side])] + [
            self._lamp
        ]
        self._present: list[DeviceUnit] = [unit for unit in self._acting if unit.side in ("", *self._sides)]
        for button in self._buttons.values():
            button.unit = arms[button.unit.side]
        for unit in self._present:
            unit.bind(self._plant)
        self._holding = [
            present for present in self._present if present.holds and present.drive.mode is not DriveMode.DRIVEN
        ]
        self._due_ns = min(unit.drive.due_ns for unit in self._acting)

    def _begin(self) -> None:
        """Go on from the plant's present positions: with physics, or without forces."""
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

    def _sense(self) -> None:
        self._sense_ns = self.now_ns + _SENSE_NS
        self._feel()
        for unit in self._present:
            unit.sense()

    def _publish(self) -> None:
        for unit in self._present:
            unit.refresh(self.now_ns * 1e-9)
