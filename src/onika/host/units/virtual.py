"""The virtual driver: all RTPUs and worlds of a runtime, stepped in one process by one clock (law 1)."""

import select
from collections.abc import Callable, Iterable, Mapping, Sequence
from time import monotonic_ns

from msgspec import structs

from onika.host.units.realtime_factor import RealtimeFactor
from onika.host.units.run_digest import Digest
from onika.host.units.unit_listener import UnitListener
from onika.host.units.virtual_units import VirtualUnits
from onika.host.units.world_buses import Buses
from onika.host.units.world_registry import open_world
from onika.host.units.world_views import WorldViews
from onika.ring.begin_words import BeginWords
from onika.ring.displacement import Displacement
from onika.ring.drive import DriveMode
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.bus import World
from onika.wire import event
from onika.wire.world_source import WorldSource
from onika.words.reason import NOTHING, Reason

_LONGEST_STEP_NS = 1_000_000_000
"""How far worlds step at a time."""
_ROUNDS = 200
"""Tasks that run one after the other at one instant before somebody else is listened to: a loop whose jobs end as soon
as they begin takes no time at all, and it has to be possible to end it."""
_AT_ONCE = 1000  # cycles without news that are run before anybody is asked
_NOTHING_HAPPENED = (news.Statuses, news.Loads, news.Stepped)
"""Times of the wall, and what tells of what was looked at."""


