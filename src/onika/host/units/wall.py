"""The wall driver: RTPUs and device servers as processes, the runner between them, in wall time (law 30)."""

import select
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from time import monotonic_ns

from onika.host.units import device_messages, rtpu
from onika.host.units.device_servers import DeviceServers
from onika.host.units.opened_worlds import PATIENCE_S, OpenedWorlds
from onika.host.units.pose_stream import WorldPoses
from onika.host.units.served_views import ServedViews
from onika.host.units.supervisor import Supervised, Supervisor
from onika.host.units.unit_listener import UnitListener
from onika.host.units.unit_processes import UnitProcesses
from onika.ring.begin_words import BeginWords
from onika.ring.device import DriveState
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.wire import event
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason


class WallDriver:
    """Waits for nothing but its processes and grants of devices, before anything moves.

    Raises ValueError with the reason where a process does not come up; then none is left.
    """

    def __init__(self, rtpus: Sequence[str], tell: Callable[[event.Event], None], with_fifo: bool) -> None:
        self._zero = monotonic_ns()
        self._tell = tell
        self.with_fifo = with_fifo
        self.turn = 0
        self.options: tuple[str, ...] = ()
        self._supervisor = Supervisor(self._zero, with_fifo)
        self._listener: UnitListener | None = None
        self._heard: deque[tuple[str, news.News]] = deque()
        self._drives: dict[str, int] = {}
        self.granted: dict[str, dict[str, bool]] = {}
        self._devices = DeviceServers(self._supervisor)
        self._units = UnitProcesses(self._supervisor, rtpus)
        self._worlds = OpenedWorlds(self._devices, self._await, self._units.share)
        self.views = ServedViews(self._devices, self._worlds.opened, self._worlds.ask)
        processes = self._supervisor.processes
        try:
            self._await(
                lambda: all(process.is_up for process in processes.values()),
                Reason.of("host.the_processes_to_start"),
                PATIENCE_S,
            )
        except BaseException:
            self.close()
            raise

    @property
    def digest(self) -> str:
        """Nothing: wall time never repeats."""
        return ""

    @property
    def outside(self) -> tuple[str, ...]:
        """Nobody: wall time never repeats in any case."""
        return ()

    @property
    def now(self) -> int:
        """Nanoseconds since this runtime's start."""
        return monotonic_ns() - self._zero

    def posts(self) -> list[Supervised]:
        """What to wait for in `select`."""
        return [process for process in self._supervisor.processes.values() if not process.is_lost]

    # Units, as the runner sees them

    def send(self, name: str, order: command.Command) -> None:
        """Give an RTPU a command."""
        self._units.send(name, order)

    def begin_words(self, rtpu: str) -> BeginWords:
        """By which a unit is let begin at an agreed time (law 34)."""
        return self._units.begin_words(rtpu)

    def grant(self, name: str, device: str) -> command.DeviceGrant:
        """Claim a device; raises ValueError with the reason."""
        return self._worlds.grant(name, device)

    def release(self, device: str) -> None:
        """Give a device back."""
        self._worlds.release(device)

    def add_unit(self, name: str, answer: Callable[[Reason], None]) -> None:
        """Launch a processing unit; answered with nothing when it is up, else with the reason. Nothing waits for it."""
        self._units.add(name, self.now, answer)

    def offer(self, worlds: Iterable[WorldSource]) -> None:
        """These worlds are files; they are opened when a device of them is granted."""
        self._worlds.offer(worlds)

    @property
    def opened(self) -> Mapping[str, str]:
        """The worlds that are open, each with what names the files that it was made of."""
        return self._worlds.opened

    def expect(self, worlds: Iterable[str]) -> None:
        """These worlds will be opened; nothing waits for what is prepared for that."""
        if not self._devices.is_lost:
            self._devices.expect(worlds)

    # A run

    @property
    def is_virtual(self) -> bool:
        """No."""
        return False

    @property
    def worlds(self) -> tuple[str, ...]:
        """The worlds that are open."""
        return self._worlds.names

    @property
    def simulated(self) -> tuple[str, ...]:
        """Those of them in which nothing outside the program moves."""
        return self._worlds.simulated

    def ask_modes(self, answer: Callable[[Mapping[str, DriveMode]], None]) -> None:
        """How every drive stands; answered when all device servers have said it, or one is gone: then with nothing."""
        self._devices.ask_modes(answer)

    def touch(self, world: str, part: str, value: float) -> None:
        """Touch a part of an open world; raises ValueError with the reason why not."""
        self._worlds.touch(world, part, value)

    def put_back(self, world: str) -> None:
        """Everything in a world to where it stood at the start; raises ValueError where only a person can do that."""
        self._worlds.put_back(world)

    def displaced(self) -> dict[str, tuple[Displacement, ...]]:
        """What does not stand where it stood at the start, by world."""
        return self._worlds.displaced()

    def unshare(self, name: str) -> None:
        """The table is not used any more."""
        self._units.unshare(name)

    def share(self, name: str, segment: Segment) -> None:
        """Let the RTPUs see a table, in place of an old one of this name."""
        self._units.share(name, segment)

    def listen(self, listener: UnitListener) -> None:
        """Tell this one what happens."""
        self._listener = listener

    def begin(self) -> None:
        """A run starts now; wall time has no digest."""

    def each_instant(self, look: Callable[[], None]) -> None:
        """Nobody is called: instants of wall time have no end."""

    def leave_instants(self, look: Callable[[], None]) -> None:
        """Nobody was called."""

    def advance(self, wall_ns: int) -> bool:
        """Let time pass; never waits. False: nothing has to be done before somebody says something."""
        del wall_ns
        self.look_after()
        if self._listener is not None:
            self._listener.tick(self.now)
        return False

    def look_after(self) -> None:
        """Take in what the processes say; end those that fail."""
        self._receive()
        self._units.answer_starts(self.now)
        lost = [gone for gone in self._supervisor.troubles() if not self._units.fail_start(*gone)]
        for supervised, reason in lost:
            if self._devices.is_one(supervised):
                self._lost(supervised, reason)  # it is why units complain of devices that are silent
        while self._heard and self._listener is not None:
            name, heard = self._heard.popleft()
            self._listener.hear(name, heard, self.now)
        for supervised, reason in lost:
            if not self._devices.is_one(supervised):
                self._lost(supervised, reason)  # after its last words

    def wait_s(self) -> float:
        """How long the loop may sleep before `advance` has something to do."""
        wake = self._listener.wake_at() if self._listener is not None else None
        if wake is None:
            return 0.05
        return min(max((wake - self.now) * 1e-9, 0.0), 0.05)

    def stop(self) -> None:
        """Every drive in hold and everything off, straight to the processes (law 27)."""
        self._devices.stop()
        self._units.stop()

    def reset(self) -> None:
        """After a stop: motion is allowed again; nothing moves by itself."""
        self._devices.allow_motion()
        self._units.reset()

    def is_at_rest(self) -> bool:
        """Whether every drive holds, as far as the device server lives to say so."""
        return self._devices.is_lost or DriveState.DRIVEN not in self._drives.values()

    def snapshots(self) -> dict[str, bytes]:
        """The worlds as they stand."""
        return self._worlds.snapshots()

    def standings(self) -> dict[str, tuple[Reason, ...]]:
        """What the worlds say of how they stand."""
        return self._worlds.standings()

    def watched(self) -> dict[str, bool]:
        """What happens that no program means is told in forecasts only: of each open world False."""
        return dict.fromkeys(self.worlds, False)

    def close(self) -> None:
        """End every process."""
        self._supervisor.end()
        self._units.close()
        self._worlds.close()

    # Inner

    def _receive(self) -> None:
        for post in self.posts():
            post.post.flush()
            while (received := post.post.receive()) is not None:
                if self._devices.is_one(post):
                    self._word(post, device_messages.decode_word(received[0]))
                else:
                    for decode_news in rtpu.decode_news(received[0]):
                        self._news(post, decode_news)

    def _news(self, supervised: Supervised, heard: rtpu.UnitReady | news.News) -> None:
        if isinstance(heard, rtpu.UnitReady):
            supervised.is_up = True
            self.granted[supervised.name] = heard.granted
        else:
            self._heard.append(
                (supervised.name, heard)
            )  # heard by the runner in its turn, never in the midst of an order

    def _word(self, supervised: Supervised, word: device_messages.Word) -> None:
        match word:
            case device_messages.ServerReady():
                supervised.is_up = True
                self.granted[supervised.name] = word.granted
            case device_messages.DriveChanged():
                self._drives[f"{word.world}:{word.device}"] = word.state
                self._tell(self._driven(word))
            case WorldPoses() | device_messages.PictureTaken():
                self.views.take(word)
            case _:
                self._devices.answered(supervised, word)

    def _driven(self, word: device_messages.DriveChanged) -> event.Drive:
        """In the world's time, and in that of the run that uses the drive."""
        device = f"{word.world}:{word.device}"
        began = self._listener.run_began(device) if self._listener is not None else 0
        at_s = round((word.at_ns + word.behind_ns - began) * 1e-9, 9)
        times = word.at_ns, word.previous_step_ns, word.last_command_ns
        return event.Drive(device, DriveState(word.state).name, *times, word.cause, at_s, word.stands, word.touches)

    def _lost(self, supervised: Supervised, reason: Reason) -> None:
        """A process is gone: fence its claims, let hardware tasks know, name the cause."""
        is_device_server = self._devices.is_one(supervised)
        if is_device_server:
            self._devices.lose()
            self._units.send_all(command.Fail(reason))
        else:
            self._worlds.fence(supervised.name)
        if self._listener is not None:
            unit = "" if is_device_server else supervised.name
            self._listener.lost(unit, reason, self.now)

    def _await(self, is_done: Callable[[], bool], what: Reason, patience_s: float) -> None:
        """Serve the posts until something is there; raises ValueError when it does not come."""
        until = monotonic_ns() + round(patience_s * 1e9)
        while not is_done():
            if self._devices.is_lost:
                raise ValueError(Reason.of("host.waits_in_vain", what=what))
            if monotonic_ns() > until:
                raise ValueError(Reason.of("host.waited", seconds=patience_s, what=what))
            select.select([post.post for post in self.posts()], [], [], 0.02)
            self._receive()
            trouble = self._supervisor.trouble(besides=self._units.starting)
            if trouble:
                raise ValueError(Reason.of("host.failed_meanwhile", why=trouble, what=what))
