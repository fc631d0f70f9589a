"""The device bus of one world: claims, commands in, states out, between rings and the world (laws 16 to 18).

The same code runs in the device server's process in wall time and beside the virtual clock.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from typing import Any, Protocol

import numpy as np
from msgspec import to_builtins

from onika.ring.device import DeviceSheet, DriveEvent
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.ring.slots import Ring
from onika.runtime import world_start
from onika.runtime.command import DeviceGrant
from onika.runtime.picture import Pictures, SmallPicture
from onika.words.reason import Reason

SEGMENT_SIZE = 1 << 26
"""Bytes reserved for a bus, pictures of cameras included; untouched ones cost nothing."""


class World(Protocol):
    """What a simulated or real workcell offers; see the package of worlds for the meaning of each."""

    step_ns: int
    now_ns: int

    def devices(self) -> tuple[DeviceSheet, ...]:
        """Everything that can be granted."""
        ...

    def claim(self, device: str, epoch: int) -> DeviceSheet:
        """Take a device for one writer."""
        ...

    def release(self, device: str, epoch: int) -> None:
        """Give it back: safe hold."""
        ...

    def fence(self, epoch: int) -> None:
        """That writer is dead: its devices trip."""
        ...

    def command(self, device: str, epoch: int, order: int, values: Any) -> None:
        """A fresh command; acts from the next step on."""
        ...

    def step(self, until_ns: int) -> None:
        """Advance to a time."""
        ...

    def state(self, device: str) -> Any:
        """The newest state of a device: a vector of float64, always the same one."""
        ...

    def stop(self) -> None:
        """Hold everything, latched."""
        ...

    def go_on(self) -> None:
        """Leave a stop without moving anything: drives hold until they are commanded."""
        ...

    def modes(self) -> Mapping[str, DriveMode]:
        """How the drive of every device that takes commands stands from within."""
        ...

    def parts(self) -> Mapping[str, Reason]:
        """What a hand can touch, such as a button, and the values that it takes."""
        ...

    def touch(self, part: str, value: float) -> None:
        """A hand touches a part, between two steps; raises ValueError for an unknown part or value."""
        ...

    def take_events(self) -> list[DriveEvent]:
        """Changes of drives since the last call."""
        ...

    def scene(self) -> Sequence[Any]:
        """What there is to draw, as dataclasses of plain values."""
        ...

    def poses(self) -> Any:
        """Where its bodies are: an array of float32, a row for each body of the scene."""
        ...

    @property
    def lit(self) -> tuple[str, ...]:
        """The names of the shapes that shine just now, such as a lamp."""
        ...

    def snapshot(self) -> bytes:
        """Enough to draw the world elsewhere."""
        ...

    def fingerprint(self) -> bytes:
        """The world as bytes, to compare two runs."""
        ...


Poses = tuple[int, bytes, tuple[str, ...]]
"""A world's time in ns, its bodies as float32 rows of position and quaternion, and the names of what shines."""


