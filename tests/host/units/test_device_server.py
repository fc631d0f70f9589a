import os
import select
import threading
from time import monotonic_ns

import numpy as np
import pytest

from kit.worlds.eyed_world import EyedWorld
from kit.worlds.mass_world import MassWorld
from onika.host.processes.process_socket import ProcessSocket
from onika.host.units import device_messages as room
from onika.host.units.device_server import DeviceServer
from onika.host.units.heartbeat import SIZE, Heartbeat
from onika.ring.device import DeviceOrder, DriveState
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.ring.slots import Ring
from onika.runtime.bus import SEGMENT_SIZE
from onika.words.reason import NOTHING, Reason


def open_world(name):
    if name != "yard":
        raise ValueError(f"expected a world (yard), found {name!r}")
    return MassWorld()


class Server:
    """A device server in a thread, and the other end of its post."""

    def __init__(self):
        self.post, theirs = ProcessSocket.pair()
        self._theirs = ProcessSocket(theirs)
        beat = Segment.create("beat", SIZE)
        self.heartbeat = Heartbeat(beat)
        self.bus = Segment.create("bus", SEGMENT_SIZE)
        server = DeviceServer(self._theirs, Heartbeat(Segment.attach(os.dup(beat.fd))), monotonic_ns())
        self.thread = threading.Thread(target=server.run)
        self.thread.start()

    def say(self, order, descriptors=()):
        self.post.send(room.encode(order), descriptors)

    def hear(self, kind):
        """The next word of a kind."""
        while True:
            received = self.post.receive()
            if received is None:
                assert select.select([self.post], [], [], 20.0)[0], f"no {kind}"
                continue
            word = room.decode_word(received[0])
            if isinstance(word, kind):
                return word

    def ask(self, order, kind, descriptors=()):
        self.say(order, descriptors)
        return self.hear(kind)

    def open(self):
        return self.ask(room.OpenWorld("yard"), room.WorldOpened, (self.bus.fd,))

    def claim(self, epoch=1):
        return self.ask(room.ClaimDevice("yard:m0", epoch), room.Granted).grant

    def command(self, grant, *values, order=DeviceOrder.DRIVE):
        data = np.array([grant.epoch, order, *values])
        Ring(self.bus.view, grant.command_offset, data.nbytes).write(data.tobytes())

    def state(self, grant):
        return np.frombuffer(Ring(self.bus.view, grant.state_offset, 8 * len(grant.state)).read())

    def close(self):
        self.post.close()
        self.thread.join(20.0)
        assert not self.thread.is_alive()
        self._theirs.close()


class Readied:
    """Another robot that is worked out at once, and taken over when it may be."""

    def __init__(self, may_be_taken):
        self._may_be_taken = may_be_taken

    def work_out(self):
        return b"a model"

    def take(self, worked_out):
        assert worked_out == b"a model"
        self._may_be_taken.wait()


@pytest.fixture
def server(monkeypatch):
    monkeypatch.setattr("onika.host.units.device_server.open_world", open_world)
    server = Server()
    yield server
    server.close()


def test_a_world_is_opened_and_steps_on_the_grid_of_wall_time(server):  # law 16
    assert server.open() == room.WorldOpened("yard", False)
    grant = server.claim()
    first = server.state(grant)[0]
    while server.state(grant)[0] < first + 0.05:
        pass
    assert server.heartbeat.last_ns > 0


def test_what_there_is_to_draw_is_worked_out_before_anything_moves(server, monkeypatch):  # law 16, R-X19
    orders = []
    monkeypatch.setattr(MassWorld, "scene", lambda world: orders.append("scene") or [])
    monkeypatch.setattr(MassWorld, "step", lambda world, until_ns: orders.append("step"))
    server.open()
    while "step" not in orders:
        pass
    assert orders[:2] == ["scene", "step"]


def test_a_command_drives_and_silence_holds(server):  # laws 16, 17
    server.open()
    grant = server.claim()
    server.command(grant, 1.0)
    driven, held = server.hear(room.DriveChanged), server.hear(room.DriveChanged)
    assert (driven.world, driven.device, driven.state, str(driven.cause)) == ("yard", "m0", 0, "DRIVE")
    assert (held.state, str(held.cause)) == (1, "silence")
    assert held.previous_step_ns - held.last_command_ns <= 50_000_000 < held.at_ns - held.last_command_ns


def test_where_a_drive_holds_and_what_is_in_its_way_is_passed_on(server, monkeypatch):  # R-X06
    stands, touches = Reason.plain("m0 stands at 1 m"), (Reason.plain("m0 touches m1"),)
    monkeypatch.setattr(MassWorld, "halt", (stands, touches))
    server.open()
    server.command(server.claim(), 1.0)
    driven, held = server.hear(room.DriveChanged), server.hear(room.DriveChanged)
    assert ((driven.stands, driven.touches), (held.stands, held.touches)) == ((NOTHING, ()), (stands, touches))


def test_a_device_is_granted_to_one_writer_until_it_is_released(server):  # law 16
    server.open()
    server.claim(1)
    assert "claimed already" in str(server.ask(room.ClaimDevice("yard:m0", 2), room.Denied).reason)
    server.say(room.ReleaseDevice("yard:m0", 1))
    assert server.claim(3).epoch == 3