class VirtualDriver:
    """As fast as the processor allows, and bit for bit the same every time: nothing here depends on wall time.

    The tasks of all RTPUs are carried out by one executive, so that at one instant the order of law 1 holds among them
    all, whichever unit they are on.
    """

    def __init__(
        self,
        rtpus: Sequence[str],
        tell: Callable[[event.Event], None],
        worlds: Callable[..., World] = open_world,
        watch: Callable[[str], None] = lambda _task: None,
        scale: float | None = None,
        *,
        watches_mishaps: bool = False,
    ) -> None:
        self._now = 0
        self._realtime_factor = None if scale is None else RealtimeFactor(scale, 0, monotonic_ns())
        self._views: dict[str, memoryview] = {}
        self._units = VirtualUnits(rtpus, self._views, watch)
        self._executive = self._units.executive
        tell_mishap = self._dated_mishaps(tell) if watches_mishaps else None
        self._buses = Buses(self._views, worlds, self._dated(tell), tell_mishap)
        self._listener: UnitListener | None = None
        self._digest = Digest()
        self.with_fifo = False
        self.options: tuple[str, ...] = ()
        """What the runtime was started with beside, which changes what happens."""
        self._looks: tuple[Callable[[], None], ...] = ()
        self.turn = 0
        """How often everything that was due at the present instant has been carried out."""

    @property
    def views(self) -> WorldViews:
        """What whoever looks sees of the worlds."""
        return self._buses

    @property
    def now(self) -> int:
        """Virtual nanoseconds since this runtime's start."""
        return self._now

    # Units, as the runner sees them

    def send(self, rtpu: str, order: command.Command) -> None:
        """Give an RTPU a command; it is carried out before the next cycle."""
        self._units.send(rtpu, order)

    def begin_words(self, rtpu: str) -> BeginWords:
        """Of no use: the clock of a runtime in virtual time is no other one's."""
        return BeginWords()

    def grant(self, rtpu: str, device: str) -> command.DeviceGrant:
        """Claim a device for a task; the world is opened with its first device."""
        return self._buses.grant(device, self._now)

    def release(self, device: str) -> None:
        """Give a device back."""
        self._buses.release(device)

    # A run

    @property
    def is_virtual(self) -> bool:
        """Yes."""
        return True

    @property
    def worlds(self) -> tuple[str, ...]:
        """The worlds that are open."""
        return self._buses.names

    @property
    def simulated(self) -> tuple[str, ...]:
        """Those of them in which nothing outside the program moves."""
        return self._buses.simulated

    def ask_modes(self, answer: Callable[[Mapping[str, DriveMode]], None]) -> None:
        """How every drive stands; answered at once."""
        answer(self._buses.modes())

    def offer(self, worlds: Iterable[WorldSource]) -> None:
        """These worlds are files; they are opened when a device of them is granted."""
        self._buses.sources.take(worlds)

    @property
    def opened(self) -> Mapping[str, str]:
        """The worlds that are open, each with what names the files that it was made of."""
        return self._buses.opened

    def touch(self, world: str, part: str, value: float) -> None:
        """Touch a part of an open world; raises ValueError with the reason why not."""
        self._buses.touch(world, part, value)

    def put_back(self, world: str) -> None:
        """Everything in a world to where it stood at the start; raises ValueError where only a person can do that."""
        self._buses.put_back(world)

    def displaced(self) -> dict[str, tuple[Displacement, ...]]:
        """What does not stand where it stood at the start, by world."""
        return self._buses.displaced()

    def unshare(self, name: str) -> None:
        """The table is not used any more."""
        self._views.pop(name, None)

    def share(self, name: str, segment: Segment) -> None:
        """Let the RTPUs see a table."""
        self._views[name] = segment.view

    def add_unit(self, name: str, answer: Callable[[Reason], None]) -> None:
        """One more unit, whose tasks the one executive carries out with all others; answered at once."""
        self._units.add(name)
        answer(NOTHING)

    def expect(self, worlds: Iterable[str]) -> None:
        """Nothing: a world is opened within the instant that asks for it."""

    def listen(self, listener: UnitListener) -> None:
        """Tell this one what happens."""
        self._listener = listener

    def _dated(self, tell: Callable[[event.Event], None]) -> Callable[[event.Drive], None]:
        """Drives are told in the time of the run that uses them, as all else of it."""

        def dated(drive: event.Drive) -> None:
            began = self._listener.run_began(drive.device) if self._listener is not None else 0
            tell(structs.replace(drive, at_s=round((drive.at_ns - began) * 1e-9, 9)))

        return dated

    def _dated_mishaps(self, tell: Callable[[event.Event], None]) -> Callable[[event.Mishap, int], None]:
        """A world's time is that of this runtime."""

        def dated(mishap: event.Mishap, at_ns: int) -> None:
            listener = self._listener
            began = 0 if listener is None else max(map(listener.run_began, mishap.devices), default=0)
            tell(structs.replace(mishap, at_s=round((at_ns - began) * 1e-9, 9)))

        return dated

    def begin(self) -> None:
        """A run starts now: what happens from here on is its digest."""
        self._digest = Digest(self._now)

    def each_instant(self, look: Callable[[], None]) -> None:
        """Call this one too at the end of every instant."""
        self._looks = (*self._looks, look)

    def leave_instants(self, look: Callable[[], None]) -> None:
        """Call it no more."""
        self._looks = tuple(other for other in self._looks if other != look)

    def advance(self, wall_ns: int) -> bool:
        """Run for about so much wall time; False when there is nothing to do until somebody says something."""
        listener, until = self._listener, monotonic_ns() + wall_ns
        self._deliver()
        if listener is None:
            return False
        if self._realtime_factor is not None and not listener.is_hurried:
            return self._keep_pace(self._realtime_factor, listener)
        while listener.is_moving and (self._realtime_factor is None or listener.is_hurried):
            if not self._answered(until):
                return True
            if not self._instant(listener):
                return False
            if self._units.has_commands:
                self._deliver()
            elif self._realtime_factor is None and self._executive.sweeps_at() is not None:
                self._sweep_on(listener, until)
            if monotonic_ns() > until:
                return True
        return False

    def wait_s(self) -> float:
        """How long the loop may sleep before `advance` has something to do."""
        if self._realtime_factor is None or self._listener is None:
            return 0.1
        if self._executive.owed():
            return 0.001
        following = self._next(self._listener)
        if following is None:
            return 0.02
        return min(0.02, self._realtime_factor.wait_s(following))

    def stop(self) -> None:
        """Everything off and every drive in hold, latched (law 27)."""
        self._buses.stop()
        self._units.send_all(command.Stop())
        self._deliver()

    def reset(self) -> None:
        """After a stop: motion is allowed again; nothing moves by itself."""
        self._buses.go_on()
        self._units.send_all(command.Reset())
        self._deliver()

    @property
    def digest(self) -> str:
        """Of everything that happened in this run: the worlds every 50 ms and every word to the runner."""
        return self._digest.hexdigest()

    @property
    def outside(self) -> tuple[str, ...]:
        """The tasks that had to do with the outside since `begin`: with them no run repeats (law 15)."""
        return tuple(sorted(self._digest.outside))

    def is_at_rest(self) -> bool:
        """Steps the worlds once, so that the last commands act; then every drive holds."""
        self._buses.step_once()
        return True

    def snapshots(self) -> dict[str, bytes]:
        """The worlds as they stand."""
        return self._buses.snapshots()

    def standings(self) -> dict[str, tuple[Reason, ...]]:
        """What the worlds say of how they stand."""
        return self._buses.standings()

    def watched(self) -> dict[str, bool]:
        """Of each open world whether what happens in it that no program means is told."""
        return self._buses.watched()

    def close(self) -> None:
        """Its worlds are no more, nor its sandboxes."""
        self._units.close()
        self._buses.close()

    # Inner

    def _keep_pace(self, realtime_factor: RealtimeFactor, listener: UnitListener) -> bool:
        """Everything that is due as far as the clock may go; the worlds go all the way."""
        realtime_factor.follow(self._now, monotonic_ns())
        answered = self._answered(0)
        allowed = realtime_factor.allowed(monotonic_ns(), stands=listener.is_still or not answered)
        while answered and not listener.is_still:
            following = self._next(listener)
            if following is None or following > allowed:
                break
            self._instant(listener)
            self._deliver()
            answered = self._answered(0)
        if answered and not listener.is_still and allowed > self._now:
            self._step_worlds(allowed)
        return False

    def _next(self, listener: UnitListener) -> int | None:
        """The next instant at which something happens."""
        wake, release = listener.wake_at(), self._executive.next_release()
        return min((at for at in (wake, release) if at is not None), default=None)

    def _instant(self, listener: UnitListener) -> bool:
        """Worlds step to the next instant, then everything that is due at it runs; False when nothing ever is."""
        wake = listener.wake_at()
        release = now = self._executive.next_release()
        if now is None or (wake is not None and wake < now):
            now = wake
        if now is None:
            return False
        if now > self._now + _LONGEST_STEP_NS:  # a long way in which nothing is due: others are listened to meanwhile
            self._step_worlds(self._now + _LONGEST_STEP_NS)
            return True
        if now > self._now:
            self._step_worlds(now)
            if release == now:  # at the times of tasks only: it must not matter when somebody looks, or stops the clock
                self._digest.look(now, self._buses.worlds)
        if now == wake:
            listener.tick(now)
            self._deliver()
        self._take_events()
        self._run_due(now)
        return True

    def _sweep_on(self, listener: UnitListener, until: int) -> None:
        """As `_instant` again and again, as long as nothing is due but sweeps and nobody has anything to say."""
        executive, wake = self._executive, listener.wake_at()
        if listener.is_hurried or not listener.is_moving or executive.speaks or executive.events():
            return
        end = self._now + _LONGEST_STEP_NS
        if wake is not None:
            end = min(end, wake)
        now, is_quiet = executive.sweeps_at(), True
        while is_quiet and now is not None and now < end and monotonic_ns() <= until:
            is_quiet = not self._step_worlds(now)
            if now >= self._digest.look_at:
                self._digest.look(now, self._buses.worlds)
            is_quiet = self._run_due(now) and is_quiet
            now = executive.sweeps_at()

    def _run_due(self, now: int) -> bool:
        """Everything that is due at this instant; whether nothing came of it."""
        is_quiet = True
        for _ in range(_ROUNDS):
            run_due = self._executive.run_due(now, _AT_ONCE)
            if run_due is None:
                break
            is_quiet = False
            self._hear(run_due)
            self._deliver()
        self.turn += 1
        for look in self._looks:
            look()
        return is_quiet

    def _answered(self, until: int) -> bool:
        """Whether no outside partner owes an answer; waits for it up to this time of the wall. The clock stands."""
        executive = self._executive
        if not executive.speaks:
            return True
        self._digest.outside.update("/".join(address) for address in executive.speaking)
        while owed := executive.owed():
            left = until - monotonic_ns()
            if left <= 0:
                return False
            select.select(owed, [], [], left * 1e-9)
        for address in executive.settled():
            self._hear(executive.event(address, self._now))
            self._deliver()
        return True

    def _take_events(self) -> None:
        """Events of synchronous tasks from outside, as they are there at this instant; they repeat with no seed."""
        events = self._executive.events()
        if events:
            for descriptor in select.select(list(events), [], [], 0)[0]:
                self._digest.outside.add("/".join(events[descriptor]))
                self._hear(self._executive.event(events[descriptor], self._now))
                self._deliver()

    def _step_worlds(self, now: int) -> bool:
        """Whether something was told of them."""
        self._now, self.turn = now, 0
        return self._buses.step(now)

    def _deliver(self) -> None:
        """Carry out commands until none is left; what they lead to is heard at the same instant."""
        self._units.deliver(self._now, self._heard)

    def _hear(self, newses: Sequence[news.News]) -> None:
        self._units.tell(newses, self._heard)

    def _heard(self, rtpu: str, one: news.News) -> None:
        if not isinstance(one, _NOTHING_HAPPENED):
            self._digest.hear(one)
        if self._listener is not None:
            self._listener.hear(rtpu, one, self._now)
