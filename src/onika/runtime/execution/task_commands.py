"""Commands to one living task: out of ERROR, constants, ports, places, values by name (law 11)."""

from msgspec import structs

from onika.model.lifecycle import LifecycleInput, State, refusal
from onika.runtime import command, news
from onika.runtime.execution.entry_points import RAISED, EntryPoints
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.unit import Address, ProcessingUnit
from onika.runtime.modules.code import raised
from onika.words.reason import Reason


class TaskCommands:
    """Carries out the commands that are neither its birth, its coming on and going off, nor its end."""

    def __init__(self, unit: ProcessingUnit, calls: EntryPoints) -> None:
        self._unit = unit
        self._entry_points = calls

    def change(self, order: command.Command, now: int) -> None:
        """What is done to one task while it lives."""
        match order:
            case command.Rank():
                self.rank(order)
            case command.Reinit():
                self.reinit(order, now)
            case command.Rebind():
                self.rebind(order)
            case command.Clear():
                self.clear(order, now)
            case command.Get() | command.Set():
                self.get_or_set(order, now)

    def clear(self, order: command.Clear, now: int) -> None:
        """Out of ERROR."""
        task = self._unit.tasks.get((order.subsystem, order.task))
        if task is None or task.state is not State.ERROR:
            self._unit.refuse((order.subsystem, order.task), "clear", Reason.of("runtime.not_in_error"))
            return
        was_initialised = task.is_initialised
        if self._entry_points.attempt(task, "clear", now, task.clear):
            task.step(LifecycleInput.CLEAR)
            off = news.Changed(*task.address, task.state.value, now, activation=task.activation)
            self._unit.tell(off if was_initialised else news.Initialised(*task.address))

    def reinit(self, order: command.Reinit, now: int) -> None:
        """Constants in, `reinit`, constants out."""
        task = self._living((order.subsystem, order.task), "reinit", LifecycleInput.REINIT)
        if task is not None and self._entry_points.attempt(task, "reinit", now, task.reinit):
            task.step(LifecycleInput.REINIT)
            self._unit.tell(news.Reinitialised(*task.address))

    def rebind(self, order: command.Rebind) -> None:
        """Ports to other entries, other parameters; no entry point is called."""
        task = self._living((order.subsystem, order.task), "rebind", LifecycleInput.REBIND)
        if task is None:
            return
        try:
            task.rebind(order.ports, order.local)
        except RAISED as wrong:
            self._unit.refuse(task.address, "rebind", raised(wrong, task.spawn.module))
            return
        task.step(LifecycleInput.REBIND)
        self._unit.know_rings(task)
        self._unit.tell(news.Rebound(*task.address))

    def rank(self, order: command.Rank) -> None:
        """Other places among tasks with the same deadline."""
        for name, rank in order.ranks:
            task = self._unit.tasks.get((order.subsystem, name))
            if task is None:
                self._unit.refuse((order.subsystem, name), "rank", Reason.of("runtime.no_such_task"))
                continue
            task.spawn = structs.replace(task.spawn, rank=rank)
            self._unit.scheduler.rekey(task.slot, task.key)

    def get_or_set(self, order: command.Get | command.Set, now: int) -> None:
        """Ask or tell a module something by name; a Set runs an aperiodic task that is ON once more."""
        address = (order.subsystem, order.task)
        task = self._unit.tasks.get(address)
        if task is None:
            self._unit.refuse(address, "get or set", Reason.of("runtime.no_such_task"))
            return
        self._entry_points.watch(task.slot.key[2])
        try:
            if isinstance(order, command.Set):
                task.module.set(order.name, order.value)
                self._unit.watch(task, now)
            value = task.module.get(order.name) if isinstance(order, command.Get) else order.value
            got = news.Got(*address, order.name, value)
            news.encode(got)  # a module may hand out what cannot travel
        except RAISED as wrong:
            self._unit.refuse(address, "get or set", raised(wrong, task.spawn.module))
            return
        finally:
            self._entry_points.watch("")
        self._unit.tell(got)
        if task.spawn.task_type == "aperiodic" and task.is_on and isinstance(order, command.Set):
            self._unit.scheduler.enter(task.slot, now)

    # Inner

    def _living(self, address: Address, entry: str, step: LifecycleInput) -> RunningTask | None:
        """The task, if it is there and its state allows the step."""
        task = self._unit.tasks.get(address)
        reason = Reason.of("runtime.no_such_task") if task is None else refusal(task.state, step)
        if reason:
            self._unit.refuse(address, entry, reason)
            return None
        return task
