"""The exchange of a living task's module: the new one is made beside the old one and takes its place (law 21)."""

import hashlib
from contextlib import suppress
from types import CodeType, SimpleNamespace

from msgspec import structs

from onika.model.lifecycle import LifecycleInput, State, refusal
from onika.runtime import command, news
from onika.runtime.execution.entry_points import RAISED, EntryPoints
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.task_lifecycle import TaskLifecycle
from onika.runtime.execution.unit import ProcessingUnit
from onika.runtime.modules.module import Module
from onika.words.fault import Fault
from onika.words.reason import NOTHING, Reason, reason_of

_SWAP = "swap"


class ModuleExchange:
    """Until the exchange itself nothing is seen of the new module: whatever fails, the old one goes on as it was."""

    def __init__(self, unit: ProcessingUnit, calls: EntryPoints, life: TaskLifecycle) -> None:
        self._unit = unit
        self._entry_points = calls
        self._lifecycle = life

    def swap(self, order: command.Swap, now: int) -> None:
        """Make, initialise, exchange."""
        new = self.make(order)
        if new is not None:
            self.complete(new, now)

    def make(self, order: command.Swap, code: CodeType | Fault | None = None) -> RunningTask | None:
        """The new task, which does not live yet; None where that is refused."""
        spawn = order.spawn
        old = self._unit.tasks.get((spawn.subsystem, spawn.task))
        reason = Reason.of("runtime.no_such_task") if old is None else _why_not(old, spawn)
        if old is None or reason:
            self._unit.refuse((spawn.subsystem, spawn.task), _SWAP, reason)
            return None
        return self._lifecycle.make(spawn, _SWAP, code)

    def complete(self, new: RunningTask, now: int) -> None:
        """Initialise the new task and put it in the place of the old one, as that stands by now."""
        old = self._unit.tasks.get(new.address)
        if old is None:
            self._unit.refuse(new.address, _SWAP, Reason.of("runtime.no_such_task"))
            return
        reason = _why_not(old, new.spawn) or self._why_hardware_not(old, new)
        if reason:
            self._unit.refuse(new.address, _SWAP, reason)
            return
        new.spawn = structs.replace(new.spawn, frequency=old.spawn.frequency)
        new.period_ns, new.frequency, new.module.dt = old.period_ns, old.frequency, old.module.dt
        new.line, new.activation = old.line, old.activation
        reason = self._entry_points.trial(new, "init", now, lambda: new.prepare(new.module.init))
        reason = reason or (self._come_on(old, new, now) if old.is_on else NOTHING)
        if reason:
            with suppress(RAISED):  # it only gives back what `init` took; the refusal tells what is wrong with it
                new.module.kill()
            self._unit.refuse(new.address, _SWAP, reason)
            return
        self._settle(old, new, now)

    # Inner

    def _why_hardware_not(self, old: RunningTask, new: RunningTask) -> Reason:
        if old.is_on and (_commands(old) or _commands(new)):
            return Reason.of("runtime.commands_while_on")
        return NOTHING

    def _come_on(self, old: RunningTask, new: RunningTask, now: int) -> Reason:
        """The new module takes over from the old one, or comes on in its place; why it cannot, empty if it can."""
        new.goes_on = type(new.module).take is not Module.take
        if new.goes_on:
            reason = self._entry_points.trial(new, "take", now, lambda: _take(old, new))
        else:
            try:
                inputs = new.parse(old.line)
            except ValueError as wrong:
                return Reason.of("runtime.asks_other_input", entry="on", why=reason_of(wrong))
            reason = self._entry_points.trial(new, "on", now, lambda: _begin(new, inputs, now))
        reason = reason or self._unit.objection(new)
        if not reason and new.is_synchronous:
            reason = self._entry_points.trial(new, "fileno", now, lambda: self._await_event(old, new))
        return reason

    def _await_event(self, old: RunningTask, new: RunningTask) -> None:
        events = self._unit.events
        self._unit.forget_event(old)
        try:
            self._unit.await_event(new)
        except BaseException:
            self._unit.events = events
            raise

    def _settle(self, old: RunningTask, new: RunningTask, now: int) -> None:
        """The exchange itself: it cannot fail any more. What the old module raises on its way out is a warning."""
        was_on = old.is_on
        if was_on and not new.goes_on:
            self._farewell(old, new, "off", now)
        new.state = old.state
        new.step(LifecycleInput.SWAP)
        if was_on:
            new.counters.begin(now)
            new.is_first = True
        self._unit.exchange(old, new)
        if was_on:
            self._unit.speak_on(new, now)
            self._unit.watch(new, now)
        new.publish_constants(first_values=not was_on)
        if was_on and not new.goes_on:
            new.publish()
        self._farewell(old, new, "kill", now)
        old.part()
        self._entry_points.warn(new, now)
        self._unit.tell(news.Swapped(*new.address, hashlib.sha256(new.spawn.source.encode()).hexdigest()))

    def _farewell(self, old: RunningTask, new: RunningTask, entry: str, now: int) -> None:
        reason = self._entry_points.trial(old, entry, now, old.off if entry == "off" else old.module.kill)
        if reason:
            new.module.warn(Reason.of("runtime.in_exchanged", why=reason))


def _why_not(old: RunningTask, spawn: command.Spawn) -> Reason:
    if old.spawn.task_type != spawn.task_type:
        return Reason.of("runtime.other_type", former=old.spawn.task_type, given=spawn.task_type)
    if old.state is State.OFF and not old.is_initialised:
        return Reason.of("runtime.waits_to_be_reinitialised")
    return refusal(old.state, LifecycleInput.SWAP)


def _commands(task: RunningTask) -> bool:
    """Whether it drives a device; one that only listens harms nothing."""
    return task.hardware or (task.spawn.device is not None and task.spawn.device.command_offset is not None)


def _take(old: RunningTask, new: RunningTask) -> None:
    new.look()
    new.module.take(old.module)
    new.no_strays()


def _begin(new: RunningTask, inputs: SimpleNamespace, now: int) -> None:
    new.begin(now, inputs)
    new.no_strays()
