"""The virtual driver: all RTPUs and worlds of a runtime, stepped in one process by one clock (law 1)."""

import hashlib
import select
from collections import deque
from collections.abc import Callable, Sequence
from time import monotonic_ns

from onika.host.runner import Runner
from onika.host.worlds import open_world, split
from onika.ring.device import Drive, DriveEvent
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.bus import SEGMENT_SIZE, Bus, World
from onika.runtime.executive import Executive
from onika.wire import event

_HASHED_EVERY_NS = 50_000_000  # what differs once differs ever after: to look at every step would only cost

_AT_ONCE = 1000  # cycles without news that are run before anybody is asked


class VirtualDriver:
    """As fast as the processor allows, and bit for bit the same every time: nothing here depends on wall time.

    The tasks of all RTPUs are carried out by one executive, so that at one instant the order of law 1 holds among them
    all, whichever unit they are on.
    """

    def __init__(
        self,
        rtpus: Sequence[str],
        tell: Callable[[event.Event], None],
        worlds: Callable[[str], World] = open_world,
        watch: Callable[[str], None] = lambda _task: None,
    ) -> None:
        self._now = 0
        self._worlds = worlds
        self._tell = tell
        self._views: dict[str, memoryview] = {}
        self._rtpus = frozenset(rtpus)
        self._executive = Executive("", self._views, watch)
        self._homes: dict[tuple[str, str], str] = {}
        self._statuses: dict[str, news.Statuses] = {}
        self._commands: deque[tuple[str, command.Command]] = deque()
        self._buses: dict[str, Bus] = {}
        self._claims: dict[str, int] = {}
        self._epoch = 0
        self._runner: Runner | None = None
        self._hash = hashlib.sha256()
        self._hash_at = 0

    @property
    def now(self) -> int:
        """Virtual nanoseconds since this runtime's start."""
        return self._now

    # Units, as the runner sees them

    def send(self, rtpu: str, order: command.Command) -> None:
        """Give an RTPU a command; it is carried out before the next cycle."""
        self._commands.append((rtpu, order))

    def grant(self, rtpu: str, device: str) -> command.DeviceGrant:
        """Claim a device for a task; the world is opened with its first device."""
        world, name = split(device)
        bus = self._bus(world)
        self._epoch += 1
        self._claims[device] = self._epoch
        return bus.grant(name, self._epoch)

    def release(self, device: str) -> None:
        """Give a device back."""
        world, name = split(device)
        self._buses[world].release(name, self._claims.pop(device))

    # A run

    def share(self, name: str, segment: Segment) -> None:
        """Let the RTPUs see a table."""
        self._views[name] = segment.view

    def begin(self, runner: Runner) -> None:
        """Start a run at the present time."""
        self._runner = runner
        self._hash = hashlib.sha256()
        self._hash_at = self._now
        runner.start(self._now)
        self._deliver()

    def advance(self, wall_ns: int) -> bool:
        """Run for about so much wall time; False when there is nothing to do until somebody says something."""
        runner, until = self._runner, monotonic_ns() + wall_ns
        if runner is None:
            return False
        while not runner.is_over:
            if self._commands:
                self._deliver()
            if runner.is_asking or not self._instant(runner):
                return False
            if monotonic_ns() > until:
                return True
        return False

    def abort(self, cause: str) -> None:
        """End the run; what has to happen at once happens at the present time."""
        if self._runner is not None:
            self._runner.abort(cause, self._now)
            self._deliver()

    def answer(self, subsystem: str, task: str, line: str) -> None:
        """The user's answer."""
        if self._runner is not None:
            self._runner.answer(subsystem, task, line)
            self._deliver()

    def stop(self) -> None:
        """Everything off and every drive in hold, latched (law 27)."""
        for bus in self._buses.values():
            bus.world.stop()
        for name in sorted(self._rtpus):
            self.send(name, command.Stop("stop"))
        self._deliver()

    @property
    def digest(self) -> str:
        """Of everything that happened in this run: the worlds every 50 ms and every word to the runner."""
        return self._hash.hexdigest()

    def is_at_rest(self) -> bool:
        """Steps the worlds once, so that the last commands act; then every drive holds."""
        for name, bus in self._buses.items():
            bus.step(bus.world.now_ns + bus.world.step_ns)
            self._tell_drives(name, bus.world.take_events())
        return True

    def snapshots(self) -> dict[str, bytes]:
        """The worlds as they stand."""
        return {name: bus.world.snapshot() for name, bus in self._buses.items()}

    # Inner

    def _instant(self, runner: Runner) -> bool:
        """Worlds step to the next instant, then everything that is due at it runs; False when nothing ever is."""
        now = wake = runner.wake_at()
        release = self._executive.next_release()
        if release is not None and (now is None or release < now):
            now = release
        if now is None:
            return False
        if now > self._now:
            self._step(now)
        if now == wake:
            runner.tick(now)
            self._deliver()
        self._take_events()
        while (heard := self._executive.run_due(now, _AT_ONCE)) is not None:
            self._hear(heard)
            self._deliver()
        return True

    def _take_events(self) -> None:
        """Events of synchronous tasks from outside, as they are there at this instant; they repeat with no seed."""
        events = self._executive.events()
        if events:
            for descriptor in select.select(list(events), [], [], 0)[0]:
                self._hear(self._executive.event(events[descriptor], self._now))
                self._deliver()

    def _step(self, now: int) -> None:
        """All worlds step to this time."""
        self._now = now
        for name, bus in self._buses.items():
            bus.step(now)
            events = bus.world.take_events()
            if events:
                self._tell_drives(name, events)
        if now >= self._hash_at:
            self._hash_at = now + _HASHED_EVERY_NS
            for bus in self._buses.values():
                self._hash.update(bus.world.fingerprint())

    def _deliver(self) -> None:
        """Carry out commands until none is left; what they lead to is heard at the same instant."""
        while self._commands:
            rtpu, order = self._commands.popleft()
            if isinstance(order, command.Spawn):
                self._homes[order.subsystem, order.task] = rtpu
            if isinstance(order, command.Report):
                self._hear([self._statuses_of(rtpu)])
            else:
                self._hear(self._executive.handle(order, self._now))

    def _hear(self, heard: Sequence[news.News]) -> None:
        for one in heard:
            rtpu = one.rtpu if isinstance(one, news.Statuses) else self._homes.get((one.subsystem, one.task), "")
            if not isinstance(one, news.Statuses):  # its times are of the wall
                self._hash.update(news.encode(one))
            if self._runner is not None:
                self._runner.hear(rtpu, one, self._now)

    def _statuses_of(self, rtpu: str) -> news.Statuses:
        """One unit's share of the statuses, which are taken of all units at once."""
        if rtpu not in self._statuses:
            for one in self._executive.handle(command.Report(), self._now):
                if isinstance(one, news.Statuses):
                    self._statuses = {name: self._share(one, name) for name in self._rtpus}
        return self._statuses.pop(rtpu)

    def _share(self, statuses: news.Statuses, rtpu: str) -> news.Statuses:
        own = tuple(one for one in statuses.tasks if self._homes.get((one.subsystem, one.task)) == rtpu)
        return news.Statuses(rtpu, statuses.load, own)

    def _bus(self, world: str) -> Bus:
        if world not in self._buses:
            segment = Segment.create(f"bus-{world}", SEGMENT_SIZE)
            self._views[f"bus:{world}"] = segment.view
            bus = Bus(world, self._worlds(world), segment)
            bus.step(self._now)
            self._buses[world] = bus
        return self._buses[world]

    def _tell_drives(self, world: str, events: Sequence[DriveEvent]) -> None:
        for one in events:
            self._tell(
                event.Drive(
                    f"{world}:{one.device}",
                    Drive(one.state).name,
                    one.at_ns,
                    one.previous_step_ns,
                    one.last_command_ns,
                    one.cause,
                )
            )
