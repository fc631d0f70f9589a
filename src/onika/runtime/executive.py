"""The executive of one RTPU: carries out commands, runs what is due, says what happened (the law of the cycle).

Sans-I/O: `handle` takes a command and the time, `run_next` runs one cycle; both return news. Between two cycles its
owner delivers the news and the commands that came meanwhile, in this order (law 2).
"""

from collections.abc import Callable, MutableMapping, Sequence

from onika.model.lifecycle import IllegalTransition, State, Step, after
from onika.model.signal import Signal, SignalKind
from onika.runtime import command, news
from onika.runtime.agenda import Agenda
from onika.runtime.binding import Views
from onika.runtime.code import load, told
from onika.runtime.module import AskAgain, ModuleError
from onika.runtime.running_task import Counters, RunningTask
from onika.words.fault import Fault

Address = tuple[str, str]
_NOTHING: Sequence[news.News] = ()


class Executive:
    """Tasks of any subsystems on one processing unit. `watch` is told the task before its code runs, "" after."""

    def __init__(self, rtpu: str, views: Views, watch: Callable[[str], None] = lambda _task: None) -> None:
        self.rtpu = rtpu
        self.tasks: dict[Address, RunningTask] = {}
        self._views = views
        self._watch = watch
        self._agenda = Agenda()
        self._slots: MutableMapping[int, RunningTask] = {}
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
        slot = self._agenda.next_due(now)
        if slot is None:
            return None
        task = self._slots[id(slot)]
        epoch = slot.epoch
        self._watch(slot.key[2])
        signal = None
        try:
            signal = task.cycle(now)
        except Exception as wrong:
            self._fail(task, "cycle", wrong, now)
        self._watch("")
        if signal is not None or task.is_first or task.warnings:
            self._after_cycle(task, signal, now)
        if slot.epoch == epoch and task.is_periodic:
            self._agenda.done(slot, now)
        return self._take_news() if self._news else _NOTHING

    def event(self, address: Address, now: int) -> list[news.News]:
        """The event of a synchronous task has arrived; nothing happens unless it is ON."""
        task = self.tasks.get(address)
        if task is not None and task.state is State.ON:
            signal: Signal | None = None
            try:
                signal = task.event(now)
            except Exception as wrong:
                self._fail(task, "cycle", wrong, now)
            self._after_cycle(task, signal, now)
        return self._take_news()

    # Inner: commands

    def _spawn(self, order: command.Spawn, now: int) -> None:
        address = (order.subsystem, order.task)
        if address in self.tasks or self.is_stopped:
            reason = "this unit was stopped" if self.is_stopped else "a task of this name lives here already"
            self._news.append(news.Refused(*address, "spawn", reason))
            return
        cls = load(order.source, order.path, order.module)
        if isinstance(cls, Fault):
            self._news.append(news.Refused(*address, "spawn", str(cls)))
            return
        self._watch(f"{order.subsystem}/{order.task}")
        try:
            task = RunningTask(order, cls, self._views, now)
        except Exception as wrong:
            self._news.append(news.Refused(*address, "spawn", told(wrong)))
            return
        finally:
            self._watch("")
        self.tasks[address] = task
        self._slots[id(task.slot)] = task
        if self._try(task, "init", now, task.init):
            task.step(Step.INITIALISED)
            self._news.append(news.Initialised(*address, 0))

    def _switch(self, order: command.Switch, now: int) -> None:
        for name in order.off:
            self._off((order.subsystem, name), now)
        self._forget(order.subsystem, order.forget)
        for name, frequency in order.rates:
            self._rate((order.subsystem, name), frequency, now)
        for launch in order.on:
            self._on((order.subsystem, launch.task), launch, now)

    def _forget(self, subsystem: str, names: tuple[str, ...]) -> None:
        if not names:
            return
        wanted = set(names)
        for (home, _), task in self.tasks.items():
            if home == subsystem:
                for svar in wanted & task.binding.rings.keys():
                    task.binding.rings[svar].forget()

    def _rate(self, address: Address, frequency: float, now: int) -> None:
        task = self.tasks.get(address)
        if task is None or frequency <= 0:
            self._news.append(news.Refused(*address, "rate", "no such task or rate"))
            return
        task.period_ns = round(1e9 / frequency)
        task.module.dt = 1.0 / frequency
        self._agenda.change(task.slot, task.period_ns, now)

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
        return _refusal(task.state, Step.ON)

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
        if task.spawn.task_type != "synchronous":
            self._agenda.enter(task.slot, now)
        self._news.append(news.Changed(*_address(task), task.state.value, now))

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
        self._leave(task, Step.OFF, now)
        self._news.append(news.Changed(*address, task.state.value, now))

    def _leave(self, task: RunningTask, step: Step, now: int) -> None:
        """Out of ON or ASKING; `off` runs only after an `on`."""
        was_on = task.state is State.ON
        self._agenda.leave(task.slot)
        if was_on:
            self._try(task, "off", now, task.off)
        if task.state is not State.ERROR:
            task.step(step)

    def _clear(self, order: command.Clear, now: int) -> None:
        task = self.tasks.get((order.subsystem, order.task))
        if task is None or task.state is not State.ERROR:
            self._news.append(news.Refused(order.subsystem, order.task, "clear", "the task is not in ERROR"))
        elif self._try(task, "clear", now, task.module.clear):
            task.step(Step.CLEAR)
            self._news.append(news.Changed(*_address(task), task.state.value, now))

    def _get_or_set(self, order: command.Get | command.Set, now: int) -> None:
        task = self.tasks.get((order.subsystem, order.task))
        if task is None:
            self._news.append(news.Refused(order.subsystem, order.task, "get or set", "no such task"))
            return
        try:
            if isinstance(order, command.Set):
                task.module.set(order.name, order.value)
            value = task.module.get(order.name) if isinstance(order, command.Get) else order.value
        except Exception as wrong:
            self._news.append(news.Refused(*_address(task), "get or set", told(wrong)))
            return
        self._news.append(news.Got(*_address(task), order.name, value))
        if task.spawn.task_type == "aperiodic" and task.state is State.ON and isinstance(order, command.Set):
            self._agenda.enter(task.slot, now)

    def _kill(self, address: Address, now: int) -> None:
        task = self.tasks.pop(address, None)
        if task is None:
            self._news.append(news.Changed(*address, State.KILLED.value, now))
            return
        if task.state in (State.ON, State.ASKING):
            self._leave(task, Step.OFF, now)
        del self._slots[id(task.slot)]
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
        try:
            call()
        except Exception as wrong:
            if passing is not None and isinstance(wrong, passing):
                raise
            self._fail(task, entry, wrong, now)
            return False
        finally:
            self._watch("")
        return True

    def _after_cycle(self, task: RunningTask, signal: Signal | None, now: int) -> None:
        """What a cycle led to besides its outputs."""
        if task.is_first:
            task.is_first = False
            self._news.append(news.Cycled(*_address(task), now))
            self._check_strays(task, now)
        if task.warnings:
            task.counters.warnings += len(task.warnings)
            self._news += [news.Warned(*_address(task), text, now) for text in task.warnings]
            task.warnings.clear()
        if signal is not None and task.state is State.ON:
            self._signal(task, signal, now)

    def _signal(self, task: RunningTask, signal: Signal | object, now: int) -> None:
        address = _address(task)
        if not isinstance(signal, Signal):
            self._fail(task, "cycle", TypeError(f"expected a signal or None from cycle, found {signal!r}"), now)
        elif signal.kind is SignalKind.FINISH and not task.trigger:
            self._fail(task, "cycle", TypeError("only a trigger finishes a job (dissertation §C.1)"), now)
        elif signal.kind is SignalKind.FINISH:
            self._leave(task, Step.FINISH, now)
            self._news.append(news.Finished(*address, signal.flow, signal.loop, now))
        elif signal.kind is SignalKind.OFF:
            self._leave(task, Step.OFF, now)
            self._news.append(news.Changed(*address, task.state.value, now, "OFF"))
        else:
            self._news.append(news.Signalled(*address, signal.kind.value, signal.number, signal.text, now))

    def _fail(self, task: RunningTask, entry: str, wrong: Exception, now: int) -> None:
        """The module's `error` entry first: it mends, and nobody is told, or the task goes to ERROR (A09)."""
        if entry == "cycle" and self._mended(task, wrong):
            return
        self._agenda.leave(task.slot)
        task.hold()
        task.step(Step.FAIL)
        path, line, trace = task.where(wrong)
        self._news.append(news.Failed(*_address(task), entry, told(wrong), path, line, trace, now))

    def _mended(self, task: RunningTask, wrong: Exception) -> bool:
        try:
            return bool(task.module.error(wrong))
        except Exception:
            return False

    def _check_strays(self, task: RunningTask, now: int) -> None:
        strays = task.strays()
        if strays and task.state is State.ON:
            self._fail(task, "check", NameError(strays), now)

    def _statuses(self, now: int) -> news.Statuses:
        span = max(now - self._busy_since_ns, 1)
        total = sum(task.counters.total_ns for task in self.tasks.values())
        tasks = tuple(_status(task, now) for task in self.tasks.values())
        self._busy_since_ns = now
        return news.Statuses(self.rtpu, total / span, tasks)

    def _take_news(self) -> list[news.News]:
        taken, self._news = self._news, []
        return taken


def _address(task: RunningTask) -> Address:
    return task.spawn.subsystem, task.spawn.task


def _refusal(state: State, step: Step) -> str:
    try:
        after(state, step)
    except IllegalTransition as refused:
        return str(refused)
    return ""


def _status(task: RunningTask, now: int) -> news.TaskStatus:
    counters, spawn = task.counters, task.spawn
    span = max(now - counters.since_ns, 1) * 1e-9
    mean = counters.total_ns / counters.cycles if counters.cycles else 0.0
    status = news.TaskStatus(
        subsystem=spawn.subsystem,
        task=spawn.task,
        module=spawn.module,
        state=task.state.value,
        type=spawn.task_type,
        crit=-task.slot.key[0],
        cycle=counters.cycles,
        miss=task.slot.missed,
        warn=counters.warnings,
        reference_hz=1e9 / task.period_ns,
        measured_hz=counters.cycles / span,
        profiled_s=span,
        total_us=counters.total_ns / 1e3,
        least_us=counters.least_ns / 1e3,
        mean_us=mean / 1e3,
        most_us=counters.most_ns / 1e3,
    )
    task.counters = Counters(now)
    task.slot.missed = 0
    return status
