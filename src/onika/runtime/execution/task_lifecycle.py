"""The lifecycle of the tasks on one RTPU: spawned, turned on, asked for input, turned off, killed (law 11)."""

from collections.abc import Callable, Collection, Sequence
from functools import partial
from types import CodeType

from onika.model.lifecycle import LifecycleInput, State, refusal
from onika.model.signal import Signal, SignalKind
from onika.runtime import command, news
from onika.runtime.error import AskAgain, LawBroken, ModuleError
from onika.runtime.execution.entry_points import RAISED, EntryPoints
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.unit import Address, ProcessingUnit
from onika.runtime.modules.code import load, raised, sayable
from onika.runtime.modules.cycle_result import signal_of
from onika.runtime.modules.module import Module
from onika.runtime.prepared_switches import lines
from onika.runtime.sandbox.sandboxed_class import load_sandboxed
from onika.words.fault import Fault
from onika.words.reason import NOTHING, Reason, reason_of

_ON, _OFF = State.ON.value, State.OFF.value


class TaskLifecycle:
    """Carries out the commands that change what a task is in; what it led to is told to the unit."""

    def __init__(self, unit: ProcessingUnit, calls: EntryPoints) -> None:
        self._unit = unit
        self._entry_points = calls
        self.looks_later = False
        """Between a finish and the first cycles that follow it: what goes off is looked at when they have run."""
        self._unlooked: dict[Address, RunningTask] = {}

    # To life and to its end

    def spawn(self, order: command.Spawn, now: int) -> None:
        """Load, make, initialise."""
        task = self.make(order)
        if task is not None:
            self.initialise(task, now)

    def make(
        self, order: command.Spawn, entry: str = "spawn", code: CodeType | Fault | None = None
    ) -> RunningTask | None:
        """Load a module and make a task of it, which does not live yet; None where that is refused."""
        address = (order.subsystem, order.task)
        if self._unit.is_stopped:
            self._unit.refuse(address, entry, Reason.of("runtime.unit_stopped"))
            return None
        if entry == "spawn" and address in self._unit.tasks:
            self._unit.refuse(address, entry, Reason.of("runtime.lives_already"))
            return None
        sandbox = self._unit.sandboxes.pop(address, None)
        self._entry_points.watch(f"{order.subsystem}/{order.task}")
        try:
            cls = load_sandboxed(order, sandbox) if order.is_sandboxed else _loaded(order, code)
            if not isinstance(cls, Reason):
                return RunningTask(order, cls, self._unit.views)
            self._unit.refuse(address, entry, cls)
        except RAISED as wrong:
            self._unit.refuse(address, entry, raised(wrong, order.module))
        finally:
            self._entry_points.watch("")
        if sandbox is not None:
            sandbox.close()
        return None

    def initialise(self, task: RunningTask, now: int) -> None:
        """The task lives from now on; `init`."""
        self._unit.admit(task)
        if self._entry_points.attempt(task, "init", now, task.init):
            task.step(LifecycleInput.INITIALISED)
            self._unit.tell(news.Initialised(*task.address))

    def kill(self, address: Address, now: int) -> None:
        """`off` where it is ON, `kill`, gone."""
        self._unit.prepared.drop(address[0])
        task = self._unit.tasks.get(address)
        if task is None:
            self._unit.tell(news.Changed(*address, State.KILLED.value, now))
            return
        if task.state in (State.ON, State.ASKING):
            self._leave(task, LifecycleInput.OFF, now)
        self._unit.dismiss(address)
        self._entry_points.attempt(task, "kill", now, task.module.kill)
        task.part()
        task.hold()
        task.step(LifecycleInput.KILL)
        self._unit.tell(news.Changed(*address, State.KILLED.value, now, activation=task.activation))

    def stop(self, now: int) -> None:
        """Every device in hold, everything off, nothing comes on any more."""
        self._unit.is_stopped = True
        self._unit.prepared.drop_all()
        for task in self._unit.tasks.values():
            task.hold()  # first every device, then the modules' own words
        for address in list(self._unit.tasks):
            self._off(address, now)

    def fail_devices(self, cause: Reason, now: int) -> None:
        """Every task that has a device and is ON goes to ERROR."""
        self._unit.prepared.drop_all()
        for task in self._unit.tasks.values():
            if task.device is not None and task.is_on:
                self._entry_points.fail(task, "device", ModuleError(cause), now)

    def hold_alone(self, subsystems: Collection[str], now: int) -> None:
        """Every task of these subsystems that has a device and is ON goes to ERROR: it has begun alone (law 34)."""
        for task in list(self._unit.tasks.values()):
            if task.spawn.subsystem in subsystems and task.device is not None and task.is_on:
                self._entry_points.fail(task, "device", ModuleError(Reason.of("runtime.began_alone")), now)

    def drives(self, subsystems: Collection[str]) -> bool:
        """Whether a task of these subsystems, ON or not, has a device or an outside partner: moves anything."""
        tasks = (task for task in self._unit.tasks.values() if task.spawn.subsystem in subsystems)
        return any(task.device is not None or task.partner is not None for task in tasks)

    def starve(self, order: command.Starve, now: int) -> None:
        """This task goes to ERROR if it is ON: elsewhere a task has failed on whose values it feeds."""
        task = self._unit.tasks.get((order.subsystem, order.task))
        if task is not None and task.is_on:
            self._entry_points.fail(task, "cycle", LawBroken(order.cause), now)

    # On and off

    def switch(self, orders: Sequence[command.Switch], now: int) -> None:
        """Off, forget, rates of all subsystems, then on; no cycle comes in between."""
        for order in orders:
            self._unit.prepared.drop(order.subsystem)
            for name in order.off:
                self._off((order.subsystem, name), now)
            self._unit.forget(order.subsystem, order.forget)
            for name, frequency in order.rates:
                self._rate((order.subsystem, name), frequency, now)
        for order in orders:
            for launch in order.on:
                self._on((order.subsystem, launch.task), launch, now)

    def prepare(self, order: command.PreparedSwitch) -> None:
        """Hold switches for a finish; the argument lines of what may come on are read now, as far as they can be."""
        self._unit.prepared.keep(order)
        if not order.cases:
            self._unit.tell(news.Unprepared(order.subsystem))
        for name, foreseen in lines(order.cases).items():
            task = self._unit.tasks.get((order.subsystem, name))
            if task is not None and task.input is not None:
                task.input.foresee(foreseen)

    def answer(self, order: command.Answer, now: int) -> None:
        """The user's answer: on, or ask again."""
        task = self._unit.tasks.get((order.subsystem, order.task))
        if task is None or task.state is not State.ASKING:
            self._unit.refuse((order.subsystem, order.task), "answer", Reason.of("runtime.asks_nothing"))
            return
        self._begin(task, order.line, now)

    def signalled(self, task: RunningTask, returned: object, now: int) -> command.Switch | None:
        """What a cycle returned: Table 9, as far as it is the unit's; the 0 of a C function is nothing.

        The switch that was prepared for such a finish is to be carried out next.
        """
        if type(returned) is int and not returned:
            return None
        try:
            signal = signal_of(returned, is_trigger=task.trigger)
        except TypeError as wrong:
            self._entry_points.fail(task, "cycle", wrong, now)
            return None
        address, run = task.address, task.activation
        if signal.kind is SignalKind.FINISH:
            return self._finish(task, signal, now)
        if signal.kind is SignalKind.OFF:
            self._unit.prepared.drop(address[0])  # it counts on who is ON
            if self._leave(task, LifecycleInput.OFF, now):
                self._unit.tell(news.Changed(*address, _OFF, now, "OFF", run))
        else:
            text = sayable(signal.text, task.spawn.module) if signal.text else NOTHING
            self._unit.tell(news.Signalled(*address, signal.kind.value, signal.number, text, now, run))
        return None

    @property
    def has_unlooked(self) -> bool:
        """Whether somebody went off who is still to be looked at."""
        return bool(self._unlooked)

    def look(self, now: int) -> None:
        """Look at the modules of those who went off while there was no time for it.

        Whoever came on again meanwhile is looked at with its first cycle.
        """
        unlooked, self._unlooked = self._unlooked, {}
        for address, task in unlooked.items():
            if task.state is State.OFF and self._unit.tasks.get(address) is task:
                self._entry_points.attempt(task, "off", now, task.no_strays)

    # Inner

    def _finish(self, task: RunningTask, signal: Signal, now: int) -> command.Switch | None:
        if not self._leave(task, LifecycleInput.FINISH, now):
            return None
        case = self._unit.prepared.take(*task.address, task.activation, signal)
        number = case.number if case else 0
        self._unit.tell(news.Finished(*task.address, signal.flow, signal.loop, now, task.activation, number))
        return case.switch if case else None

    def _rate(self, address: Address, frequency: float, now: int) -> None:
        task = self._unit.tasks.get(address)
        if task is None:
            self._unit.refuse(address, "rate", Reason.of("runtime.no_such_task"))
            return
        try:
            self._unit.scheduler.change(task.slot, task.change_rate(frequency), now)
        except ValueError as wrong:
            self._unit.refuse(address, "rate", reason_of(wrong))
            return
        if task.is_on:
            self._unit.watch(task, now)

    def _on(self, address: Address, launch: command.Launch, now: int) -> None:
        task = self._unit.tasks.get(address)
        reason = self._why_not_on(task)
        if task is None or reason:
            self._unit.refuse(address, "on", reason)
            return
        if launch.frequency is not None and launch.frequency != task.frequency:
            self._rate(address, launch.frequency, now)
        task.activation = launch.activation
        self._begin(task, launch.arguments, now)

    def _why_not_on(self, task: RunningTask | None) -> Reason:
        if self._unit.is_stopped:
            return Reason.of("runtime.unit_stopped")
        if task is None:
            return Reason.of("runtime.no_such_task")
        if task.state is not State.OFF:
            return refusal(task.state, LifecycleInput.ON)
        if task.is_initialised:
            return NOTHING
        return Reason.of("runtime.waits_to_be_reinitialised")

    def _begin(self, task: RunningTask, line: str, now: int) -> None:
        """`on` with an argument line, or ask: what the line lacks, or what the module says of it."""
        try:
            inputs = task.parse(line)
        except ValueError as wrong:
            self._ask(task, reason_of(wrong) if line else NOTHING, now)
            return
        try:
            began = self._entry_points.attempt(task, "on", now, partial(task.begin, now, inputs), passing=AskAgain)
        except AskAgain as again:
            self._ask(task, sayable(reason_of(again), task.spawn.module), now)
            return
        if not began or self._steps_too_far(task, now):
            return
        task.publish()
        task.line, task.goes_on = line, False
        task.step(LifecycleInput.ANSWERED if task.state is State.ASKING else LifecycleInput.ON)
        self._unit.enter(task, now)
        self._unit.watch(task, now)
        if task.is_synchronous:
            self._entry_points.attempt(task, "fileno", now, partial(self._unit.await_event, task))
        state = _ON if task.state is State.ON else task.state.value
        self._unit.tell(news.Changed(*task.address, state, now, "", task.activation))

    def _steps_too_far(self, task: RunningTask, now: int) -> bool:
        """Whether a device cannot be given what `on` has left and nobody has seen yet: then it is OFF, and refused."""
        reason = self._unit.objection(task)
        if not reason:
            return False
        if self._entry_points.attempt(task, "off", now, task.off):
            if task.state is State.ASKING:
                task.step(LifecycleInput.OFF)
                self._unit.tell(news.Changed(*task.address, _OFF, now, "", task.activation))
            self._unit.refuse(task.address, "on", reason)
        return True

    def _ask(self, task: RunningTask, reason: Reason, now: int) -> None:
        task.step(LifecycleInput.ASK)
        items = task.input.items if task.input else ()
        self._unit.tell(news.Asked(*task.address, reason, items, now, task.activation))

    def _off(self, address: Address, now: int) -> None:
        task = self._unit.tasks.get(address)
        if task is None or not (task.state is State.ON or task.state is State.ASKING):
            return  # off already: turning off what is off harms nothing
        if self._leave(task, LifecycleInput.OFF, now):
            self._unit.tell(news.Changed(*address, _OFF, now, "", task.activation))

    def _leave(self, task: RunningTask, step: LifecycleInput, now: int) -> bool:
        """Out of ON or ASKING; `off` runs only after an `on`. False if it raised: the task is in ERROR instead."""
        self._unit.leave(task, now)
        self._unit.watch(task, now)
        if task.is_on and not self._entry_points.attempt(task, "off", now, self._way_off(task)):
            return False
        task.step(step)
        return True

    def _way_off(self, task: RunningTask) -> Callable[[], None]:
        if self.looks_later:
            self._unlooked[task.address] = task
            return task.leave
        return task.off


def _loaded(order: command.Spawn, code: CodeType | Fault | None) -> type[Module] | Reason:
    """The class of a module of this process, or why there is none."""
    cls = load(order.source, order.path, order.module, code)
    return cls.sentence if isinstance(cls, Fault) else cls
