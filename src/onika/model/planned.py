"""Restores the task that a plan describes, without what only the canvas needs."""

from onika.model.task import LocalLine, Task, TaskType
from onika.wire.plan import PlannedTask


def task_of(planned: PlannedTask) -> Task:
    """The task as its file describes it; raises ValueError for a type of task that there is not."""
    return Task(
        name=planned.name,
        module=planned.module,
        aliases=planned.aliases,
        inconst=planned.inconst,
        outconst=planned.outconst,
        invar=planned.invar,
        outvar=planned.outvar,
        type=TaskType(planned.type),
        frequency=planned.frequency,
        local=tuple(LocalLine(key, words) for key, words in planned.local),
    )
