"""A device server as a process: steps its worlds, each on its own absolute grid of wall time (law 16)."""

import argparse
import select
import signal
import socket
import sys
from time import monotonic_ns
from typing import Any

from msgspec import Struct, msgpack

from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.preloaded_libraries import preload
from onika.host.processes.process_socket import ProcessSocket
from onika.host.processes.realtime_scheduling import become_real_time
from onika.host.units.heartbeat import Heartbeat
from onika.host.units.pose_stream import PoseStream, WorldPoses
from onika.host.units.served_worlds import ServedWorlds
from onika.host.units.waiting_orders import WaitingOrders
from onika.host.units.world_registry import open_world
from onika.host.units.world_sources import unpacked
from onika.link.launcher import die_with_parent
from onika.ring.device import DriveEvent
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.runtime.command import DeviceGrant
from onika.wire.world_source import WorldSource
from onika.words.reason import NOTHING, Reason, reason_of

_LONGEST_SLEEP_S = 0.02


class OpenWorld(Struct, frozen=True, tag=True):
    """Open a world; the memory of its bus comes with this datagram, and its files where it is made of some."""

    world: str


class ClaimDevice(Struct, frozen=True, tag=True):
    """Grant `world:device` to the writer of this epoch."""

    device: str
    epoch: int


class ReleaseDevice(Struct, frozen=True, tag=True):
    """The claim ends."""

    device: str
    epoch: int


class FenceWriter(Struct, frozen=True, tag=True):
    """The writer of this epoch is dead."""

    epoch: int


class StopAll(Struct, frozen=True, tag=True):
    """Every drive in hold, latched (law 27)."""


class AllowMotion(Struct, frozen=True, tag=True):
    """After a stop: commands are heard again; nothing moves by itself."""


class TouchPart(Struct, frozen=True, tag=True):
    """A hand touches a part of a world."""

    world: str
    part: str
    value: float


class PutWorldBack(Struct, frozen=True, tag=True):
    """Everything in a world goes to where it stood at the start."""

    world: str


class TakeDisplaced(Struct, frozen=True, tag=True):
    """Ask what does not stand where it stood at the start."""


class TakeModes(Struct, frozen=True, tag=True):
    """Ask how every drive stands from within."""


class TakeSnapshots(Struct, frozen=True, tag=True):
    """Ask for the worlds as they stand."""


class DescribeWorld(Struct, frozen=True, tag=True):
    """Ask what a world consists of."""

    world: str


class StreamPoses(Struct, frozen=True, tag=True):
    """From now on tell the poses of a world, 30 times a second; to the socket that comes with this datagram, if any."""

    world: str


class ShowCamera(Struct, frozen=True, tag=True):
    """From now on tell the pictures of a camera as they come, or no more."""

    world: str
    camera: str
    is_shown: bool


class Granted(Struct, frozen=True, tag=True):
    """The answer to a Claim."""

    grant: DeviceGrant


class Denied(Struct, frozen=True, tag=True):
    """The answer to an Open, a Claim, a Touch or a PutWorldBack that cannot be."""

    reason: Reason


class WorldOpened(Struct, frozen=True, tag=True):
    """The world is there and steps; in a simulated one nothing outside the program moves."""

    world: str
    is_simulated: bool


class PartTouched(Struct, frozen=True, tag=True):
    """The answer to a Touch."""


class WorldPutBack(Struct, frozen=True, tag=True):
    """The answer to PutWorldBack: it is as at the start."""


class DisplacedTaken(Struct, frozen=True, tag=True):
    """The answer to TakeDisplaced, by world."""

    displaced: dict[str, tuple[Displacement, ...]]


class DriveChanged(Struct, frozen=True, tag=True):
    """A drive has changed its state."""

    world: str
    device: str
    state: int
    at_ns: int
    previous_step_ns: int
    last_command_ns: int
    cause: Reason
    behind_ns: int = 0
    """How far the world's time is behind the runtime's."""
    stands: Reason = NOTHING
    touches: tuple[Reason, ...] = ()


