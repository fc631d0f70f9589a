"""A world of devices with drives: claimed, commanded and read by name, stepped in its own time (laws 16 to 18).

Which devices there are, what they stand in and how a step is made says the world itself, the class below this one.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from onika.laws.frames import Array
from onika.ring.device import DeviceOrder, DeviceSheet, DriveEvent
from onika.ring.drive import NEVER_NS, DriveInput, DriveMode, input_of
from onika.words.reason import Reason
from onika.workcell.panic_button import PanicButton
from onika.workcell.plant import FACTORS, Plant
from onika.workcell.unit import DeviceUnit

_SENSE_NS = 20_000_000  # how often touch is felt: at the pads of hands and in the lamp's circuit
_LEAST, _MOST = 0.01, 100.0
_DRIVE = int(DeviceOrder.DRIVE)  # plain numbers compare quicker than names


class DrivenWorld:
    """A world in steps of `step_ns` of its own time; devices are claimed, commanded and read by name.

    Of its units all have a name, those that act have a drive that is listened to, those that are present have a body.
    """

    step_ns: int
    is_simulated = True
    """Nothing outside this program moves."""

    _plant: Plant
    _advance: Callable[[Any, Any], None]
    _feel: Callable[[], None]

    def __init__(self, units: Sequence[DeviceUnit], buttons: Sequence[PanicButton]) -> None:
        self.now_ns = 0
        self._units = {unit.sheet.name: unit for unit in units}
        self._buttons = {button.name: button for button in buttons}
        self._acting: list[DeviceUnit] = []
        self._present: list[DeviceUnit] = []
        self._holding: list[DeviceUnit] = []
        self._fenced: set[int] = set()
        self._events: list[DriveEvent] = []
        self._sense_ns = 0
        self._due_ns = NEVER_NS
        self._factors: dict[str, float] = {}

    def vary(self, name: str, factor: float) -> None:
        """Before anything has moved: `friction` or `mass` is so many times what the model says; raises ValueError."""
        if name not in FACTORS:
            raise ValueError(Reason.of("workcell.no_factor", there=FACTORS, name=name))
        if not _LEAST <= factor <= _MOST:
            raise ValueError(Reason.of("workcell.factor_range", least=_LEAST, most=_MOST, name=name, factor=factor))
        self._factors[name] = factor
        self._plant.vary(self._factors)

    def devices(self) -> tuple[DeviceSheet, ...]:
        """All devices there are or can be."""
        return tuple(unit.sheet for unit in self._units.values())

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

    def modes(self) -> Mapping[str, DriveMode]:
        """How the drives of the arms and hands that are there stand."""
        return {unit.sheet.name: unit.drive.mode for unit in self._present if unit.count}

    def parts(self) -> Mapping[str, Reason]:
        """What a hand can touch in this world, and the values that it takes."""
        return {button.name: button.takes for button in self._buttons.values()}

    @property
    def pressed(self) -> tuple[str, ...]:
        """The parts that a hand holds pressed."""
        return tuple(button.name for button in self._buttons.values() if button.is_pressed)

    def touch(self, part: str, value: float) -> None:
        """Touch a part between two steps; raises ValueError for an unknown part or a value that it does not take."""
        button = self._buttons.get(part)
        if button is None:
            parts = tuple(
                Reason.of("workcell.part", name=other.name, takes=other.takes) for other in self._buttons.values()
            )
            raise ValueError(Reason.of("workcell.no_such_part", parts=parts, part=part))
        drive_input = button.put(value)
        for unit in button.units:
            self._feed(unit, drive_input)

    def take_events(self) -> list[DriveEvent]:
        """The changes of drives since the last call, oldest first."""
        events, self._events = self._events, []
        return events

    def poses(self) -> npt.NDArray[np.float32]:
        """Place (m) and quaternion (w, x, y, z) of each body, float32[bodies,7]."""
        return self._plant.poses()

    def fingerprint(self) -> bytes:
        """Time, positions and speeds, byte for byte: equal runs have equal fingerprints."""
        data = self._plant.data
        return b"".join((self.now_ns.to_bytes(8, "little"), data.qpos.tobytes(), data.qvel.tobytes()))

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
            for unit in button.units if button.is_pressed else ():
                self._feed(unit, DriveInput.PRESS)

    def _listen(self, now: int) -> None:
        for unit in self._acting:
            drive_input = unit.drive.silence(now)
            if drive_input is not None:
                self._feed(unit, drive_input)
        self._due_ns = min(unit.drive.due_ns for unit in self._acting)

    def _feed(self, unit: DeviceUnit, drive_input: DriveInput) -> None:
        """Something happened to a drive: move it, hold where it stops following, report what others see of it."""
        if not unit.count:
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

    def _admit(self, unit: DeviceUnit) -> None:
        """Make room for a device; raises ValueError where another one in use stands against it."""

    def _halted(self, unit: DeviceUnit) -> tuple[Reason, tuple[Reason, ...]] | tuple[()]:
        """Where an arm stands that begins to hold, and what is in its way; nothing where the world does not say so."""
        return ()

    def _bind_units(self, acting: Sequence[DeviceUnit], present: Sequence[DeviceUnit]) -> None:
        """Give the units the arrays of a new plant, and listen to those that act from now on."""
        self._acting, self._present = [*acting], [*present]
        for unit in self._present:
            unit.bind(self._plant)
        self._holding = [
            present for present in self._present if present.holds and present.drive.mode is not DriveMode.DRIVEN
        ]
        self._due_ns = min((unit.drive.due_ns for unit in self._acting), default=NEVER_NS)

    def _sense(self) -> None:
        self._sense_ns = self.now_ns + _SENSE_NS
        self._feel()
        for unit in self._present:
            unit.sense()

    def _publish(self) -> None:
        for unit in self._present:
            unit.refresh(self.now_ns * 1e-9)
