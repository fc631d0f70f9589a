"""The worlds of the device server, each with its bus and its delay: claims, commands, steps, and the stop of all."""

from collections.abc import Callable, Sequence
from typing import Any

from onika.host.units.waiting_orders import Preparation
from onika.host.units.world_registry import split
from onika.ring.device import DriveEvent
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.runtime.bus import Bus, Poses, World
from onika.runtime.command import DeviceGrant
from onika.runtime.picture import SmallPicture
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason

_MOST_BEHIND_NS = 50_000_000
"""Further behind, a world loses time instead of running after it: a stall stretches a motion and never jumps."""


class ServedWorlds:
    """Every world that is open. Times are in ns of the runtime; `worlds` opens one by its name, or of files."""

    def __init__(self, worlds: Callable[..., World]) -> None:
        self._worlds = worlds
        self._buses: dict[str, Bus] = {}
        self._behind: dict[str, int] = {}
        self._is_stopped = False

    @property
    def names(self) -> tuple[str, ...]:
        """The worlds that are open."""
        return tuple(self._buses)

    def open(self, name: str, segment: Segment, now: int, files: WorldSource | None = None) -> bool:
        """Open a world; after a stop it is stopped too. Whether it is simulated; raises ValueError with the reason."""
        world = self._worlds(name) if files is None else self._worlds(name, files=files)
        if self._is_stopped:
            world.stop()
        self._buses[name] = Bus(name, world, segment)
        self._behind[name] = now - world.now_ns
        return self._buses[name].is_simulated

    def preparation(self, device: str) -> Preparation | None:
        """What takes long before `world:device` can be claimed, and may be done beside; None: nothing does."""
        world, name = split(device)
        asked = getattr(self._buses[world].world, "preparation", None) if world in self._buses else None
        preparation: Preparation | None = asked(name) if asked is not None else None
        return preparation

    def grant(self, device: str, epoch: int) -> DeviceGrant:
        """Claim `world:device` for the writer of this epoch; raises ValueError with the reason."""
        world, name = split(device)
        return self._buses[world].grant(name, epoch)

    def release(self, device: str, epoch: int) -> None:
        """The claim of `world:device` ends."""
        world, name = split(device)
        self._buses[world].release(name, epoch)

    def fence(self, epoch: int) -> None:
        """The writer of this epoch is dead: what it drove trips."""
        for bus in self._buses.values():
            bus.world.fence(epoch)

    def stop(self) -> None:
        """Every drive in hold, latched; also those of worlds that are opened from now on (law 27)."""
        self._is_stopped = True
        for bus in self._buses.values():
            bus.world.stop()

    def go_on(self) -> None:
        """Motion is allowed again; nothing moves by itself."""
        self._is_stopped = False
        for bus in self._buses.values():
            bus.world.go_on()

    def touch(self, world: str, part: str, value: float) -> None:
        """Touch a part of a world; raises ValueError with the reason why not."""
        self._buses[world].touch(part, value)

    def put_back(self, world: str) -> None:
        """Everything in a world to where it stood at the start; raises ValueError where only a person can do that."""
        self._buses[world].put_back(is_stopped=self._is_stopped)

    def displaced(self) -> dict[str, tuple[Displacement, ...]]:
        """What does not stand where it stood at the start, by world."""
        return {name: bus.displaced() for name, bus in self._buses.items()}

    def behind_ns(self, name: str) -> int:
        """How far the world's time is behind the runtime's."""
        return self._behind[name]

    def due_ns(self) -> int | None:
        """When the first of them has its next step; None: none is open."""
        dues = (bus.world.now_ns + bus.world.step_ns + self._behind[name] for name, bus in self._buses.items())
        return min(dues, default=None)

    def step(self, name: str, now: int) -> Sequence[DriveEvent]:
        """Let a world go on to this instant, as far as whole steps of it have passed; what its drives did."""
        bus, world = self._buses[name], self._buses[name].world
        late = now - self._behind[name] - world.now_ns
        if late > _MOST_BEHIND_NS:
            self._behind[name] += late - world.step_ns
        until = now - self._behind[name]
        if until >= world.now_ns + world.step_ns:
            bus.step(until)
        return world.take_events()

    def scene(self, world: str) -> dict[str, Any] | None:
        """What an open world consists of; None: it is not open."""
        bus = self._buses.get(world)
        return None if bus is None else bus.scene()

    def poses(self, world: str) -> Poses:
        """Where its bodies are."""
        return self._buses[world].poses()

    def show(self, world: str, camera: str, is_shown: bool) -> None:
        """Somebody looks at the pictures of a camera from now on, or nobody any more."""
        self._buses[world].show(camera, is_shown)

    def take_small(self, world: str) -> dict[str, SmallPicture]:
        """The newest pictures of its cameras at which somebody looks, since the last call."""
        return self._buses[world].take_small()

    def snapshots(self) -> dict[str, bytes]:
        """The worlds as they stand."""
        return {name: bus.world.snapshot() for name, bus in self._buses.items()}

    def standings(self) -> dict[str, tuple[Reason, ...]]:
        """What each of them says of how it stands, where it knows how."""
        said = {name: bus.standing() for name, bus in self._buses.items()}
        return {name: sentences for name, sentences in said.items() if sentences}

    def modes(self) -> dict[str, DriveMode]:
        """How the drives of all of them stand from within, by `world:device`."""
        return {device: mode for bus in self._buses.values() for device, mode in bus.modes().items()}
