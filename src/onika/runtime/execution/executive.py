"""The executive of one RTPU: it carries out commands, runs the tasks that are due and reports (the law of the cycle).

Sans-I/O: `handle` takes a command and the time, `run_next` runs one cycle; both return news. Between two cycles its
owner delivers the news and the commands that came meanwhile, in this order (law 2).
"""

from collections.abc import Callable, Sequence

from onika.model.signal import Signal
from onika.ring.begin_words import BeginWords
from onika.runtime import command, news
from onika.runtime.execution.appointments import NEVER, SHARED_LATE_NS, Appointments, AppointmentStep
from onika.runtime.execution.deferred import DeferredCommands
from onika.runtime.execution.entry_points import RAISED, EntryPoints
from onika.runtime.execution.module_exchange import ModuleExchange
from onika.runtime.execution.rounds import STEADY, Rounds, SweepStop
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.statistics import load_of, status_of
from onika.runtime.execution.task_commands import TaskCommands
from onika.runtime.execution.task_lifecycle import TaskLifecycle
from onika.runtime.execution.unit import Address, ProcessingUnit
from onika.runtime.execution.whereabouts import Whereabouts
from onika.runtime.modules.binding import Views
from onika.runtime.modules.binding_guard import BindingChanged
from onika.runtime.sandbox.sandboxed_module import Sandbox
from onika.runtime.scheduler import TaskSlot

_NOTHING: Sequence[news.News] = ()
_SWITCHES = (command.Switch, command.Together)
_APPOINTMENTS = (command.Appointment, command.CallOff)
_HARMLESS = (*_SWITCHES, command.PreparedSwitch, command.Answer, command.Report, command.Load)
"""After these every task is still the same, and bound to the same."""


