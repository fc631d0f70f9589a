"""The worlds of a virtual runtime, each with its bus: opened with their first device, stepped where they stand."""

from collections.abc import Callable, Collection, Iterator
from typing import Any

from onika.host.units.world_registry import refuse_unknown, split
from onika.host.units.world_sources import WorldSources
from onika.ring.device import DriveState, MishapEvent
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.runtime.bus import SEGMENT_SIZE, Bus, Poses, World
from onika.runtime.command import DeviceGrant
from onika.runtime.picture import SmallPicture
from onika.wire import event
from onika.words.reason import Reason


class Buses:
    """Every world that is open; what its drives do, and what mishaps it has, is told after each step and touch."""

    def __init__(
        self,
        views: dict[str, memoryview],
        worlds: Callable[..., World],
        tell: Callable[[event.Drive], None],
        tell_mishap: Callable[[event.Mishap, int], None] | None = None,
    ) -> None:
        self._views = views
        self._open = worlds
        self._tell = tell
        self._tell_mishap = tell_mishap
        self.sources = WorldSources()
        self.opened: dict[str, str] = {}
        """The worlds that are open, each with what names the files that it was made of."""
        self._watched: set[str] = set()
        self._buses: dict[str, Bus] = {}
        self._segments: list[Segment] = []
        self._claims: dict[str, int] = {}
        self._looked_at: set[str] = set()
        self._small: dict[str, SmallPicture] = {}
        self._epoch = 0
        self._is_stopped = False

    @property
    def names(self) -> tuple[str, ...]:
        """The worlds that are open."""
        return tuple(self._buses)

    @property
    def worlds(self) -> Iterator[World]:
        """The worlds themselves, in the order they were opened."""
        return (bus.world for bus in self._buses.values())

    @property
    def simulated(self) -> tuple[str, ...]:
        """Those of them in which nothing outside the program moves."""
        return tuple(name for name, bus in self._buses.items() if bus.is_simulated)

    def grant(self, device: str, now: int) -> DeviceGrant:
        """Claim `world:device`; raises ValueError with the reason."""
        world, name = split(device)
        bus = self._bus(world, now)
        self._epoch += 1
        grant = bus.grant(name, self._epoch)
        self._claims[device] = self._epoch
        return grant

    def release(self, device: str) -> None:
        """Give a device back."""
        world, name = split(device)
        self._buses[world].release(name, self._claims.pop(device, 0))  # a camera may be given back more than once

    def scene(self, world: str) -> dict[str, Any] | None:
        """What an open world consists of."""
        if world in self._buses:
            return self._buses[world].scene()
        return None

    def poses(self, world: str) -> Poses | None:
        """Where the bodies of an open world are."""
        if world in self._buses:
            return self._buses[world].poses()
        return None

    def picture(self, device: str) -> SmallPicture | None:
        """The newest picture of the camera `world:device` for whoever looks; from now on somebody does."""
        world, name = split(device)
        if world not in self._buses:
            return None
        bus = self._buses[world]
        if device not in self._looked_at:
            self._looked_at.add(device)
            bus.show(name, True)
        self._small |= {f"{world}:{camera}": picture for camera, picture in bus.take_small().items()}
        return self._small.get(device)

    def look_only_at(self, devices: Collection[str]) -> None:
        """Nobody looks at any other camera any more."""
        for device in self._looked_at - set(devices):
            world, name = split(device)
            self._buses[world].show(name, False)
            self._looked_at.discard(device)
            self._small.pop(device, None)

    def pose_to(self, world: str, inlet: int) -> None:
        """Nobody says them: here whoever wants to know them can look."""

    def modes(self) -> dict[str, DriveMode]:
        """How the drives of all open worlds stand, by `world:device`."""
        return {device: mode for bus in self._buses.values() for device, mode in bus.modes().items()}

    def snapshots(self) -> dict[str, bytes]:
        """The worlds as they stand."""
        return {name: bus.world.snapshot() for name, bus in self._buses.items()}

    def standings(self) -> dict[str, tuple[Reason, ...]]:
        """What each world says of how it stands, where it knows how."""
        said = {name: bus.standing() for name, bus in self._buses.items()}
        return {name: sentences for name, sentences in said.items() if sentences}

    def watched(self) -> dict[str, bool]:
        """Of each whether what happens in it that no program means is told."""
        return {name: name in self._watched for name in self._buses}

    def touch(self, world: str, part: str, value: float) -> None:
        """Touch a part of an open world; raises ValueError with the reason why not."""
        refuse_unknown(world, self._buses)
        self._buses[world].touch(part, value)
        self._tell_news(world)

    def put_back(self, world: str) -> None:
        """Everything in a world to where it stood at the start; raises ValueError where only a person can do that."""
        refuse_unknown(world, self._buses)
        self._buses[world].put_back(is_stopped=self._is_stopped)
        self._tell_news(world)

    def displaced(self) -> dict[str, tuple[Displacement, ...]]:
        """What does not stand where it stood at the start, by world."""
        return {name: bus.displaced() for name, bus in self._buses.items()}

    def step(self, now: int) -> bool:
        """All go on to this instant; whether something was told of them."""
        has_news = False
        for name, bus in self._buses.items():
            bus.step(now)
            has_news |= self._tell_news(name)
        return has_news

    def step_once(self) -> None:
        """Each makes one step, so that the last commands act."""
        for name, bus in self._buses.items():
            bus.step(bus.world.now_ns + bus.world.step_ns)
            self._tell_news(name)

    def stop(self) -> None:
        """Every drive in hold, latched; also those of worlds that are opened from now on."""
        self._is_stopped = True
        for world in self.worlds:
            world.stop()

    def go_on(self) -> None:
        """Motion is allowed again; nothing moves by itself."""
        self._is_stopped = False
        for world in self.worlds:
            world.go_on()

    def close(self) -> None:
        """All worlds are no more; their memory is given back."""
        self._buses.clear()
        for segment in self._segments:
            segment.close()

    def _bus(self, world: str, now: int) -> Bus:
        if world not in self._buses:
            segment = Segment.create(f"bus-{world}", SEGMENT_SIZE)
            self._segments.append(segment)
            self._views[f"bus:{world}"] = segment.view
            files = self.sources.find(world)
            bus = Bus(world, self._open(world) if files is None else self._open(world, files=files), segment)
            self.opened[world] = self.sources.digest(world)
            bus.step(now)
            if self._is_stopped:
                bus.world.stop()
            getattr(bus.world, "render_in_step", _nothing)()
            watch = getattr(bus.world, "watch_mishaps", None)
            if self._tell_mishap is not None and watch is not None:
                watch()
                self._watched.add(world)
            self._buses[world] = bus
        return self._buses[world]

    def _tell_news(self, world: str) -> bool:
        """Whether there was something to tell."""
        drive_events = self._buses[world].world.take_events()
        for drive_event in drive_events:
            device, state = f"{world}:{drive_event.device}", DriveState(drive_event.state).name
            self._tell(
                event.Drive(
                    device,
                    state,
                    drive_event.at_ns,
                    drive_event.previous_step_ns,
                    drive_event.last_command_ns,
                    drive_event.cause,
                    stands=drive_event.stands,
                    touches=drive_event.touches,
                )
            )
        has_mishaps = self._tell_mishap is not None and self._tell_mishaps(world, self._tell_mishap)
        return bool(drive_events) or has_mishaps

    def _tell_mishaps(self, world: str, tell: Callable[[event.Mishap, int], None]) -> bool:
        take: Callable[[], list[MishapEvent]] = getattr(self._buses[world].world, "take_mishaps", list)
        mishaps = take()
        for mishap in mishaps:
            devices = tuple(f"{world}:{device}" for device in mishap.devices)
            tell(event.Mishap(world, mishap.text, devices, 0.0, mishap.poses, mishap.lit), mishap.at_ns)
        return bool(mishaps)


def _nothing() -> None:
    """A world without cameras renders nothing."""
