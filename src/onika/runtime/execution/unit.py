"""A processing unit: its tasks, their places in the scheduler, the descriptors they wait for, its news."""

import select
from collections.abc import MutableMapping

from onika.model.rules.starvation import starved
from onika.ring.slots import Ring
from onika.runtime import news
from onika.runtime.command import Spawn
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.modules.binding import Views
from onika.runtime.prepared_switches import PreparedSwitches
from onika.runtime.sandbox.sandboxed_module import Sandbox
from onika.runtime.scheduler import Scheduler, TaskSlot
from onika.runtime.transfer.bumpless_transfer import WATCHED_NS
from onika.words.reason import NOTHING, Reason

Address = tuple[str, str]
"""Subsystem and task."""


class ProcessingUnit:
    """Shared by all that changes the lives of its tasks; none of this runs a module's code but `fileno`."""

    def __init__(self, rtpu: str, views: Views) -> None:
        self.rtpu = rtpu
        self.views = views
        self.sandboxes: dict[Address, Sandbox] = {}
        """Those that were begun for tasks which are still to come."""
        self.tasks: dict[Address, RunningTask] = {}
        self.scheduler = Scheduler()
        self.slots: MutableMapping[TaskSlot, RunningTask] = {}
        self.events: dict[int, Address] = {}
        self.speaking: dict[Address, RunningTask] = {}
        """What is ON and has an outside partner."""
        self.news: list[news.News] = []
        self.prepared = PreparedSwitches()
        self.is_stopped = False
        self._hardware: dict[Address, RunningTask] = {}
        self._rings: dict[str, dict[str, Ring]] = {}
        self._last_tid = 0

    @property
    def is_busy(self) -> bool:
        """Whether anything is ON, and so must not miss a cycle."""
        return any(task.is_on for task in self.tasks.values())

    def tell(self, event: news.News) -> None:
        """Say something to the runner."""
        self.news.append(event)

    def refuse(self, address: Address, command: str, reason: Reason) -> None:
        """Say that a command was not carried out."""
        self.news.append(news.Refused(*address, command, reason))

    def is_ready(self, spawn: Spawn) -> bool:
        """Whether a task can be made without waiting: its sandbox, where it has one, has loaded the module."""
        sandbox = self.sandboxes.get((spawn.subsystem, spawn.task)) if spawn.is_sandboxed else None
        return sandbox is None or sandbox.is_heard

    def take_news(self) -> list[news.News]:
        """What was said since the last call."""
        taken, self.news = self.news, []
        return taken

    # Tasks

    def admit(self, task: RunningTask) -> None:
        """A new task lives here."""
        self._last_tid += 1
        task.tid = self._last_tid
        self.tasks[task.address] = task
        self.slots[task.slot] = task
        self._know_hardware(task)
        self.know_rings(task)

    def exchange(self, old: RunningTask, new: RunningTask) -> None:
        """The new task stands where the old one stood: number, place on the scheduler, rate, figures of misses."""
        new.tid = old.tid
        new.slot = old.slot
        self.tasks[old.address] = new
        self.slots[old.slot] = new
        self._know_hardware(new)
        self.scheduler.rekey(new.slot, new.key)
        self.know_rings(new)

    def dismiss(self, address: Address) -> RunningTask | None:
        """The task lives here no more; None if it never did."""
        task = self.tasks.pop(address, None)
        self._hardware.pop(address, None)
        if task is not None:
            del self.slots[task.slot]
            self._know_no_more(address[0])
        return task

    def _know_hardware(self, task: RunningTask) -> None:
        """Whether it drives a device; its code may be another than it was."""
        if task.input_guard is None:
            self._hardware.pop(task.address, None)
        else:
            self._hardware[task.address] = task
            task.input_guard.transfer.tell = self.tell

    # ON and no more

    def enter(self, task: RunningTask, now: int) -> None:
        """The task cycles from now on."""
        task.counters.on_since_ns = now
        if not task.is_synchronous or task.asks:
            self.scheduler.enter(task.slot, now)
        if task.partner is not None:
            self.speaking[task.address] = task

    def leave(self, task: RunningTask, now: int) -> None:
        """The task cycles no more; harmless where it did not."""
        task.counters.end(now)
        self.scheduler.leave(task.slot)
        self.forget_event(task)
        self.speaking.pop(task.address, None)

    def await_event(self, task: RunningTask) -> None:
        """Wait for the descriptor that a synchronous module names; raises what the module or `select` says of it."""
        descriptor = task.module.fileno()
        select.select([descriptor], [], [], 0)  # says at once what is no descriptor
        self.events[descriptor] = task.address

    def speak_on(self, new: RunningTask, now: int) -> None:
        """After an exchange while ON: the new task talks with its own partner, if any, and asks at its next time."""
        self.speaking.pop(new.address, None)
        if new.partner is not None:
            self.speaking[new.address] = new
        if new.is_synchronous:
            self.scheduler.leave(new.slot)
        if new.asks and not new.is_owed:
            self.scheduler.resume(new.slot, now)

    def forget_event(self, task: RunningTask) -> None:
        """Wait for the task's descriptor no more."""
        if task.is_synchronous and self.events:
            self.events = {fd: address for fd, address in self.events.items() if address != task.address}

    # Variables

    def know_rings(self, task: RunningTask) -> None:
        """Know the variables of a task by their names, and let it know those of its subsystem."""
        rings = self._rings.setdefault(task.spawn.subsystem, {})
        rings.update(task.binding.rings)
        task.binding_guard.known = rings

    def _know_no_more(self, subsystem: str) -> None:
        """Know the variables of those who live on alone: the memory of others may have become another variable's."""
        rings = self._rings.get(subsystem, {})
        rings.clear()
        for task in self.tasks.values():
            if task.spawn.subsystem == subsystem:
                rings.update(task.binding.rings)
        if not rings:
            self._rings.pop(subsystem, None)

    def watch(self, task: RunningTask, now: int) -> None:
        """What this task makes of its outputs is another thing from now on: inputs of hardware are watched (law 33).

        On whatever unit that is. Hardware itself feeds none.
        """
        if task.input_guard is None:
            words = task.watch_words
            periods_ns = 2 * task.period_ns if task.is_on and task.is_periodic else 0
            words[0] = max(words[0], now + WATCHED_NS + periods_ns)

    def objection(self, task: RunningTask) -> Reason:
        """Why what a task that comes on has in its outputs cannot be given to a device; empty where it can."""
        outputs = task.binding.real_outputs()
        for running in self._hardware.values() if outputs else ():
            if running.spawn.subsystem == task.spawn.subsystem and running.is_driving and running.input_guard:
                for svar, value in outputs.items():
                    if reason := running.input_guard.transfer.objection(svar, value):
                        return reason
        return NOTHING

    def starved_by(self, failed: RunningTask) -> list[tuple[RunningTask, str]]:
        """The hardware here that is fed by a task that fails, through tasks that are ON, and the variable it wrote."""
        home = failed.spawn.subsystem
        working = {task.spawn.task: task for task in self.tasks.values() if task.is_on and task.spawn.subsystem == home}
        hardware = [name for name, task in working.items() if task.hardware]
        fed = starved(failed.data_flow, [task.data_flow for task in working.values()], hardware)
        return [(working[name], variable) for name, variable in fed.items()]

    def forget(self, subsystem: str, names: tuple[str, ...]) -> None:
        """These variables steer nothing any more (law 3)."""
        rings = self._rings.get(subsystem, {})
        for name in names:
            if name in rings:
                rings[name].forget()