class ModesTaken(Struct, frozen=True, tag=True):
    """The answer to TakeModes, by `world:device`."""

    modes: dict[str, DriveMode]


class SnapshotsTaken(Struct, frozen=True, tag=True):
    """The answer to TakeSnapshots, with what the worlds say in sentences of how they stand."""

    snapshots: dict[str, bytes]
    standings: dict[str, tuple[Reason, ...]] = {}


class WorldDescribed(Struct, frozen=True, tag=True):
    """The answer to Show."""

    scene: dict[str, Any]


class PictureTaken(Struct, frozen=True, tag=True):
    """A picture of a camera at which somebody looks, as JPEG or PNG."""

    world: str
    camera: str
    number: int
    taken_ns: int
    file: bytes


class ServerReady(Struct, frozen=True, tag=True):
    """The process is up; what the operating system granted it."""

    granted: dict[str, bool]


Order = (
    OpenWorld
    | ClaimDevice
    | ReleaseDevice
    | FenceWriter
    | StopAll
    | AllowMotion
    | TouchPart
    | PutWorldBack
    | TakeDisplaced
    | TakeModes
    | TakeSnapshots
    | DescribeWorld
    | StreamPoses
    | ShowCamera
)
Word = (
    Granted
    | Denied
    | WorldOpened
    | PartTouched
    | WorldPutBack
    | DisplacedTaken
    | DriveChanged
    | ModesTaken
    | SnapshotsTaken
    | WorldDescribed
    | WorldPoses
    | PictureTaken
    | ServerReady
)

encode = msgpack.Encoder().encode
_Question = (
    OpenWorld | ClaimDevice | TouchPart | PutWorldBack | DescribeWorld | TakeDisplaced | TakeModes | TakeSnapshots
)
"""What is answered, in the order in which it was asked."""

decode_order = msgpack.Decoder(Order).decode
decode_word = msgpack.Decoder(Word).decode


