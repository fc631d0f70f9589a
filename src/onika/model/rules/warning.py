"""Situations worth a warning but never forbidden, Equations (5) and (6) (dissertation §5.3.3)."""

from collections.abc import Sequence

from onika.model.task import Task
from onika.words.fault import Fault, Place


def self_fed(task: Task, place: Place) -> tuple[Fault, ...]:
    """Equation (5): each variable that the task both reads and writes."""
    return tuple(
        Fault(
            place,
            f"variables that `{task.name}` reads or writes",
            f"{svar}, which it does both",
            "it is used as it is",
            is_note=True,
        )
        for svar in sorted(task.inputs & task.outputs)
    )


def hanging(tasks: Sequence[Task], place: Place) -> tuple[Fault, ...]:
    """Equation (6): each variable that some task of a configuration reads and none writes."""
    written = frozenset[str]().union(*(task.outputs for task in tasks))
    readers: dict[str, list[str]] = {}
    for task in tasks:
        for svar in sorted(task.inputs - written):
            readers.setdefault(svar, []).append(f"`{task.name}`")
    return tuple(
        Fault(
            place,
            f"a task that writes {svar}",
            f"only {' and '.join(names)}, reading it",
            "it keeps its last value",
            is_note=True,
        )
        for svar, names in sorted(readers.items())
    )


def further_triggers(tasks: Sequence[Task], place: Place) -> tuple[Fault, ...]:
    """The tasks with a job type behind the first, which alone gives the job its type (requirement C29)."""
    triggers = [task for task in tasks if task.object_type is not None]
    return tuple(
        Fault(
            place,
            "one task that takes the target",
            f"`{task.name}` ({task.object_type}) beside `{triggers[0].name}`",
            f"the job is a {triggers[0].object_type}, by `{triggers[0].name}`",
            is_note=True,
        )
        for task in triggers[1:]
    )