class Executive:
    """Tasks of any subsystems on one processing unit. `watch` is told the task before its code runs, "" after.

    After so many `steady` instants alike, what is due is carried out by sweeps, where `run_due` may run all of it.
    """

    def __init__(
        self,
        rtpu: str,
        views: Views,
        watch: Callable[[str], None] | None = None,
        begin_words: BeginWords | None = None,
        steady: int = STEADY,
    ) -> None:
        self._unit = ProcessingUnit(rtpu, views)
        self._entry_points = EntryPoints(self._unit, watch)
        whereabouts = watch if isinstance(watch, Whereabouts) else Whereabouts()
        self._rounds = Rounds(self._unit, whereabouts, steady)
        self._groups = self._rounds.groups
        self._lifecycle = TaskLifecycle(self._unit, self._entry_points)
        self._task_commands = TaskCommands(self._unit, self._entry_points)
        self._exchange = ModuleExchange(self._unit, self._entry_points, self._lifecycle)
        self._deferred = DeferredCommands(self._unit, self._lifecycle, self._exchange)
        self._appointments = Appointments(begin_words or BeginWords())
        self._busy_since_ns = 0

    @property
    def tasks(self) -> dict[Address, RunningTask]:
        """Everything that lives here, by subsystem and name."""
        return self._unit.tasks

    def give_sandbox(self, address: Address, sandbox: Sandbox) -> None:
        """The sandbox that was begun for a task which is still to come, or for its code that is to be exchanged."""
        self._unit.sandboxes[address] = sandbox

    # Commands

    def handle(self, order: command.Command, now: int) -> list[news.News]:
        """Carry out one command; what it led to comes back as news."""
        if isinstance(order, _HARMLESS):
            self._rounds.end()
        else:
            self._rounds.forget()
        self._lifecycle.look(now)
        self._follow(order, now)
        self._entry_points.watch("")
        return self._unit.take_news()

    @property
    def has_work(self) -> bool:
        """Whether something was put aside that `work` would go on with."""
        return bool(self._deferred)

    def work(self, now: int) -> list[news.News]:
        """Carry out one deferred piece if there is room for it before the next release; what it led to.

        Loading a module and its `init` cost more than a cycle: while anything is ON a Spawn or Swap with a cost waits
        for a gap. Its owner calls this when nothing is due; what finds no gap within 2 s is refused with the numbers.
        """
        if self._deferred:
            self._rounds.forget()
        self._deferred.work(now, self._follow)
        self._entry_points.watch("")
        return self._unit.take_news()

    def next_release(self) -> int | None:
        """When the next cycle is due, if any."""
        if self._groups and self._appointments.next_ns == NEVER:
            return self._groups[0][0]
        release = self._unit.scheduler.next_release()
        if self._appointments.next_ns == NEVER:
            return release
        return self._appointments.next_ns if release is None else min(release, self._appointments.next_ns)

    def sweeps_at(self) -> int | None:
        """The same, where nothing but a sweep is due then."""
        if self._groups and self._groups[0][0] < self._appointments.next_ns:
            return self._groups[0][0]
        return None

    # Cycles

    def run_next(self, now: int) -> Sequence[news.News] | None:
        """Run the one task that is due first; its news (mostly none), or None if nothing is due."""
        return self.run_due(now, 1)

    def run_due(self, now: int, most: int) -> Sequence[news.News] | None:
        """Run what is due, in order, up to so many cycles or until there is news; None if nothing is due any more."""
        groups = self._groups
        if groups and most > 1 and groups[0][0] == now < self._appointments.next_ns:
            stop = self._rounds.run(now)
            if stop is None:
                return None  # as nearly always in virtual time
            if stop.slot is not None:
                self._stopped(stop.slot, stop, now)
        events = self._run_due(now, most)
        if events is None and self._lifecycle.has_unlooked:
            self._lifecycle.look(now)
            events = self._unit.take_news() or None
        if self._entry_points.is_watched:
            self._entry_points.watch("")
        return events

    def _run_due(self, now: int, most: int) -> Sequence[news.News] | None:
        unit = self._unit
        if now >= self._appointments.next_ns:
            self._keep_appointments(now)
            return unit.take_news()
        if unit.news:
            return unit.take_news()
        following = self._one_by_one(now, most)
        if following is None and most > 1:
            self._rounds.note_instant()
        return following

    def _one_by_one(self, now: int, most: int) -> Sequence[news.News] | None:
        unit, calls, scheduler = self._unit, self._entry_points, self._unit.scheduler
        slots, watch = unit.slots, calls.watch if calls.is_watched else None
        slot = scheduler.next_due(now)
        while slot is not None:
            task, epoch, signal = slots[slot], slot.epoch, None
            if watch is not None:
                watch(slot.key[2])
            try:
                signal = task.cycle(now)
            except RAISED as wrong:
                calls.fail(task, "cycle", wrong, now)
            if signal is not None or task.is_first or task.warnings:
                self._after_cycle(task, signal, now, is_due=True)
            most -= 1
            goes_on = slot.epoch == epoch
            if goes_on and not task.is_periodic:
                goes_on = self._goes_on(task, slot)
            if unit.news or not most:
                return self._interrupted(slot, goes_on)
            slot = scheduler.after(slot, now) if goes_on else scheduler.next_due(now)
        return None

    def _stopped(self, slot: TaskSlot, stop: SweepStop, now: int) -> None:
        """What came of the cycle at which a sweep has ended."""
        epoch = slot.epoch
        task = self._unit.slots[slot]
        if stop.wrong is not None:
            self._entry_points.fail(task, "cycle", stop.wrong, now)
        if stop.signal is not None or task.warnings:
            self._after_cycle(task, stop.signal, now, is_due=True)
        if slot.epoch == epoch:
            self._unit.scheduler.done(slot)

    def _goes_on(self, task: RunningTask, slot: TaskSlot) -> bool:
        """Whether a synchronous task cycles on: it does while it asks its partner and has the answer."""
        if task.asks and not task.is_owed:
            return True
        self._unit.scheduler.leave(slot)
        return False

    def _interrupted(self, slot: TaskSlot, goes_on: bool) -> Sequence[news.News]:
        """The news for which what is due stands back, or that there is none."""
        if goes_on:
            self._unit.scheduler.done(slot)
        if not self._unit.news:
            return _NOTHING
        self._rounds.end()
        return self._unit.take_news()

    def events(self) -> dict[int, Address]:
        """The descriptors that synchronous tasks which are ON wait for; their owner waits for them with its own."""
        return dict(self._unit.events)

    @property
    def speaks(self) -> bool:
        """Whether a task is ON that has an outside partner; asked at every instant of virtual time."""
        return bool(self._unit.speaking)

    @property
    def speaking(self) -> Sequence[Address]:
        """The tasks that are ON and have asked an outside partner something."""
        return [address for address, task in self._unit.speaking.items() if task.partner and task.partner.questions]

    def owed(self) -> list[int]:
        """The descriptors of the outside partners that owe an answer by now: in virtual time the clock stands."""
        partners = [task.partner for task in self._unit.speaking.values() if task.partner and task.is_owed]
        for partner in partners:
            partner.hear()
        return [partner.fileno() for partner in partners if partner.is_awaited]

    def settled(self) -> list[Address]:
        """The synchronous tasks to which their partner's answer is to be told, or that there is none: as events."""
        return [address for address, task in self._unit.speaking.items() if task.is_synchronous and task.is_settled]

    def event(self, address: Address, now: int) -> list[news.News]:
        """The event of a synchronous task has arrived; nothing happens unless it is ON."""
        self._rounds.end()
        task = self.tasks.get(address)
        if task is not None and task.is_on and task.is_synchronous:
            was_owed = task.is_owed or task.is_settled
            signal = self._entry_points.event(task, now)
            self._after_cycle(task, signal, now)
            self._entry_points.watch("")
            if was_owed and task.is_on and not task.is_owed:
                self._unit.scheduler.resume(task.slot, now)  # it asks again at its rate
        return self._unit.take_news()

    # Inner

    def _follow(self, order: command.Command, now: int) -> None:
        """Carry out what of a command does not have to wait for something deferred."""
        if isinstance(order, _SWITCHES):
            switches = order.switches if isinstance(order, command.Together) else (order,)
            self._lifecycle.switch([self._deferred.sift_switch(switch) for switch in switches], now)
            return
        if isinstance(order, _APPOINTMENTS):
            self._appoint(order, now)
            return
        at_once = self._deferred.sift(order, now)
        if at_once is not None:
            self._carry_out(at_once, now)

    def _carry_out(self, order: command.Command, now: int) -> None:
        match order:
            case command.Spawn():
                self._lifecycle.spawn(order, now)
            case command.PreparedSwitch():
                self._lifecycle.prepare(order)
            case command.Answer():
                self._lifecycle.answer(order, now)
            case command.Kill():
                self._lifecycle.kill((order.subsystem, order.task), now)
            case command.Swap():
                self._exchange.swap(order, now)
            case command.Fail():
                self._lifecycle.fail_devices(order.cause, now)
            case command.Starve():
                self._lifecycle.starve(order, now)
            case command.Stop() | command.Quit():
                self._lifecycle.stop(now)
                for appointment in self._appointments.drop_all():
                    self._unit.tell(news.Appointed(appointment.number, now, has_begun=False))
            case command.Reset():
                self._unit.is_stopped = False
            case command.Report() | command.Load():
                self._unit.tell(self._statuses(now) if isinstance(order, command.Report) else self._loads())
            case _:
                self._task_commands.change(order, now)

    # Appointments

    def share_processor(self) -> None:
        """The machine grants no real time: what is appointed may begin later than else."""
        self._appointments.late_ns = SHARED_LATE_NS

    def _appoint(self, order: command.Appointment | command.CallOff, now: int) -> None:
        if isinstance(order, command.Appointment):
            self._appointments.keep(order)
            return
        appointment = self._appointments.drop(order.number)
        if appointment is not None and order.holds:
            self._lifecycle.hold_alone(appointment.subsystems, now)

    def _keep_appointments(self, now: int) -> None:
        """Begin what is to begin now, and hold what nobody has confirmed (law 34)."""
        for step, appointment in self._appointments.due(now):
            match step:
                case AppointmentStep.BEGIN:
                    drives = self._lifecycle.drives(appointment.subsystems)
                    self._unit.tell(news.Appointed(appointment.number, now, has_begun=True, drives=drives))
                    self._follow(command.Together(appointment.switches), now)
                case AppointmentStep.MISS:
                    self._unit.tell(news.Appointed(appointment.number, now, has_begun=False))
                case AppointmentStep.HOLD:
                    self._lifecycle.hold_alone(appointment.subsystems, now)
                    self._unit.tell(news.HeldAlone(appointment.number, now))

    def _after_cycle(self, task: RunningTask, signal: Signal | None, now: int, *, is_due: bool = False) -> None:
        """What a cycle led to besides its outputs. One that was due is often followed by others which are due."""
        if task.is_first:
            task.is_first = False
            if task.is_on:
                self._first_cycle(task, now)
        self._entry_points.warn(task, now)
        if signal is not None and task.is_on:
            self._lifecycle.looks_later = is_due
            following = self._lifecycle.signalled(task, signal, now)
            if following is not None:
                self._follow(following, now)
            self._lifecycle.looks_later = False

    def _first_cycle(self, task: RunningTask, now: int) -> None:
        if not task.goes_on:
            self._unit.tell(news.Cycled(*task.address, now, task.activation))
        if task.is_looked_at:
            return
        try:
            task.no_strays()
        except BindingChanged as wrong:
            self._entry_points.fail(task, "check", wrong, now)

    def _statuses(self, now: int) -> news.Statuses:
        span = max(now - self._busy_since_ns, 1)
        total = sum(task.counters.total_ns for task in self.tasks.values())
        tasks = tuple(status_of(task, now) for task in self.tasks.values())
        self._busy_since_ns = now
        return news.Statuses(self._unit.rtpu, total / span, tasks)

    def _loads(self) -> news.Loads:
        return news.Loads(self._unit.rtpu, tuple(load_of(task) for task in self.tasks.values()))
