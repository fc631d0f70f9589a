"""A small world for tests: masses on rails, one device each, and a scale that only publishes (laws 16 to 18)."""

import struct
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from onika.ring.device import DeviceOrder, DeviceSheet, DriveEvent, DriveState
from onika.ring.drive import DriveMode
from onika.words.reason import Reason

HOLD_NS = 50_000_000
TRIP_NS = 250_000_000
_LATCHED = (DriveState.TRIPPED, DriveState.PRESSED)


class MassWorld:
    """`count` masses of 1 kg called m0, m1, …: position (m) and speed (m/s) out, force (N) in; `scale` adds positions.

    A mass whose drive holds stands still. The drive holds by itself 50 ms after the last command, and trips 250 ms
    after it or when its writer dies. `stop` holds everything, latched. A command counts from the next step of 1 ms on.
    `panic` is one button for all masses: pressed (1) they hold, let go (0) they have tripped.
    """

    step_ns = 1_000_000
    halt: tuple[Reason, tuple[Reason, ...]] | tuple[()] = ()
    """What is told of a mass as its drive holds: where it stands, and what it touches."""

    def __init__(self, count: int = 2) -> None:
        self.now_ns = 0
        self._masses = {f"m{number}": _Mass(f"m{number}") for number in range(count)}
        self._scale = np.zeros(3)
        self._is_stopped = False
        self._fenced: set[int] = set()
        self._events: list[DriveEvent] = []

    def devices(self) -> tuple[DeviceSheet, ...]:
        """The masses, then the scale."""
        return (*(mass.sheet for mass in self._masses.values()), _SCALE)

    def claim(self, device: str, epoch: int) -> DeviceSheet:
        """One writer for a mass; raises ValueError with the reason."""
        mass = self._masses.get(device)
        if mass is None:
            raise ValueError(f"expected a mass of this world, found {device!r}")
        if mass.epoch is not None or epoch in self._fenced:
            raise ValueError(f"expected a free device and a living writer, found {device!r} claimed already")
        mass.epoch, mass.heard_ns = epoch, -1
        return mass.sheet

    def release(self, device: str, epoch: int) -> None:
        """Hold, and free the claim; of somebody else, or of the scale, nothing happens."""
        mass = self._masses.get(device)
        if mass is not None and mass.epoch == epoch:
            if mass.drive not in _LATCHED:
                self._turn(mass, DriveState.HELD, "released")
            mass.epoch = None

    def fence(self, epoch: int) -> None:
        """That writer is dead: its masses trip."""
        self._fenced.add(epoch)
        for mass in self._masses.values():
            if mass.epoch == epoch:
                if mass.drive is not DriveState.PRESSED:
                    self._turn(mass, DriveState.TRIPPED, "its writer died")
                mass.epoch = None

    def command(self, device: str, epoch: int, order: int, values: Sequence[float]) -> None:
        """A fresh command of the writer that has the claim; others are ignored."""
        mass = self._masses[device]
        if mass.epoch != epoch or self._is_stopped:
            return
        mass.heard_ns = self.now_ns
        if mass.drive is DriveState.PRESSED:
            return
        is_tripped = mass.drive is DriveState.TRIPPED
        if order == DeviceOrder.CLEAR and mass.drive is DriveState.DRIVEN:
            return
        if order == DeviceOrder.CLEAR or (order == DeviceOrder.HOLD and not is_tripped):
            self._turn(mass, DriveState.HELD, DeviceOrder(order).name)
        elif order == DeviceOrder.DRIVE and not is_tripped:
            mass.force = float(values[0])
            self._turn(mass, DriveState.DRIVEN, "DRIVE")

    def step(self, until_ns: int) -> None:
        """Whole steps up to `until_ns` at most."""
        while self.now_ns + self.step_ns <= until_ns:
            for mass in self._masses.values():
                self._listen(mass)
                mass.move(self.step_ns * 1e-9)
            self.now_ns += self.step_ns
        for mass in self._masses.values():
            mass.state[0] = self.now_ns * 1e-9
        self._scale[0] = self.now_ns * 1e-9
        self._scale[2] = sum(mass.state[2] for mass in self._masses.values())

    def state(self, device: str) -> Any:
        """Time, drive, then the values."""
        return self._scale if device == _SCALE.name else self._masses[device].state

    def stop(self) -> None:
        """Hold everything and hear no more."""
        self._is_stopped = True
        for mass in self._masses.values():
            self._turn(mass, DriveState.HELD, "stop")

    def go_on(self) -> None:
        """Hear again; every drive holds until it is commanded."""
        self._is_stopped = False

    def modes(self) -> Mapping[str, DriveMode]:
        """As the drives of any world."""
        return {name: mass.mode(self._is_stopped) for name, mass in self._masses.items()}

    def parts(self) -> Mapping[str, Reason]:
        """The one button."""
        return {"panic": Reason.of("workcell.button_takes")}

    def touch(self, part: str, value: float) -> None:
        """Press the button or let it go; raises ValueError for another part or value."""
        if part != "panic" or value not in (0.0, 1.0):
            raise ValueError(f"expected 1 or 0 for panic, found {value:g} for {part!r}")
        for mass in self._masses.values():
            if value or mass.drive is DriveState.PRESSED:
                self._turn(mass, DriveState.PRESSED if value else DriveState.TRIPPED, "pressed" if value else "let go")

    def take_events(self) -> list[DriveEvent]:
        """Changes of drives since the last call."""
        taken, self._events = self._events, []
        return taken

    def scene(self) -> list[object]:
        """There is nothing to draw."""
        return []

    def poses(self) -> np.ndarray:
        """Where each mass is, on the x axis."""
        rows = [[mass.state[2], 0.0, 0.0, 1.0, 0.0, 0.0, 0.0] for mass in self._masses.values()]
        return np.asarray(rows, dtype=np.float32)

    @property
    def lit(self) -> tuple[str, ...]:
        """Nothing shines."""
        return ()

    def snapshot(self) -> bytes:
        """The same as the fingerprint: there is nothing to draw."""
        return self.fingerprint()

    def fingerprint(self) -> bytes:
        """Time, positions and speeds as bytes."""
        states = b"".join(mass.state.tobytes() for mass in self._masses.values())
        return struct.pack("<q", self.now_ns) + states

    def _listen(self, mass: "_Mass") -> None:
        silent = self.now_ns - mass.heard_ns
        if mass.drive is DriveState.DRIVEN and silent > HOLD_NS:
            self._turn(mass, DriveState.HELD, "silence")
            mass.is_silent = True
        elif mass.is_silent and silent > TRIP_NS:
            self._turn(mass, DriveState.TRIPPED, "long silence")

    def _turn(self, mass: "_Mass", drive: DriveState, cause: str) -> None:
        mass.is_silent = False
        if drive is mass.drive:
            return
        mass.drive = drive
        mass.state[1] = drive
        if drive is not DriveState.DRIVEN:
            mass.state[3] = 0.0
        before = max(self.now_ns - self.step_ns, 0)
        said = self.halt if drive is DriveState.HELD else ()
        times = self.now_ns, before, mass.heard_ns
        self._events.append(DriveEvent(mass.sheet.name, drive, *times, Reason.plain(cause), *said))


class _Mass:
    """One mass and its drive."""

    def __init__(self, name: str) -> None:
        self.sheet = DeviceSheet(name, ("time", "drive", "x", "v"), ("force",), {"KIND": "mass"})
        self.state = np.zeros(4)
        self.state[1] = DriveState.HELD
        self.drive = DriveState.HELD
        self.epoch: int | None = None
        self.heard_ns = -1
        self.force = 0.0
        self.is_silent = False

    def mode(self, is_stopped: bool) -> DriveMode:
        """How its drive stands."""
        if is_stopped:
            return DriveMode.STOPPED
        if self.drive is DriveState.HELD:
            return DriveMode.SILENT if self.is_silent else DriveMode.HELD
        return DriveMode[self.drive.name]

    def move(self, dt: float) -> None:
        """One step of x'' = F, if the drive is driven: speed first, then position (semi-implicit Euler)."""
        if self.drive is DriveState.DRIVEN:
            self.state[3] += dt * self.force
            self.state[2] += dt * self.state[3]


_SCALE = DeviceSheet("scale", ("time", "drive", "total"), (), {})
