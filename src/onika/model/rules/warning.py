"""Situations worth a warning but never forbidden, Equations (5) and (6) (dissertation §5.3.3)."""

from collections.abc import Sequence
from functools import lru_cache

from onika.model import pad
from onika.model.task import Task
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

USED_AS_IT_IS = Reason.of("rules.used_as_it_is")
"""What happens with a task that reads what it writes."""

KEEPS_LAST_VALUE = Reason.of("rules.keeps_last_value")
"""What happens with a variable that nobody writes."""


def self_fed(task: Task, place: Place) -> tuple[Fault, ...]:
    """Equation (5): each variable that the task both reads and writes."""
    return tuple(
        Fault(
            place,
            _reads_and_writes(task.name, svar),
            USED_AS_IT_IS,
            is_note=True,
        )
        for svar in sorted(task.inputs & task.outputs)
    )


def hanging(tasks: Sequence[Task], place: Place) -> tuple[Fault, ...]:
    """Equation (6): each variable that some task of a configuration reads and none writes; people push pads."""
    written = frozenset((pad.NAME,)).union(*(task.outputs for task in tasks))
    readers: dict[str, list[Reason]] = {}
    for task in tasks:
        for svar in sorted(task.inputs - written):
            readers.setdefault(svar, []).append(Reason.of("rules.icon", name=task.name))
    return tuple(
        Fault(
            place,
            Reason.of("rules.hanging", svar=svar, tasks=tuple(names)),
            KEEPS_LAST_VALUE,
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
            Reason.of("rules.further_trigger", task=task.name, kind=task.object_type or "", first=triggers[0].name),
            Reason.of("rules.kind_by", kind=triggers[0].object_type or "", first=triggers[0].name),
            is_note=True,
        )
        for task in triggers[1:]
    )


@lru_cache(maxsize=4096)  # a canvas says it of the same tasks after every act
def _reads_and_writes(task: str, svar: str) -> Reason:
    return Reason.of("rules.self_fed", task=task, svar=svar)