def test_a_world_steps_on_while_another_robot_is_made_ready_and_a_stop_gets_through(server, monkeypatch):  # laws 16, 27
    ready, stopped = threading.Event(), threading.Event()
    server.open()
    grant = server.claim()
    monkeypatch.setattr(
        MassWorld, "preparation", lambda world, name: Readied(ready) if name == "m1" else None, raising=False
    )
    former = MassWorld.stop
    monkeypatch.setattr(MassWorld, "stop", lambda world: former(world) or stopped.set())
    server.say(room.ClaimDevice("yard:m1", 2))
    server.say(room.TakeModes())
    time = server.state(grant)[0]
    while server.state(grant)[0] < time + 0.05:
        server.command(grant, 0.0)
    server.say(room.StopAll())
    assert stopped.wait(20.0)
    ready.set()
    words = [server.hear((room.Granted, room.ModesTaken)) for _ in range(2)]
    assert [type(word) for word in words] == [room.Granted, room.ModesTaken]


def test_a_dead_writer_is_fenced_and_its_devices_trip(server):  # law 17
    server.open()
    grant = server.claim()
    server.command(grant, 1.0)
    assert server.hear(room.DriveChanged).state == 0
    server.say(room.FenceWriter(grant.epoch))
    tripped = server.hear(room.DriveChanged)
    assert (tripped.state, str(tripped.cause)) == (2, "its writer died")


def test_a_stop_holds_everything(server):  # law 27
    server.open()
    grant = server.claim()
    server.command(grant, 1.0)
    server.hear(room.DriveChanged)
    server.say(room.StopAll())
    assert str(server.hear(room.DriveChanged).cause) == "stop"


def test_a_part_is_touched_and_an_unknown_one_denied(server):  # R-K06
    server.open()
    grant = server.claim()
    server.command(grant, 1.0)
    assert server.hear(room.DriveChanged).state == DriveState.DRIVEN
    assert server.ask(room.TouchPart("yard", "panic", 1.0), room.PartTouched) == room.PartTouched()
    assert server.hear(room.DriveChanged).state == DriveState.PRESSED
    assert "found 1 for 'bell'" in str(server.ask(room.TouchPart("yard", "bell", 1.0), room.Denied).reason)


def test_what_is_not_there_is_denied_with_what_is(server):  # law 16
    denied = server.ask(room.OpenWorld("sea"), room.Denied, (server.bus.fd,))
    assert str(denied.reason) == "expected a world (yard), found 'sea'"
    server.open()
    assert "m0" in str(server.ask(room.ClaimDevice("yard:m9", 1), room.Denied).reason)


def test_the_worlds_can_be_drawn(server):
    assert server.ask(room.TakeSnapshots(), room.SnapshotsTaken).snapshots == {}
    server.open()
    assert server.ask(room.TakeSnapshots(), room.SnapshotsTaken).snapshots.keys() == {"yard"}


def test_after_a_stall_the_world_loses_time_and_does_not_run_after_it(server, monkeypatch):  # law 13
    server.open()
    grant = server.claim()
    now = monotonic_ns
    ten_s = 10_000_000_000  # gone by at once
    monkeypatch.setattr("onika.host.units.device_server.monotonic_ns", lambda: now() + ten_s)
    for _ in range(3):
        server.ask(room.TakeSnapshots(), room.SnapshotsTaken)
    assert server.state(grant)[0] < 5.0


def test_it_ends_with_the_runtime(server):  # law 31
    server.post.close()
    server.thread.join(20.0)
    assert not server.thread.is_alive()


def test_poses_are_told_to_whoever_brings_a_socket_and_not_to_the_runner(server):  # law 29: it is woken for nothing
    server.open()
    near, far = ProcessSocket.pair()
    server.say(room.StreamPoses("yard"), (far.fileno(),))
    assert select.select([near], [], [], 20.0)[0]
    assert room.decode_word(near.receive()[0]).world == "yard"
    near.close()
    far.close()
    server.say(room.TouchPart("yard", "bell", 1.0))
    assert isinstance(server.hear(room.Word.__args__), room.Denied)


def test_it_says_how_every_drive_stands(server):  # R-X24, law 17
    server.open()
    server.claim()
    assert server.ask(room.TakeModes(), room.ModesTaken).modes == {"yard:m0": DriveMode.HELD, "yard:m1": DriveMode.HELD}
    server.say(room.StopAll())
    assert set(server.ask(room.TakeModes(), room.ModesTaken).modes.values()) == {DriveMode.STOPPED}


def test_a_world_that_nobody_can_put_back_is_denied_and_says_nothing_of_its_places(server):  # law 18
    server.open()
    assert "by hand" in str(server.ask(room.PutWorldBack("yard"), room.Denied).reason)
    assert server.ask(room.TakeDisplaced(), room.DisplacedTaken).displaced == {"yard": ()}


def test_pictures_are_told_while_somebody_looks(server, monkeypatch):  # R-F08
    monkeypatch.setattr(f"{__name__}.MassWorld", EyedWorld)
    server.open()
    server.say(room.ShowCamera("yard", "eye", True))
    first, later = (server.hear(room.PictureTaken) for _ in range(2))
    assert (later.world, later.camera, later.file) == ("yard", "eye", b"file")
    assert later.number > first.number
    server.say(room.ShowCamera("yard", "eye", False))
    server.ask(room.TakeModes(), room.ModesTaken)
    server.ask(room.TakeModes(), room.ModesTaken)
    assert server.post.receive() is None
