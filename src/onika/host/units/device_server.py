"""A device server as a process: steps its worlds, each on its own absolute grid of wall time (law 16)."""

import argparse
import select
import signal
import socket
import sys
from time import monotonic_ns

from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.preloaded_libraries import preload
from onika.host.processes.process_socket import ProcessSocket
from onika.host.processes.realtime_scheduling import become_real_time
from onika.host.units.device_messages import (
    AllowMotion,
    ClaimDevice,
    Denied,
    DescribeWorld,
    DisplacedTaken,
    DriveChanged,
    FenceWriter,
    Granted,
    ModesTaken,
    OpenWorld,
    Order,
    PartTouched,
    PictureTaken,
    PutWorldBack,
    Question,
    ReleaseDevice,
    ServerReady,
    ShowCamera,
    SnapshotsTaken,
    StopAll,
    StreamPoses,
    TakeDisplaced,
    TakeModes,
    TakeSnapshots,
    TouchPart,
    Word,
    WorldDescribed,
    WorldOpened,
    WorldPutBack,
    decode_order,
    encode,
)
from onika.host.units.heartbeat import Heartbeat
from onika.host.units.pose_stream import PoseStream
from onika.host.units.served_worlds import ServedWorlds
from onika.host.units.waiting_orders import WaitingOrders
from onika.host.units.world_registry import open_world
from onika.host.units.world_sources import unpacked
from onika.link.child.launcher import die_with_parent
from onika.ring.device import DriveEvent
from onika.ring.segment import Segment
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason, reason_of

_LONGEST_SLEEP_S = 0.02


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
        if work is not None or (self._waiting and isinstance(order, Question)):
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
