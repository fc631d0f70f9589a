"""Every subsystem of a runtime, held by hand or by an application; news finds its way here."""

from collections.abc import Callable, Collection, Mapping
from typing import Protocol, cast

from onika.host.run.application_run import ApplicationRun
from onika.host.run.clock_gate import ClockGate
from onika.host.run.replay import Replay
from onika.host.run.status_poll import StatusPoll
from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.host.subsystems.load_forecast import LoadForecast
from onika.host.units.driver_clock import DriverClock
from onika.host.units.unit_registry import Units
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.subsystem import Member
from onika.runtime.table import SIZE, Table
from onika.wire import event
from onika.words.reason import NOTHING, Reason

DEVICE_SERVER = "device server"
"""By this name its loss is told."""
_LOADS_EVERY_NS = 1_000_000_000

Tell = Callable[[event.Event, str, str], None]
"""An event, the subsystem whose listeners hear it (empty: everybody), a session that hears it in any case."""


class Tables(Units, DriverClock, Protocol):
    """Units that can be shown memory, and told the time."""

    def share(self, name: str, segment: Segment) -> None:
        """Let the RTPUs see a table."""
        ...

    def unshare(self, name: str) -> None:
        """The table is not used any more."""
        ...


class Subsystems:
    """Who lives where. It is the driver's listener."""

    def __init__(self, units: Tables, tell: Tell, rtpus: Collection[str]) -> None:
        self.live: dict[str, LiveSubsystem] = {}
        self.tables: dict[str, Table] = {}
        self.runs: list[ApplicationRun] = []
        self.lost_units: dict[str, Reason] = {}
        self.status_poll = StatusPoll(units, self._alive)
        self.forecast = LoadForecast()
        self.hold = ClockGate(tell)
        self.repeat = Replay()
        self._asked_loads_at = 0
        self.until = 0
        """Up to when the clock goes on in virtual time though no application runs."""
        self._units = units
        self._tell = tell
        self._rtpus = tuple(rtpus)
        self._reached: list[tuple[int, Callable[[], None]]] = []

    # Who lives where

    def table(self, name: str) -> Table:
        """A new zeroed table for a subsystem, in place of any old one (law 4); raises SharedMemoryRefused."""
        segment = Segment.create(f"table-{name}", SIZE)
        if name in self.tables:
            self.tables[name].close()
        table = self.tables[name] = Table(segment)
        self._units.share(f"table:{name}", table.segment)
        return table

    def by_hand(self, name: str) -> LiveSubsystem:
        """The subsystem of this name as it is held by hand; it is made with its first task."""
        if name not in self.live:

            def tell(message: event.Event) -> None:
                self._tell(message, name, self.live[name].holder if name in self.live else "")

            self.live[name] = LiveSubsystem(
                name,
                self.table(name),
                self._units,
                tell,
                lambda: self._units.now,
                self.lost_units,
                lambda: self.drop(name),
            )
        return self.live[name]

    def drop(self, name: str) -> None:
        """An empty subsystem is no more, and nobody holds it."""
        holder = self.live.pop(name).holder
        if holder:
            self._tell(event.Held(name, ""), name, holder)
        self._units.unshare(f"table:{name}")
        self.tables.pop(name).close()

    def close(self) -> None:
        """Give the memory of all tables back."""
        for name, table in self.tables.items():
            self._units.unshare(f"table:{name}")
            table.close()
        self.tables.clear()

    @property
    def units(self) -> tuple[str, ...]:
        """All processing units by name, those that are lost too."""
        return self._rtpus

    def unit_up(self, name: str) -> None:
        """A unit is up that was added or started anew. It is empty: whatever was on it before is gone."""
        self.lost_units.pop(name, None)
        self.status_poll.loads.pop(name, None)
        if name not in self._rtpus:
            self._rtpus = (*self._rtpus, name)
        self._tell(event.UnitUp(name, round(self._units.now * 1e-9, 9)), "", "")

    def unit(self, wanted: str) -> str:
        """The unit a task runs on: the named one, else the first that lives (reading 12)."""
        if wanted in self._rtpus:
            return wanted
        return next(iter(self._alive()), self._rtpus[0])

    def spare_units(self, wanted: str) -> tuple[str, ...]:
        """The other units that live, for a task that names none; where it names one, only that will do."""
        if wanted in self._rtpus:
            return ()
        return tuple(unit for unit in self._alive() if unit != self.unit(wanted))

    def is_driven(self, unit: str, by: str) -> bool:
        """Whether what lives on a unit may have a part in driving a device, as somebody sees it who changes `by` now.

        An application may at any time, and so may another subsystem that is being changed.
        """
        if any(member.rtpu == unit for run in self.runs for name in run.names for member in run.members(name).values()):
            return True
        return any(live.drives(unit, name == by or not live.is_busy) for name, live in self.live.items())

    def gone(self, wanted: str) -> Reason:
        """Why no task can run on the unit it would be on; empty: it can."""
        return self.lost_units.get(self.unit(wanted), NOTHING)

    def run_in(self, subsystem: str) -> ApplicationRun | None:
        """The application that runs in a subsystem."""
        for run in self.runs:  # at all that is heard of a task: no generator
            if subsystem in run.names:
                return run
        return None

    def perform(self, run: ApplicationRun) -> None:
        """An application begins."""
        self.runs.append(run)
        run.runner.start(self._units.now)

    def when(self, at: int, then: Callable[[], None]) -> None:
        """In virtual time: let the clock go on to this time, then do this."""
        self.until = max(self.until, at)
        self._reached.append((at, then))

    # As the driver's listener

    @property
    def is_moving(self) -> bool:
        """Whether the virtual clock goes on: not while a task of an application asks, or nothing wants it to."""
        if self._stands:
            return False
        is_running = False
        for run in self.runs:  # asked at every instant of virtual time
            if run.runner.is_moving:
                is_running = True
            elif run.runner.is_asking and not run.runner.is_over:
                return False
        return is_running or self._is_let_pass

    @property
    def is_asking(self) -> bool:
        """Whether a task of an application waits for user input."""
        return any(run.runner.is_asking and not run.runner.is_over for run in self.runs)

    @property
    def is_still(self) -> bool:
        """Whether scaled time stands still: nothing lives, or an application's task waits for user input."""
        lives = any(live.members for live in self.live.values()) or self._is_let_pass
        if self.is_asking or self._stands:
            return True
        return not (lives or any(run.runner.is_moving for run in self.runs))

    @property
    def is_hurried(self) -> bool:
        """Whether scaled time goes as fast as it can: while a recorded run is repeated."""
        return self.repeat.is_on(self._units.now)

    @property
    def is_repeat_due(self) -> bool:
        """Whether something is to be asked anew, at this instant, of a run that is repeated."""
        return self.repeat.is_due(self._units.now, self._units.turn, self.is_asking)

    @property
    def _stands(self) -> bool:
        """Whether the clock waits: for whoever holds it, or for what is asked anew."""
        if self.repeat.session and self.repeat.is_on(self._units.now):
            return self.is_repeat_due
        return self.hold.stands(self._units.now)

    @property
    def _is_let_pass(self) -> bool:
        """Whether somebody lets time pass that no run needs: `advance`, or who holds the clock of a run that rests."""
        return self._units.now < max(self.until, self._let_to or 0)

    @property
    def _let_to(self) -> int | None:
        """Up to when the clock goes on in any case: for what is repeated, and only then for who holds the clock."""
        now = self._units.now
        if self.repeat.is_on(now):
            return self.repeat.wake_at(now)
        return self.hold.wake_at()

    def hear(self, rtpu: str, message: news.News, now: int) -> None:
        """Tell whose task it is."""
        if type(message) not in news.OF_TASKS:
            self._hear_of_unit(rtpu, message, now)
        elif type(message) is news.Refused and message.command == "get or set":
            self.status_poll.answered(message)
        else:
            self._hear_of_task(rtpu, cast("news.TaskNews", message), now)

    def _hear_of_task(self, rtpu: str, message: news.TaskNews | news.Unprepared, now: int) -> None:
        run = self.run_in(message.subsystem)
        if run is not None:
            run.hear(rtpu, message, now)
        elif message.subsystem in self.live:
            self.live[message.subsystem].hear(rtpu, message, now)

    def _hear_of_unit(self, rtpu: str, message: news.News, now: int) -> None:
        match message:
            case news.Loads():
                loads = [(load, self._digest(load.subsystem, load.task)) for load in message.tasks]
                self.forecast.hear(message.rtpu, loads)
            case news.Statuses():
                self.status_poll.hear(message)
                for each in self.runs:
                    each.hear(rtpu, message, now)
            case news.Appointed() | news.HeldAlone():
                for each in self.runs:
                    each.hear(rtpu, message, now)
            case news.Got():
                self.status_poll.answered(message)
            case news.Unprepared():
                self._hear_of_task(rtpu, message, now)

    def lost(self, rtpu: str, reason: Reason, now: int) -> None:
        """A process is gone, and with a unit its tasks."""
        if rtpu:
            self.lost_units[rtpu] = reason
        self._tell(event.Lost(rtpu or DEVICE_SERVER, reason, round(now * 1e-9, 9)), "", "")
        for run in self.runs:
            run.runner.lost(rtpu, reason, now)
        for live in list(self.live.values()):
            live.lost(rtpu, reason, now)
        self.status_poll.lost()

    def run_began(self, device: str) -> int:
        """When the run began that uses a device; 0 where none does."""
        return max((run.runner.run_began(device) for run in self.runs), default=0)

    def wake_at(self) -> int | None:
        """The next time somebody has something to do."""
        earliest = self._let_to
        for run in self.runs:
            wake = run.runner.wake_at()
            if wake is not None and (earliest is None or wake < earliest):
                earliest = wake
        for at, _ in self._reached:
            if earliest is None or at < earliest:
                earliest = at
        return earliest

    def tick(self, now: int) -> None:
        """Let time pass."""
        for run in self.runs:
            run.runner.tick(now)
        reached = [then for at, then in self._reached if at <= now]
        self._reached = [(at, then) for at, then in self._reached if at > now]
        for then in reached:
            then()
        self._ask_loads(now)

    def _ask_loads(self, now: int) -> None:
        """What everything costs, once a second; in virtual time nothing may depend on it."""
        if not self._units.is_virtual and (self.live or self.runs) and now >= self._asked_loads_at:
            self._asked_loads_at = now + _LOADS_EVERY_NS
            for rtpu in self._alive():
                self._units.send(rtpu, command.Load())

    def _digest(self, subsystem: str, task: str) -> str:
        member = self.members(subsystem).get(task)
        if member is not None:
            return member.wired.task.digest
        return ""

    def members(self, subsystem: str) -> Mapping[str, Member]:
        """The tasks of a subsystem, whoever holds it."""
        run = self.run_in(subsystem)
        if run is not None:
            return run.members(subsystem)
        by_hand = self.live.get(subsystem)
        return by_hand.members if by_hand is not None else {}

    def _alive(self) -> list[str]:
        return [name for name in self._rtpus if name not in self.lost_units]
