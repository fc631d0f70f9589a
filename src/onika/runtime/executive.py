"""The executive of one RTPU: carries out commands, runs what is due, says what happened (the law of the cycle).

Sans-I/O: `handle` takes a command and the time, `run_next` runs one cycle; both return news. Between two cycles its
owner delivers the news and the commands that came meanwhile, in this order (law 2).
"""

import select
from collections.abc import Callable, MutableMapping, Sequence

from onika.model.lifecycle import State, Step, refusal
from onika.model.signal import Signal, SignalKind
from onika.ring.slots import Ring
from onika.runtime import command, news
from onika.runtime.agenda import Agenda, Slot
from onika.runtime.binding import Views
from onika.runtime.code import load, showable, told
from onika.runtime.module import AskAgain, ModuleError
from onika.runtime.running_task import LawBroken, RunningTask
from onika.words.fault import Fault

Address = tuple[str, str]
_NOTHING: Sequence[news.News] = ()
_RAISED = (Exception, SystemExit, KeyboardInterrupt)
"""What a module's code may raise without harm to anybody else; a module that exits is as wrong as any other."""


class Executive:
    """Tasks of any subsystems on one processing unit. `watch` is told the task before its code runs, "" after."""

    def __init__(self, rtpu: str, views: Views, watch: Callable[[str], None] | None = None) -> None:
        self.rtpu = rtpu
        self.tasks: dict[Address, RunningTask] = {}
        self._views = views
        self._watches = watch is not None
        self._watch: Callable[[str], None] = watch or (lambda _task: None)
        self._agenda = Agenda()
        self._rings: dict[str, dict[str, Ring]] = {}
        self._events: dict[int, Address] = {}
        self._slots: MutableMapping[Slot, RunningTask] = {}
        self._news: list[news.News] = []
        self._busy_since_ns = 0
        self.is_stopped = False

    # Commands

    def handle(self, order: command.Command, now: int) -> list[news.News]:
        """Carry out one command; what it led to comes back as news."""
        match order:
            case command.Spawn():
                self._spawn(order, now)
            case command.Switch():
                self._switch(order, now)
            case command.Answer():
                self._answer(order, now)
            case command.Clear():
                self._clear(order, now)
            case command.Get() | command.Set():
                self._get_or_set(order, now)
            case command.Kill():
                self._kill((order.subsystem, order.task), now)
            case command.Report():
                self._news.append(self._statuses(now))
            case command.Fail():
                self._fail_devices(order.cause, now)
            case command.Stop() | command.Quit():
                self._stop(now)
        return self._take_news()

    def next_release(self) -> int | None:
        """When the next cycle is due, if any."""
        return self._agenda.next_release()

    def run_next(self, now: int) -> Sequence[news.News] | None:
        """Run the one task that is due first; its news (mostly none), or None if nothing is due."""
        return self.run_due(now, 1)

    def run_due(self, now: int, most: int) -> Sequence[news.News] | None:
        """Run what is due, in order, up to so many cycles or until there is news; None if nothing is due any more."""
        heard = self._run_due(now, most)
        if self._watches:
            self._watch("")
        return heard

    def _run_due(self, now: int, most: int) -> Sequence[news.News] | None:
        agenda, slots, watches = self._agenda, self._slots, self._watches
        slot = agenda.next_due(now)
        while slot is not None:
            task, epoch, signal = slots[slot], slot.epoch, None
            if watches:
                self._watch(slot.key[2])
            try:
                signal = task.cycle(now)
            except _RAISED as wrong:
                self._fail(task, "cycle", wrong, now)
            if signal is not None or task.is_first or task.warnings:
                self._after_cycle(task, signal, now)
            most -= 1
            goes_on = slot.epoch == epoch
            if goes_on and not task.is_periodic:
                agenda.leave(slot)
                goes_on = False
            if self._news or not most:
                if goes_on:
                    agenda.done(slot)
                return self._take_news() if self._news else _NOTHING
            slot = agenda.after(slot, now) if goes_on else agenda.next_due(now)
        return None

    def events(self) -> dict[int, Address]:
        """The descriptors that synchronous tasks which are ON wait for; their owner waits for them with its own."""
        return dict(self._events)

    def event(self, address: Address, now: int) -> list[news.News]:
        """The event of a synchronous task has arrived; nothing happens unless it is ON."""
        task = self.tasks.get(address)
        if task is not None and task.state is State.ON and task.spawn.task_type == "synchronous":
            signal: Signal | None = None
            self._watch(task.slot.key[2])
            try:
                signal = task.event(now)
            except _RAISED as wrong:
                self._fail(task, "cycle", wrong, now)
            self._watch("")
            self._after_cycle(task, signal, now)
        return self._take_news()

    # Inner: commands

    def _spawn(self, order: command.Spawn, now: int) -> None:
        address = (order.subsystem, order.task)
        if address in self.tasks or self.is_stopped:
            reason = "this unit was stopped" if self.is_stopped else "a task of this name lives here already"
            self._news.append(news.Refused(*address, "spawn", reason))
            return
        self._watch(f"{order.subsystem}/{order.task}")
        try:
            cls = load(order.source, order.path, order.module)
            if isinstance(cls, Fault):
                self._news.append(news.Refused(*address, "spawn", str(cls)))
                return
            task = RunningTask(order, cls, self._views, now)
        except _RAISED as wrong:
            self._news.append(news.Refused(*address, "spawn", told(wrong)))
            return
        finally:
            self._watch("")
        self.tasks[address] = task
        self._slots[task.slot] = task
        self._rings.setdefault(order.subsystem, {}).update(task.binding.rings)
        if self._try(task, "init", now, task.init):
            task.step(Step.INITIALISED)
            self._news.append(news.Initialised(*address))

    def _switch(self, order: command.Switch, now: int) -> None:
        for name in order.off:
            self._off((order.subsystem, name), now)
        self._forget(order.subsystem, order.forget)
        for name, frequency in order.rates:
            self._rate((order.subsystem, name), frequency, now)
        for launch in order.on:
            self._on((order.subsystem, launch.task), launch, now)

    def _forget(self, subsystem: str, names: tuple[str, ...]) -> None:
        rings = self._rings.get(subsystem, {})
        for name in names:
            if name in rings:
                rings[name].forget()

    def _rate(self, address: Address, frequency: float, now: int) -> None:
        task = self.tasks.get(address)
        if task is None:
            self._news.append(news.Refused(*address, "rate", "no such task"))
            return
        try:
            self._agenda.change(task.slot, task.change_rate(frequency), now)
        except ValueError as wrong:
            self._news.append(news.Refused(*address, "rate", str(wrong)))

    def _on(self, address: Address, launch: command.Launch, now: int) -> None:
        task = self.tasks.get(address)
        reason = self._why_not_on(task)
        if task is None or reason:
            self._news.append(news.Refused(*address, "on", reason))
            return
        if launch.frequency is not None:
            self._rate(address, launch.frequency, now)
        self._begin(task, launch.arguments, now)

    def _why_not_on(self, task: RunningTask | None) -> str:
        if self.is_stopped:
            return "this unit was stopped"
        if task is None:
            return "no such task"
        return refusal(task.state, Step.ON)

    def _begin(self, task: RunningTask, line: str, now: int) -> None:
        """`on` with an argument line, or ask: what the line lacks, or what the module says of it."""
        try:
            inputs = task.parse(line)
        except ValueError as wrong:
            self._ask(task, str(wrong) if line else "", now)
            return
        try:
            began = self._try(task, "on", now, lambda: task.on(now, inputs), passing=AskAgain)
        except AskAgain as again:
            self._ask(task, str(again), now)
            return
        if not began:
            return
        task.step(Step.ANSWERED if task.state is State.ASKING else Step.ON)
        if task.spawn.task_type == "synchronous":
            self._await_event(task, now)
        else:
            self._agenda.enter(task.slot, now)
        self._news.append(news.Changed(*_address(task), task.state.value, now))

    def _await_event(self, task: RunningTask, now: int) -> None:
        def wait_for_it() -> None:
            descriptor = task.module.fileno()
            select.select([descriptor], [], [], 0)  # says at once what is no descriptor
            self._events[descriptor] = _address(task)

        self._try(task, "fileno", now, wait_for_it)

    def _ask(self, task: RunningTask, reason: str, now: int) -> None:
        task.step(Step.ASK)
        items = task.input.items if task.input else ()
        self._news.append(news.Asked(*_address(task), reason, items, now))

    def _answer(self, order: command.Answer, now: int) -> None:
        task = self.tasks.get((order.subsystem, order.task))
        if task is None or task.state is not State.ASKING:
            self._news.append(news.Refused(order.subsystem, order.task, "answer", "the task asks for nothing"))
            return
        self._begin(task, order.line, now)

    def _off(self, address: Address, now: int) -> None:
        task = self.tasks.get(address)
        if task is None or task.state not in (State.ON, State.ASKING):
            return  # off already: turning off what is off harms nothing
        if self._leave(task, Step.OFF, now):
            self._news.append(news.Changed(*address, task.state.value, now))

    def _leave(self, task: RunningTask, step: Step, now: int) -> bool:
        """Out of ON or ASKING; `off` runs only after an `on`. False if it raised: the task is in ERROR instead."""
        self._leave_agenda(task)
        if task.state is State.ON and not self._try(task, "off", now, task.off):
            return False
        task.step(step)
        return True

    def _clear(self, order: command.Clear, now: int) -> None:
        task = self.tasks.get((order.subsystem, order.task))
        if task is None or task.state is not State.ERROR:
            self._news.append(news.Refused(order.subsystem, order.task, "clear", "the task is not in ERROR"))
            return
        was_initialised = task.is_initialised
        if self._try(task, "clear", now, task.clear):
            task.step(Step.CLEAR)
            told_off = news.Changed(*_address(task), task.state.value, now)
            self._news.append(told_off if was_initialised else news.Initialised(*_address(task)))

    def _get_or_set(self, order: command.Get | command.Set, now: int) -> None:
        task = self.tasks.get((order.subsystem, order.task))
        if task is None:
            self._news.append(news.Refused(order.subsystem, order.task, "get or set", "no such task"))
            return
        try:
            if isinstance(order, command.Set):
                task.module.set(order.name, order.value)
            value = task.module.get(order.name) if isinstance(order, command.Get) else order.value
            got = news.Got(*_address(task), order.name, value)
            news.encode(got)  # a module may hand out what cannot travel
        except _RAISED as wrong:
            self._news.append(news.Refused(*_address(task), "get or set", told(wrong)))
            return
        self._news.append(got)
        if task.spawn.task_type == "aperiodic" and task.state is State.ON and isinstance(order, command.Set):
            self._agenda.enter(task.slot, now)

    def _kill(self, address: Address, now: int) -> None:
        task = self.tasks.pop(address, None)
        if task is None:
            self._news.append(news.Changed(*address, State.KILLED.value, now))
            return
        if task.state in (State.ON, State.ASKING):
            self._leave(task, Step.OFF, now)
        del self._slots[task.slot]
        self._try(task, "kill", now, task.module.kill)
        task.hold()
        task.step(Step.KILL)
        self._news.append(news.Changed(*address, State.KILLED.value, now))

    def _stop(self, now: int) -> None:
        self.is_stopped = True
        for task in self.tasks.values():
            task.hold()  # first every device, then the modules' own words
        for address in list(self.tasks):
            self._off(address, now)

    def _leave_agenda(self, task: RunningTask) -> None:
        self._agenda.leave(task.slot)
        self._events = {fd: address for fd, address in self._events.items() if address != _address(task)}

    def _fail_devices(self, cause: str, now: int) -> None:
        for task in self.tasks.values():
            if task.device is not None and task.state is State.ON:
                self._fail(task, "device", ModuleError(cause), now)

    # Inner: what comes out of a task's own code

    def _try(
        self,
        task: RunningTask,
        entry: str,
        now: int,
        call: Callable[[], None],
        passing: type[Exception] | None = None,
    ) -> bool:
        """Call into a module; what it raises puts the task in ERROR and gives False, but for the kind that passes."""
        self._watch(task.slot.key[2])
        task.module.now = now * 1e-9
        try:
            call()
        except _RAISED as wrong:
            if passing is not None and isinstance(wrong, passing):
                raise
            self._fail(task, entry, wrong, now)
            return False
        finally:
            self._watch("")
        self._warn(task, now)
        return True

    def _after_cycle(self, task: RunningTask, signal: Signal | None, now: int) -> None:
        """What a cycle led to besides its outputs."""
        if task.is_first:
            task.is_first = False
            if task.state is State.ON:
                self._news.append(news.Cycled(*_address(task), now))
                self._check_strays(task, now)
        self._warn(task, now)
        if signal is not None and task.state is State.ON:
            self._signal(task, signal, now)

    def _warn(self, task: RunningTask, now: int) -> None:
        """Pass on what the module warned of."""
        if task.warnings:
            task.counters.warnings += len(task.warnings)
            self._news += [news.Warned(*_address(task), showable(str(text)), now) for text in task.warnings]
            task.warnings.clear()

    def _signal(self, task: RunningTask, returned: object, now: int) -> None:
        address = _address(task)
        try:
            signal = task.sound(returned)
        except TypeError as wrong:
            self._fail(task, "cycle", wrong, now)
            return
        if signal.kind is SignalKind.FINISH:
            if self._leave(task, Step.FINISH, now):
                self._news.append(news.Finished(*address, signal.flow, signal.loop, now))
        elif signal.kind is SignalKind.OFF:
            if self._leave(task, Step.OFF, now):
                self._news.append(news.Changed(*address, task.state.value, now, "OFF"))
        else:
            self._news.append(news.Signalled(*address, signal.kind.value, signal.number, signal.text, now))

    def _fail(self, task: RunningTask, entry: str, wrong: BaseException, now: int) -> None:
        """The module's `error` entry first: it mends, and nobody is told, or the task goes to ERROR (A09).

        A device holds either way: this cycle has not commanded it.
        """
        task.hold()
        if entry == "cycle" and not isinstance(wrong, LawBroken) and self._mended(task, wrong):
            return
        self._leave_agenda(task)
        task.step(Step.FAIL)
        path, line, trace = task.where(wrong)
        text = told(wrong) + (self._source_of(task) if isinstance(wrong, LawBroken) else "")
        self._news.append(news.Failed(*_address(task), entry, text, path, line, trace, now))

    def _source_of(self, task: RunningTask) -> str:
        """The task on this unit that first wrote what is not finite, in the order of data flow; empty if none did."""
        others = [one for one in self.tasks.values() if one.spawn.subsystem == task.spawn.subsystem and one is not task]
        for one in sorted(others, key=lambda other: other.spawn.rank):
            found = one.binding.not_finite_outputs()
            if found:
                return f"; first written by task {one.spawn.task}, in {found[0]}"
        return ""

    def _mended(self, task: RunningTask, wrong: BaseException) -> bool:
        try:
            return bool(task.module.error(wrong))
        except _RAISED:
            return False

    def _check_strays(self, task: RunningTask, now: int) -> None:
        strays = task.strays()
        if strays and task.state is State.ON:
            self._fail(task, "check", NameError(strays), now)

    def _statuses(self, now: int) -> news.Statuses:
        span = max(now - self._busy_since_ns, 1)
        total = sum(task.counters.total_ns for task in self.tasks.values())
        tasks = tuple(task.report(now) for task in self.tasks.values())
        self._busy_since_ns = now
        return news.Statuses(self.rtpu, total / span, tasks)

    def _take_news(self) -> list[news.News]:
        taken, self._news = self._news, []
        return taken


def _address(task: RunningTask) -> Address:
    return task.spawn.subsystem, task.spawn.task
