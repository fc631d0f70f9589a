"""The forecast: whether a unit has the time for what is to come ON, from what cycles have taken so far (X13)."""

from collections.abc import Iterable
from dataclasses import dataclass

from msgspec import structs

from onika.runtime.load import TaskLoad, predict
from onika.words.reason import Reason

_ENOUGH_CYCLES = 10
"""Fewer say nothing: the first cycles of a module are its slowest."""


@dataclass(frozen=True, slots=True)
class ComingTask:
    """A task that is to come ON, or to change its rate in hertz; `digest` names its code."""

    rtpu: str
    subsystem: str
    task: str
    digest: str
    hz: float


class LoadForecast:
    """Knows the newest loads of all units, and what each module's cycle took wherever it ran."""

    def __init__(self) -> None:
        self._units: dict[str, dict[tuple[str, str], TaskLoad]] = {}
        self._cycles_us: dict[str, float] = {}

    def hear(self, rtpu: str, tasks: Iterable[tuple[TaskLoad, str]]) -> None:
        """The loads of one unit's tasks, each with the digest of its code."""
        loads = self._units[rtpu] = {}
        for load, digest in tasks:
            loads[load.subsystem, load.task] = load
            if load.cycles >= _ENOUGH_CYCLES:
                self._cycles_us[digest] = load.mean_us

    @property
    def cycles_us(self) -> dict[str, float]:
        """The mean time of a cycle by the digest of the code, of what was measured long enough."""
        return dict(self._cycles_us)

    def warnings(
        self, off: Iterable[tuple[str, str]], coming: Iterable[ComingTask]
    ) -> list[tuple[ComingTask, float, Reason]]:
        """Who would take a unit beyond its margin, to what use, and the sentence; what was never measured is free."""
        units = {rtpu: dict(tasks) for rtpu, tasks in self._units.items()}
        for address in off:
            for tasks in units.values():
                tasks.pop(address, None)
        forecasts = []
        for newcomer in coming:
            tasks = units.setdefault(newcomer.rtpu, {})
            took = self._cycles_us.get(newcomer.digest, 0.0)
            load = TaskLoad(newcomer.subsystem, newcomer.task, True, newcomer.hz, took, took)
            prediction = predict(newcomer.rtpu, tasks.values(), load)
            tasks[newcomer.subsystem, newcomer.task] = structs.replace(load, is_on=True)
            if prediction.warning and took:
                forecasts.append((newcomer, prediction.use, prediction.warning))
        return forecasts
