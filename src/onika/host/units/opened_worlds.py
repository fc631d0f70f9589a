"""The worlds of a runtime in wall time: opened at their device servers, claimed device by device, asked (law 16)."""

from collections.abc import Callable, Iterable, Mapping
from typing import Protocol, TypeVar

from onika.host.units import device_messages
from onika.host.units.device_servers import DeviceServers
from onika.host.units.unit_loss import dead_writers
from onika.host.units.world_registry import refuse_unknown, refuse_unoffered, split
from onika.host.units.world_sources import WorldSources, packed
from onika.ring.displacement import Displacement
from onika.ring.segment import Segment, SharedMemoryRefused
from onika.runtime import command
from onika.runtime.bus import SEGMENT_SIZE
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason, reason_of

PATIENCE_S = 15.0
ANSWER_S = 2.0
"""So long a device server may owe an answer: meanwhile nobody else is served."""

_Answer = TypeVar("_Answer", device_messages.DisplacedTaken, device_messages.SnapshotsTaken)


class Wait(Protocol):
    """Serves everybody until something is there."""

    def __call__(self, is_done: Callable[[], bool], what: Reason, patience_s: float) -> None:
        """Raises ValueError where it does not come in so many seconds."""
        ...


class OpenedWorlds:
    """Which worlds are open, and who has which device of them.

    wait    serves everybody until a device server has answered
    share   lets the processing units see the memory of a world
    """

    def __init__(self, devices: DeviceServers, wait: Wait, share: Callable[[str, Segment], None]) -> None:
        self._devices = devices
        self._wait = wait
        self._share = share
        self._segments: list[Segment] = []
        self._opened: dict[str, str] = {}
        self._sources = WorldSources()
        self._simulated: set[str] = set()
        self._claims: dict[str, tuple[int, str]] = {}
        self._epoch = 0

    def offer(self, worlds: Iterable[WorldSource]) -> None:
        """These worlds are files; they are opened when a device of them is granted."""
        self._sources.take(worlds)

    @property
    def opened(self) -> Mapping[str, str]:
        """The worlds that are open, each with what names the files that it was made of."""
        return self._opened

    @property
    def names(self) -> tuple[str, ...]:
        """Those that are open."""
        return tuple(sorted(self._opened))

    @property
    def simulated(self) -> tuple[str, ...]:
        """Those of them in which nothing outside the program moves."""
        return tuple(sorted(self._simulated))

    # Devices

    def grant(self, name: str, device: str) -> command.DeviceGrant:
        """Claim a device for a processing unit; raises ValueError with the reason."""
        world, _ = split(device)
        if world not in self._opened:
            self._open(world)
        self._epoch += 1
        try:
            answer = self.ask(world, device_messages.ClaimDevice(device, self._epoch), PATIENCE_S)
        except ValueError:  # granted late, it would be nobody's for ever
            if not self._devices.is_lost:
                self._devices.send(world, device_messages.FenceWriter(self._epoch))
            raise
        if isinstance(answer, device_messages.Denied):
            raise ValueError(answer.reason)
        if not isinstance(answer, device_messages.Granted):
            raise ValueError(Reason.of("host.does_not_grant", device=device))
        self._claims[device] = (self._epoch, name)
        return answer.grant

    def release(self, device: str) -> None:
        """Give a device back."""
        epoch, _ = self._claims.pop(device, (0, ""))  # a camera may be given back more than once
        world, _ = split(device)
        self._devices.send(world, device_messages.ReleaseDevice(device, epoch))

    def fence(self, unit: str) -> None:
        """A processing unit is gone: the drives whose writers died with it trip."""
        homes = {device: home for device, (_, home) in self._claims.items()}
        for device in dead_writers(unit, homes):
            epoch, _ = self._claims[device]
            world, _ = split(device)
            self._devices.send(world, device_messages.FenceWriter(epoch))

    # What is done to worlds, and asked of them

    def touch(self, world: str, part: str, value: float) -> None:
        """Touch a part of an open world; raises ValueError with the reason why not."""
        refuse_unknown(world, self.names)
        answer = self.ask(world, device_messages.TouchPart(world, part, value))
        if isinstance(answer, device_messages.Denied):
            raise ValueError(answer.reason)

    def put_back(self, world: str) -> None:
        """Everything in a world to where it stood at the start; raises ValueError where only a person can do that."""
        refuse_unknown(world, self.names)
        answer = self.ask(world, device_messages.PutWorldBack(world))
        if isinstance(answer, device_messages.Denied):
            raise ValueError(answer.reason)

    def displaced(self) -> dict[str, tuple[Displacement, ...]]:
        """What does not stand where it stood at the start, by world."""
        answers = self._answers(device_messages.TakeDisplaced(), device_messages.DisplacedTaken)
        return {world: reasons for answer in answers for world, reasons in answer.displaced.items()}

    def snapshots(self) -> dict[str, bytes]:
        """The worlds as they stand."""
        return {world: snapshot for taken in self._taken() for world, snapshot in taken.snapshots.items()}

    def standings(self) -> dict[str, tuple[Reason, ...]]:
        """What the worlds say of how they stand."""
        return {world: sentences for taken in self._taken() for world, sentences in taken.standings.items()}

    def ask(self, world: str, order: device_messages.Order, patience_s: float = ANSWER_S) -> device_messages.Word:
        """What the server of a world answers; raises ValueError where it does not."""
        self._devices.send(world, order)
        return self._answer(world, patience_s)

    def close(self) -> None:
        """Give the memory of all worlds back."""
        for segment in self._segments:
            segment.close()

    # Inner

    def _open(self, world: str) -> None:
        files = self._sources.find(world)
        refuse_unoffered(world, files)
        try:
            segment = Segment.create(f"bus-{world}", SEGMENT_SIZE)
            handed = [packed(files)] if files is not None else []
        except SharedMemoryRefused as refused:
            raise ValueError(reason_of(refused)) from None
        self._segments.append(segment)
        server = self._devices.of(world)
        self._wait(lambda: server.is_up, Reason.of("host.the_processes_to_start"), PATIENCE_S)
        self._devices.send(world, device_messages.OpenWorld(world), (segment.fd, *(memory.fd for memory in handed)))
        answer = self._answer(world, PATIENCE_S)
        if isinstance(answer, device_messages.Denied):
            raise ValueError(answer.reason)
        self._opened[world] = self._sources.digest(world)
        if isinstance(answer, device_messages.WorldOpened) and answer.is_simulated:
            self._simulated.add(world)
        self._share(f"bus:{world}", segment)

    def _taken(self) -> list[device_messages.SnapshotsTaken]:
        return self._answers(device_messages.TakeSnapshots(), device_messages.SnapshotsTaken)

    def _answers(self, order: device_messages.Order, kind: type[_Answer]) -> list[_Answer]:
        """What the servers of all open worlds answer; nothing where one does not any more."""
        if self._devices.is_lost:
            return []
        try:
            answers = [self.ask(world, order) for world in self.names]
        except ValueError:
            return []
        return [answer for answer in answers if isinstance(answer, kind)]

    def _answer(self, world: str, patience_s: float) -> device_messages.Word:
        waited_for = Reason.of("host.the_device_server_to_answer")
        try:
            self._wait(lambda: self._devices.has_answered(world), waited_for, patience_s)
        except ValueError:
            self._devices.give_up(world)
            raise
        return self._devices.take_answer(world)