class DeviceServer:
    """The loop around the worlds."""

    def __init__(self, post: ProcessSocket, heartbeat: Heartbeat, zero_ns: int) -> None:
        self._post = post
        self._heartbeat = heartbeat
        self._zero = zero_ns
        self._worlds = ServedWorlds(open_world)
        self._posing: dict[str, PoseStream] = {}
        self._waiting: WaitingOrders[tuple[Order, list[int]]] = WaitingOrders()

    def run(self) -> None:
        """Until the runtime is gone."""
        while not self._post.is_closed:
            self._heartbeat.beat()
            self._rest()
            self._take_orders()
            for name in self._worlds.names:
                self._step(name)
        for posing in self._posing.values():
            posing.close()

    def _now(self) -> int:
        return monotonic_ns() - self._zero

    def _rest(self) -> None:
        due = self._worlds.due_ns()
        wait = _LONGEST_SLEEP_S if due is None else min(_LONGEST_SLEEP_S, (due - self._now()) * 1e-9)
        if wait > 0:
            select.select([self._post], [self._post] if self._post.is_waiting else [], [], wait)

    def _step(self, name: str) -> None:
        now = self._now()
        for event in self._worlds.step(name, now):
            self._post.send(encode(_driven(name, event, self._worlds.behind_ns(name))))
        for camera, picture in self._worlds.take_small(name).items():
            self._post.send(encode(PictureTaken(name, camera, *picture)))
        if name in self._posing and self._posing[name].is_due(now):
            self._posing[name].tell(now, *self._worlds.poses(name))

    def _take_orders(self) -> None:
        if self._post.is_waiting:
            self._post.flush()
        while (waited := self._waiting.take()) is not None:
            self._answer(*waited)
        while (received := self._post.receive()) is not None:
            self._take(decode_order(received[0]), received[1])

    def _take(self, order: Order, descriptors: list[int]) -> None:
        """Carry an order out, or let it wait: another robot is made ready beside the loop, the worlds go on."""
        work = self._worlds.preparation(order.device) if isinstance(order, ClaimDevice) and not self._waiting else None
        if work is not None:
            self._waiting.begin(work)
        if work is not None or (self._waiting and isinstance(order, _Question)):
            self._waiting.put((order, descriptors))
        else:
            self._answer(order, descriptors)

    def _answer(self, order: Order, descriptors: list[int]) -> None:
        answer = self._carry_out(order, descriptors)
        if answer is not None:
            self._post.send(encode(answer))

    def _carry_out(self, order: Order, descriptors: list[int]) -> Word | None:
        match order:
            case OpenWorld() | ClaimDevice() | TouchPart() | PutWorldBack():
                return self._try(order, descriptors)
            case ReleaseDevice():
                self._worlds.release(order.device, order.epoch)
            case FenceWriter():
                self._worlds.fence(order.epoch)
            case StopAll():
                self._worlds.stop()
            case AllowMotion():
                self._worlds.go_on()
            case StreamPoses():
                post = ProcessSocket(socket.socket(fileno=descriptors[0])) if descriptors else self._post
                self._posing.setdefault(order.world, PoseStream(order.world)).add(post)
            case ShowCamera():
                self._worlds.show(order.world, order.camera, order.is_shown)
            case DescribeWorld() | TakeDisplaced() | TakeModes() | TakeSnapshots():
                return self._look(order)
        return None

    def _try(self, order: OpenWorld | ClaimDevice | TouchPart | PutWorldBack, descriptors: list[int]) -> Word:
        """What may be denied."""
        try:
            match order:
                case OpenWorld():
                    files = unpacked(descriptors[1]) if len(descriptors) > 1 else None
                    return self._open(order.world, Segment.attach(descriptors[0]), files)
                case ClaimDevice():
                    return Granted(self._worlds.grant(order.device, order.epoch))
                case TouchPart():
                    self._worlds.touch(order.world, order.part, order.value)
                    return PartTouched()
                case PutWorldBack():
                    self._worlds.put_back(order.world)
                    return WorldPutBack()
        except ValueError as wrong:
            return Denied(reason_of(wrong))

    def _open(self, world: str, segment: Segment, files: WorldSource | None) -> WorldOpened:
        """To open a world may take long, as may what there is to draw of large meshes; nothing moves in it yet."""
        self._heartbeat.is_slow(True)
        try:
            is_simulated = self._worlds.open(world, segment, self._now(), files)
            self._worlds.scene(world)  # now: whoever looks later must not let it stand still
            return WorldOpened(world, is_simulated)
        finally:
            self._heartbeat.beat()
            self._heartbeat.is_slow(False)

    def _look(self, order: DescribeWorld | TakeDisplaced | TakeModes | TakeSnapshots) -> Word:
        """What a world consists of, or what all of them are like now."""
        if isinstance(order, DescribeWorld):
            scene = self._worlds.scene(order.world)
            return Denied(Reason.of("host.not_open")) if scene is None else WorldDescribed(scene)
        if isinstance(order, TakeSnapshots):
            return SnapshotsTaken(self._worlds.snapshots(), self._worlds.standings())
        if isinstance(order, TakeDisplaced):
            return DisplacedTaken(self._worlds.displaced())
        return ModesTaken(self._worlds.modes())


def _driven(world: str, drive_event: DriveEvent, behind_ns: int) -> DriveChanged:
    times = drive_event.at_ns, drive_event.previous_step_ns, drive_event.last_command_ns
    said = drive_event.stands, drive_event.touches
    return DriveChanged(world, drive_event.device, int(drive_event.state), *times, drive_event.cause, behind_ns, *said)


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    for option in ("--fd", "--beat-fd", "--zero", "--parent"):
        parser.add_argument(option, type=int, required=True)
    parser.add_argument("--fifo", action="store_true")
    given = parser.parse_args(words)
    die_with_parent(given.parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_output_pipes()
    preload()
    post = ProcessSocket(socket.socket(fileno=given.fd))
    heartbeat = Heartbeat(Segment.attach(given.beat_fd))
    server = DeviceServer(post, heartbeat, given.zero)
    granted = become_real_time(given.fifo)
    heartbeat.beat()  # before it is said to be up: from then on silence counts
    post.send(encode(ServerReady(granted)))
    server.run()


if __name__ == "__main__":
    main(sys.argv[1:])
