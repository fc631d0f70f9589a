"""Connecting a configuration with what already runs, Equation (1) with (4) (dissertation §5.3.2, R-C12, R-E10).

What runs wins: a placed task that conflicts with a running one of another name leaves the canvas; running tasks that
are not placed come onto it; placed ones that do not run are spawned; of those on both sides the running one's values
count.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from onika.model.configuration import Placed
from onika.model.rules import placement
from onika.model.task import Task
from onika.words.fault import Refusal


@dataclass(frozen=True, slots=True)
class Merge:
    """What connecting does, each part in the order of its side."""

    remove: Mapping[str, tuple[Refusal, ...]]
    """T_o ∩ S: placed tasks that leave the canvas, each with every reason."""
    add: tuple[Placed, ...]
    """T_r − T_o: running tasks that come onto the canvas, at no place yet."""
    spawn: tuple[Placed, ...]
    """T_o − T_r − S: placed tasks that are brought to life."""
    update: tuple[Placed, ...]
    """T_o ∩ T_r: placed tasks as they are from now on, with the rate and the unit of the running one."""

    @property
    def placed(self) -> tuple[Placed, ...]:
        """Everything that stands on the canvas afterwards: what was placed, then what was added."""
        return (*self.update, *self.spawn, *self.add)


def merge(placed: Sequence[Placed], running: Sequence[Placed], tasks: Mapping[str, Task]) -> Merge:
    """Merge what is placed with what runs; `tasks` are those of both, by name.

    A placed task whose description is missing is left as it is and not spawned: the configuration's own faults tell it.
    """
    alive = {placed.task: placed for placed in running}
    conflicting = _conflicting(placed, alive, tasks)
    update = tuple(_updated(placed, alive[placed.task]) for placed in placed if placed.task in alive)
    here = {placed.task for placed in placed}
    free = (placed for placed in placed if placed.task not in alive and placed.task not in conflicting)
    return Merge(
        remove=conflicting,
        add=tuple(placed for placed in running if placed.task not in here),
        spawn=tuple(placed for placed in free if placed.task in tasks),
        update=update,
    )


def _conflicting(
    placed: Iterable[Placed], alive: Mapping[str, Placed], tasks: Mapping[str, Task]
) -> dict[str, tuple[Refusal, ...]]:
    """S of Equation (4): placed tasks that may not stand beside a running task of another name (reading 3)."""
    others = [tasks[name] for name in alive if name in tasks]
    refusals = {
        placed.task: placement.refusals(tasks[placed.task], [other for other in others if other.name != placed.task])
        for placed in placed
        if placed.task in tasks and placed.task not in alive
    }
    return {name: reasons for name, reasons in refusals.items() if reasons}


def _updated(placed: Placed, running: Placed) -> Placed:
    """The running task's values win (reading 4); its icon stays where it is."""
    return replace(placed, frequency=running.frequency, rtpu=running.rtpu, own=running.own, rmod=running.rmod)
