"""Calls of the entry points of modules; where one raises: repaired, ERROR or refused (requirements A09, A18)."""

from collections.abc import Callable

from onika.model.lifecycle import LifecycleInput
from onika.model.rules.starvation import writer_failed
from onika.model.signal import Signal
from onika.runtime import news
from onika.runtime.error import AskAgain, LawBroken
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.statistics import values_of
from onika.runtime.execution.unit import ProcessingUnit
from onika.runtime.modules.binding_guard import BindingChanged
from onika.runtime.modules.code import raised, sayable, where
from onika.words.reason import NOTHING, Reason

RAISED = BaseException
"""What a module's code may raise without harm to anybody else; a module that exits is as wrong as any other."""


class EntryPoints:
    """Runs code of modules on a unit. `watch` is told the task before its code runs; the executive says "" after."""

    def __init__(self, unit: ProcessingUnit, watch: Callable[[str], None] | None = None) -> None:
        self._unit = unit
        self.is_watched = watch is not None
        self.watch: Callable[[str], None] = watch or (lambda _task: None)

    def attempt(
        self, task: RunningTask, entry: str, now: int, call: Callable[[], None], passing: type[Exception] | None = None
    ) -> bool:
        """Call into a module; what it raises puts the task in ERROR and gives False, but for the kind that passes."""
        self.watch(task.slot.key[2])
        task.module.now = now * 1e-9
        try:
            call()
        except RAISED as wrong:
            if passing is not None and isinstance(wrong, passing):
                raise
            self.fail(task, entry, wrong, now)
            return False
        if task.warnings:
            self.warn(task, now)
        return True

    def trial(self, task: RunningTask, entry: str, now: int, call: Callable[[], None]) -> Reason:
        """Call into a module that does not live yet, or no more: what it raised as a sentence, empty if nothing."""
        self.watch(task.slot.key[2])
        task.module.now = now * 1e-9
        try:
            call()
        except AskAgain as again:
            return Reason.of("runtime.asks_other_input", entry=entry, why=raised(again, task.spawn.module))
        except RAISED as wrong:
            path, line, _ = where(task.spawn.path, wrong)
            why = raised(wrong, task.spawn.module)
            if not line:
                return Reason.of("runtime.entry_failed", entry=entry, why=why)
            return Reason.of("runtime.entry_failed_at", entry=entry, why=why, path=path, line=str(line))
        finally:
            self.watch("")
        return NOTHING

    def event(self, task: RunningTask, now: int) -> Signal | None:
        """The one run of a synchronous task that its event leads to."""
        self.watch(task.slot.key[2])
        try:
            return task.event(now)
        except RAISED as wrong:
            self.fail(task, "cycle", wrong, now)
            return None
        finally:
            self.watch("")

    def warn(self, task: RunningTask, now: int) -> None:
        """Pass on what the module warned of."""
        if task.warnings:
            task.counters.warnings += len(task.warnings)
            for reason in task.warnings:
                self._unit.tell(news.Warned(*task.address, sayable(reason, task.spawn.module), now))
            task.warnings.clear()

    def fail(self, task: RunningTask, entry: str, wrong: BaseException, now: int) -> None:
        """The module's `error` entry first: it mends, and nobody is told, or the task goes to ERROR (A09).

        A device holds either way: this cycle has not commanded it.
        """
        task.hold()
        if entry == "cycle" and not isinstance(wrong, LawBroken) and self._mended(task, wrong):
            return
        was_working = task.is_on and entry != "off"
        self._unit.leave(task, now)
        self._unit.prepared.drop(task.address[0])
        task.step(LifecycleInput.FAIL)
        path, line, trace = where(task.spawn.path, wrong)
        text = self._traced(task, wrong) if isinstance(wrong, LawBroken) else raised(wrong, task.spawn.module)
        values = values_of(task.binding)
        self._unit.tell(news.Failed(*task.address, entry, text, path, line, trace, now, task.activation, values))
        if was_working and not task.passive:
            self._starve(task, now)

    def _starve(self, failed: RunningTask, now: int) -> None:
        """No device is driven on with what this task wrote; what goes off by itself has left a last value instead."""
        for task, variable in self._unit.starved_by(failed):
            cause = writer_failed(failed.spawn.task, variable, failed.state)
            self.fail(task, "cycle", LawBroken(cause), now)

    def _mended(self, task: RunningTask, wrong: BaseException) -> bool:
        try:
            return bool(task.module.error(wrong))
        except RAISED:
            return False

    def _traced(self, task: RunningTask, wrong: LawBroken) -> Reason:
        """What is wrong, and which task on this unit first wrote what is not finite, in the order of data flow."""
        reason = raised(wrong, task.spawn.module)
        if isinstance(wrong, BindingChanged):
            return reason
        home = task.spawn.subsystem
        others = [other for other in self._unit.tasks.values() if other.spawn.subsystem == home and other is not task]
        for other in sorted(others, key=lambda other: other.spawn.rank):
            outputs = other.binding.not_finite_outputs()
            if outputs:
                return Reason.of("runtime.first_written", reason=reason, task=other.spawn.task, variable=outputs[0])
        return reason
