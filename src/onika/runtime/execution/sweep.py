"""A sweep: one cycle of each of some tasks by a function that is made for them alone, from its source.

`onika doctor --sweep` prints such a source. It is compiled once for each set of tasks that are alike, and bound to the
tasks that live.
"""

from collections.abc import Callable, Sequence
from functools import lru_cache
from time import perf_counter_ns
from types import CodeType
from typing import Any

import numpy as np

from onika.model.signal import Signal
from onika.ring.last_words import name_of
from onika.ring.slots import seal_of
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.sweep_source import SweepMember, SweepName, SweepPort, sweep_source
from onika.runtime.execution.whereabouts import Whereabouts
from onika.runtime.modules.binding import CycleInput, CycleOutput

KEPT_CODE = 64
"""Compiled sources that are kept; a run has as many as it has jobs."""
_MOST_TIMES = 8192
"""Times that are kept until they are counted."""


Run = Callable[[int], tuple[int, Signal | None, BaseException | None] | None]
"""Given the time; None where every task has had its cycle and nothing came of it, else the place of the task at which
it ended, its signal, and what it raised instead of its cycle."""


class Sweep:
    """Of these tasks in this order: `run` it, and let the times be counted by and by."""

    __slots__ = ("_lap", "_laps", "_tasks", "run")

    def __init__(self, tasks: Sequence[RunningTask], whereabouts: Whereabouts) -> None:
        self._tasks = tuple(tasks)
        self._lap = [0] * (len(tasks) + 1)
        """When the newest cycles began, one after the other, and when the last one ended."""
        self._laps: list[int] = []
        """The same of all whole laps that are not counted yet."""
        source = sweep_source([_member(task) for task in tasks], notes_name=whereabouts.memory is not None)
        space = {name.name: self._thing(name, whereabouts) for name in source.names}
        exec(_compiled(source.text), space)  # noqa: S102 - the text is ours, and names in it have letters only
        self.run: Run = space.pop("sweep")  # else it would hold itself, and with it the memory of the tasks

    @property
    def most_laps(self) -> int:
        """How many laps may be run before the next `count`, and before a module is to be looked at."""
        lacking = [-task.counters.cycles & task.check_mask for task in self._tasks]
        return min(_MOST_TIMES // len(self._lap), *lacking)

    def count(self, stopped: int = 0) -> None:
        """Count the times of all cycles since the last call, with so many of a lap that has stopped behind them."""
        width = len(self._lap)
        if self._laps:
            took = np.diff(np.array(self._laps, dtype=np.int64).reshape(-1, width))
            for task, total, least, most in zip(
                self._tasks, took.sum(0).tolist(), took.min(0).tolist(), took.max(0).tolist(), strict=True
            ):
                task.counters.add_several(len(took), total, least, most)
            self._laps.clear()
        for place in range(stopped):
            self._tasks[place].counters.add(self._lap[place + 1] - self._lap[place])

    def _thing(self, name: SweepName, whereabouts: Whereabouts) -> Any:
        """What a name of the source stands for."""
        if name.member < 0:
            own = {"lap": self._lap, "laps": self._laps, "running": whereabouts, "memory": whereabouts.memory}
            return own[name.meaning] if name.meaning in own else _COMMON[name.meaning]
        task = self._tasks[name.member]
        if name.port < 0:
            return _OF_TASK[name.meaning](task)
        way, _, part = name.meaning.partition(" ")
        ports: Sequence[CycleInput | CycleOutput] = task.binding.cycle_outputs
        if way in ("input", "seen"):
            ports = task.binding.cycle_inputs
        return _OF_PORT[part or way](ports[name.port])


@lru_cache(KEPT_CODE)
def _compiled(text: str) -> CodeType:
    return compile(text, "<sweep>", "exec")


def _member(task: RunningTask) -> SweepMember:
    subsystem, name = task.address

    def port(cycle: CycleInput | CycleOutput) -> SweepPort:
        return SweepPort(subsystem, cycle.svar, cycle.ring.offset, cycle.ring.size)

    return SweepMember(
        subsystem,
        name,
        task.input_guard is not None,
        tuple(map(port, task.binding.cycle_inputs)),
        tuple(map(port, task.binding.cycle_outputs)),
    )


_COMMON: dict[str, Any] = {"ALL": slice(None), "clock": perf_counter_ns, "seal_of": seal_of, "zero": 0}
_OF_TASK: dict[str, Callable[[RunningTask], Any]] = {
    "module": lambda task: task.module,
    "guard": lambda task: task.input_guard,
    "warnings": lambda task: task.warnings,
    "name": lambda task: name_of("/".join(task.address)),
}
_OF_PORT: dict[str, Callable[[Any], Any]] = {
    "input": lambda port: port.data,
    "output": lambda port: port.data,
    "words": lambda port: port.ring.words,
    "slots": lambda port: port.ring.slots,
    "own": lambda port: port.own,
    "seen": lambda _port: [-1],
}
