"""The lives of the tasks on one processing unit: spawned, turned on, asked, changed, turned off, killed (law 11)."""

from types import CodeType

from msgspec import structs

from onika.model.lifecycle import State, Step, refusal
from onika.model.signal import Signal, SignalKind
from onika.runtime import command, news
from onika.runtime.calls import RAISED, Calls
from onika.runtime.code import load, told
from onika.runtime.module import AskAgain, ModuleError
from onika.runtime.running_task import RunningTask
from onika.runtime.unit import Address, Unit
from onika.words.fault import Fault


class Life:
    """Carries out the commands that change what a task is in; what it led to is told to the unit."""

    def __init__(self, unit: Unit, calls: Calls) -> None:
        self._unit = unit
        self._calls = calls

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
            self._unit.refuse(address, entry, "this unit was stopped")
            return None
        if entry == "spawn" and address in self._unit.tasks:
            self._unit.refuse(address, entry, "a task of this name lives here already")
            return None
        self._calls.watch(f"{order.subsystem}/{order.task}")
        try:
            cls = load(order.source, order.path, order.module, code)
            if not isinstance(cls, Fault):
                return RunningTask(order, cls, self._unit.views)
            self._unit.refuse(address, entry, str(cls))
        except RAISED as wrong:
            self._unit.refuse(address, entry, told(wrong))
        finally:
            self._calls.watch("")
        return None

    def initialise(self, task: RunningTask, now: int) -> None:
        """The task lives from now on; `init`."""
        self._unit.admit(task)
        if self._calls.attempt(task, "init", now, task.init):
            task.step(Step.INITIALISED)
            self._unit.tell(news.Initialised(*task.address))

    def kill(self, address: Address, now: int) -> None:
        """`off` where it is ON, `kill`, gone."""
        task = self._unit.tasks.get(address)
        if task is None:
            self._unit.tell(news.Changed(*address, State.KILLED.value, now))
            return
        if task.state in (State.ON, State.ASKING):
            self._leave(task, Step.OFF, now)
        self._unit.dismiss(address)
        self._calls.attempt(task, "kill", now, task.module.kill)
        task.hold()
        task.step(Step.KILL)
        self._unit.tell(news.Changed(*address, State.KILLED.value, now, activation=task.activation))

    def stop(self, now: int) -> None:
        """Every device in hold, everything off, nothing comes on any more."""
        self._unit.is_stopped = True
        for task in self._unit.tasks.values():
            task.hold()  # first every device, then the modules' own words
        for address in list(self._unit.tasks):
            self._off(address, now)

    def fail_devices(self, cause: str, now: int) -> None:
        """Every task that has a device and is ON goes to ERROR."""
        for task in self._unit.tasks.values():
            if task.device is not None and task.is_on:
                self._calls.fail(task, "device", ModuleError(cause), now)

    # On and off

    def switch(self, order: command.Switch, now: int) -> None:
        """Off, forget, rates, on; no cycle comes in between."""
        for name in order.off:
            self._off((order.subsystem, name), now)
        self._unit.forget(order.subsystem, order.forget)
        for name, frequency in order.rates:
            self._rate((order.subsystem, name), frequency, now)
        for launch in order.on:
            self._on((order.subsystem, launch.task), launch, now)

    def answer(self, order: command.Answer, now: int) -> None:
        """The user's answer: on, or ask again."""
        task = self._unit.tasks.get((order.subsystem, order.task))
        if task is None or task.state is not State.ASKING:
            self._unit.refuse((order.subsystem, order.task), "answer", "the task asks for nothing")
            return
        self._begin(task, order.line, now)

    def signalled(self, task: RunningTask, returned: object, now: int) -> None:
        """What a cycle returned: Table 9, as far as it is the unit's; the 0 of a C function is nothing."""
        if type(returned) is int and not returned:
            return
        try:
            signal: Signal = task.sound(returned)
        except TypeError as wrong:
            self._calls.fail(task, "cycle", wrong, now)
            return
        address, run = task.address, task.activation
        if signal.kind is SignalKind.FINISH:
            if self._leave(task, Step.FINISH, now):
                self._unit.tell(news.Finished(*address, signal.flow, signal.loop, now, run))
        elif signal.kind is SignalKind.OFF:
            if self._leave(task, Step.OFF, now):
                self._unit.tell(news.Changed(*address, task.state.value, now, "OFF", run))
        else:
            self._unit.tell(news.Signalled(*address, signal.kind.value, signal.number, signal.text, now, run))

    # While it lives

    def clear(self, order: command.Clear, now: int) -> None:
        """Out of ERROR."""
        task = self._unit.tasks.get((order.subsystem, order.task))
        if task is None or task.state is not State.ERROR:
            self._unit.refuse((order.subsystem, order.task), "clear", "the task is not in ERROR")
            return
        was_initialised = task.is_initialised
        if self._calls.attempt(task, "clear", now, task.clear):
            task.step(Step.CLEAR)
            off = news.Changed(*task.address, task.state.value, now, activation=task.activation)
            self._unit.tell(off if was_initialised else news.Initialised(*task.address))

    def reinit(self, order: command.Reinit, now: int) -> None:
        """Constants in, `reinit`, constants out."""
        task = self._living((order.subsystem, order.task), "reinit", Step.REINIT)
        if task is not None and self._calls.attempt(task, "reinit", now, task.reinit):
            task.step(Step.REINIT)
            self._unit.tell(news.Reinitialised(*task.address))

    def rebind(self, order: command.Rebind) -> None:
        """Ports to other entries, other parameters; no entry point is called."""
        task = self._living((order.subsystem, order.task), "rebind", Step.REBIND)
        if task is None:
            return
        try:
            task.rebind(order.ports, order.local)
        except RAISED as wrong:
            self._unit.refuse(task.address, "rebind", told(wrong))
            return
        task.step(Step.REBIND)
        self._unit.know_rings(task)
        self._unit.tell(news.Rebound(*task.address))

    def rank(self, order: command.Rank) -> None:
        """Other places among tasks with the same deadline."""
        for name, rank in order.ranks:
            task = self._unit.tasks.get((order.subsystem, name))
            if task is None:
                self._unit.refuse((order.subsystem, name), "rank", "no such task")
                continue
            task.spawn = structs.replace(task.spawn, rank=rank)
            self._unit.agenda.rekey(task.slot, task.key)

    def get_or_set(self, order: command.Get | command.Set, now: int) -> None:
        """Ask or tell a module something by name; a Set runs an aperiodic task that is ON once more."""
        address = (order.subsystem, order.task)
        task = self._unit.tasks.get(address)
        if task is None:
            self._unit.refuse(address, "get or set", "no such task")
            return
        self._calls.watch(task.slot.key[2])
        try:
            if isinstance(order, command.Set):
                task.module.set(order.name, order.value)
            value = task.module.get(order.name) if isinstance(order, command.Get) else order.value
            got = news.Got(*address, order.name, value)
            news.encode(got)  # a module may hand out what cannot travel
        except RAISED as wrong:
            self._unit.refuse(address, "get or set", told(wrong))
            return
        finally:
            self._calls.watch("")
        self._unit.tell(got)
        if task.spawn.task_type == "aperiodic" and task.is_on and isinstance(order, command.Set):
            self._unit.agenda.enter(task.slot, now)

    # Inner

    def _living(self, address: Address, entry: str, step: Step) -> RunningTask | None:
        """The task, if it is there and its state allows the step."""
        task = self._unit.tasks.get(address)
        reason = "no such task" if task is None else refusal(task.state, step)
        if reason:
            self._unit.refuse(address, entry, reason)
            return None
        return task

    def _rate(self, address: Address, frequency: float, now: int) -> None:
        task = self._unit.tasks.get(address)
        if task is None:
            self._unit.refuse(address, "rate", "no such task")
            return
        try:
            self._unit.agenda.change(task.slot, task.change_rate(frequency), now)
        except ValueError as wrong:
            self._unit.refuse(address, "rate", str(wrong))

    def _on(self, address: Address, launch: command.Launch, now: int) -> None:
        task = self._unit.tasks.get(address)
        reason = self._why_not_on(task)
        if task is None or reason:
            self._unit.refuse(address, "on", reason)
            return
        if launch.frequency is not None:
            self._rate(address, launch.frequency, now)
        task.activation = launch.activation
        self._begin(task, launch.arguments, now)

    def _why_not_on(self, task: RunningTask | None) -> str:
        if self._unit.is_stopped:
            return "this unit was stopped"
        if task is None:
            return "no such task"
        if not task.is_initialised and task.state is State.OFF:
            return "it was bound anew and waits to be reinitialised"
        return refusal(task.state, Step.ON)

    def _begin(self, task: RunningTask, line: str, now: int) -> None:
        """`on` with an argument line, or ask: what the line lacks, or what the module says of it."""
        try:
            inputs = task.parse(line)
        except ValueError as wrong:
            self._ask(task, str(wrong) if line else "", now)
            return
        try:
            began = self._calls.attempt(task, "on", now, lambda: task.on(now, inputs), passing=AskAgain)
        except AskAgain as again:
            self._ask(task, str(again), now)
            return
        if not began:
            return
        task.line, task.goes_on = line, False
        task.step(Step.ANSWERED if task.state is State.ASKING else Step.ON)
        self._unit.enter(task, now)
        if task.spawn.task_type == "synchronous":
            self._calls.attempt(task, "fileno", now, lambda: self._unit.await_event(task))
        self._unit.tell(news.Changed(*task.address, task.state.value, now, activation=task.activation))

    def _ask(self, task: RunningTask, reason: str, now: int) -> None:
        task.step(Step.ASK)
        items = task.input.items if task.input else ()
        self._unit.tell(news.Asked(*task.address, reason, items, now, task.activation))

    def _off(self, address: Address, now: int) -> None:
        task = self._unit.tasks.get(address)
        if task is None or task.state not in (State.ON, State.ASKING):
            return  # off already: turning off what is off harms nothing
        if self._leave(task, Step.OFF, now):
            self._unit.tell(news.Changed(*address, task.state.value, now, activation=task.activation))

    def _leave(self, task: RunningTask, step: Step, now: int) -> bool:
        """Out of ON or ASKING; `off` runs only after an `on`. False if it raised: the task is in ERROR instead."""
        self._unit.leave(task, now)
        if task.is_on and not self._calls.attempt(task, "off", now, task.off):
            return False
        task.step(step)
        return True