class Bus:
    """One world on shared memory. `name` is the world's; `segment` is shared with whoever is granted a device."""

    def __init__(self, name: str, world: World, segment: Segment) -> None:
        self.name = name
        self.world = world
        self._view = segment.view
        self._sheets = {sheet.name: sheet for sheet in world.devices()}
        self._offsets, end = _layout(world.devices())
        self._pictures = Pictures(segment.view, world, world.devices(), end)
        self._commands: dict[str, _Commands] = {}
        self._publishers: dict[str, Callable[[], None]] = {}

    @property
    def is_simulated(self) -> bool:
        """Whether nothing outside the program moves; a world that does not say so (`is_simulated`) counts as real."""
        return getattr(self.world, "is_simulated", False) is True

    def grant(self, device: str, epoch: int) -> DeviceGrant:
        """Give a task the device: claimed for one writer if it takes commands, shared if it only publishes.

        Raises ValueError with a sentence where the device is unknown or taken.
        """
        sheet = self._sheets.get(device)
        if sheet is None:
            devices = tuple(sorted(self._sheets))
            raise ValueError(Reason.of("runtime.world_device", world=self.name, devices=devices, device=device))
        state_at, command_at = self._offsets[device]
        if sheet.command:
            sheet = self.world.claim(device, epoch)
            ring = Ring(self._view, command_at, 8 * (2 + len(sheet.command)))
            self._commands[device] = _Commands(device, epoch, ring, len(sheet.command))
        self._publishers[device] = self._publisher(sheet, state_at)
        self._publishers[device]()
        places = state_at, command_at if sheet.command else None, sheet.picture, self._pictures.use(device)
        return DeviceGrant(f"bus:{self.name}", device, sheet.state, sheet.command, dict(sheet.identity), epoch, *places)

    def release(self, device: str, epoch: int) -> None:
        """The claim ends: the drive holds."""
        commands = self._commands.get(device)
        if commands is not None and commands.epoch == epoch:
            commands.pump(self.world)
            del self._commands[device]
        self._pictures.leave(device)
        self.world.release(device, epoch)

    def step(self, until_ns: int) -> None:
        """Deliver fresh commands, advance the world, publish its devices' states."""
        self.deliver()
        self.world.step(until_ns)
        self._pictures.publish()  # before the states, which say which picture is the newest
        for publish in self._publishers.values():
            publish()

    def deliver(self) -> None:
        """Hand the commands written since the last call to the world."""
        for commands in self._commands.values():
            commands.pump(self.world)

    def touch(self, part: str, value: float) -> None:
        """Touch a part of the world, and publish what that changes; raises ValueError as the world does."""
        self.world.touch(part, value)
        for publish in self._publishers.values():
            publish()

    def put_back(self, *, is_stopped: bool) -> None:
        """Everything to where it stood at the start, and stopped as before; raises ValueError where nobody can here."""
        world_start.put_back(self.name, self.world)
        if is_stopped:
            self.world.stop()
        for publish in self._publishers.values():
            publish()

    def displaced(self) -> tuple[Displacement, ...]:
        """What does not stand where it stood at the start, as far as its world knows."""
        return world_start.displaced(self.world)

    def modes(self) -> dict[str, DriveMode]:
        """How the drives of its world stand, by `world:device`."""
        return {f"{self.name}:{device}": mode for device, mode in self.world.modes().items()}

    def standing(self) -> tuple[Reason, ...]:
        """What its world says in sentences of how it stands; nothing where it does not know how (`standing`)."""
        standing = getattr(self.world, "standing", None)
        return () if standing is None else tuple(standing())

    def scene(self) -> dict[str, Any]:
        """What there is to draw and to touch, as plain values that travel."""
        scene = {
            "shapes": [asdict(shape) for shape in self.world.scene()],
            "parts": {name: to_builtins(takes) for name, takes in self.world.parts().items()},
        }
        button_places = getattr(self.world, "button_places", None)
        if button_places is not None:
            scene["buttons"] = {name: list(place) for name, place in button_places().items()}
        if switches := tuple(getattr(self.world, "switches", ())):
            scene["switches"] = switches
        if pressed := tuple(getattr(self.world, "pressed", ())):
            scene["pressed"] = pressed
        cameras = self._pictures.cameras
        return scene | {"cameras": cameras} if cameras else scene

    def show(self, device: str, is_shown: bool) -> None:
        """Somebody looks at the pictures of a camera from now on, or nobody any more; nothing where it is none."""
        if device in self._sheets and self._sheets[device].picture:
            self._pictures.show(device, is_shown)

    def take_small(self) -> dict[str, SmallPicture]:
        """The newest pictures of its cameras at which somebody looks, as far as they are new since the last call."""
        return self._pictures.take_small()

    def poses(self) -> Poses:
        """The world's time, the poses of its bodies, and what shines."""
        return self.world.now_ns, self.world.poses().tobytes(), self.world.lit

    def _publisher(self, sheet: DeviceSheet, offset: int) -> Callable[[], None]:
        """A function that publishes the device's state, straight from the world's vector, which is always the same."""
        state = self.world.state(sheet.name)
        return Ring(self._view, offset, state.nbytes).writer(state.data.cast("B"))


class _Commands:
    """The command ring of one claimed device."""

    def __init__(self, device: str, epoch: int, ring: Ring, count: int) -> None:
        self.epoch = epoch
        self._device = device
        data = np.zeros(2 + count).data
        self._head = data[:2]
        self._values = data[2:]
        self._fetch = ring.reader(data.cast("B"))
        self._words = ring.words
        self._seen = ring.count

    def pump(self, world: World) -> None:
        """Deliver the newest command, once."""
        if self._words[0] != self._seen:
            self._seen = self._fetch()
            epoch, order = self._head
            world.command(self._device, int(epoch), int(order), self._values)


def _layout(sheets: Sequence[DeviceSheet]) -> tuple[dict[str, tuple[int, int]], int]:
    """Offsets of state and command rings of every device, in the world's order, and where they end."""
    offsets, end = {}, 0
    for sheet in sheets:
        command_at = end + Ring.footprint(8 * len(sheet.state))
        offsets[sheet.name] = (end, command_at)
        end = command_at + Ring.footprint(8 * (2 + len(sheet.command)))
    return offsets, end
