"""The tasks that live together while a flow runs and what conflicts among them (dissertation §5.3.4, §5.9.2)."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from onika.model.configuration import Configuration
from onika.model.rules import placement
from onika.model.task import Task
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason

DEVICE = "DEVICE"
"""The LOCAL parameter whose first word is the device a hardware task claims."""


_Both = tuple[str, Task, Task]


class TaskOrigin(NamedTuple):
    """The icon that brings a task into a flow: its line, its configuration, its position, and of which flow."""

    place: Place
    configuration: str
    position: int
    flow: Reason | None
    """Its name, where that is not clear from what the texts say else."""


def tasks_of(configurations: Iterable[Configuration], tasks: Mapping[str, Task]) -> tuple[Task, ...]:
    """The tasks placed in some configurations, each once, in the order of their files; missing ones are left out."""
    names = dict.fromkeys(placed.task for configuration in configurations for placed in configuration.placed)
    return tuple(tasks[name] for name in names if name in tasks)


def conflicts(
    tasks: Sequence[Task], where: Reason, place: Place, sources: Mapping[str, TaskOrigin] | None = None
) -> tuple[Fault, ...]:
    """What may not live side by side in one subsystem, though never ON together; `where` names the flow.

    One module twice, a device claimed twice, a constant supplied twice, a pure OUTVAR against a pure INCONST
    (reading 1: sharing an OUTVAR is legal), and a constant that nobody supplies (laws 9 and 10). Each is told of every
    later task beside the first. A fault stands at the icon that brings the later task, as far as `sources` knows it.
    """
    origins = sources or {}

    def named(*both: Task) -> tuple[Reason, ...]:
        return tuple(_shown(task, origins.get(task.name)) for task in both)

    def fault(last: Task, reason: Reason) -> Fault:
        source = origins.get(last.name)
        return Fault(source.place if source else place, reason, NOT_RUN)

    faults = []
    for module, *both in _twice(tasks, _module):
        faults.append(fault(both[-1], Reason.of("rules.module_twice", module=module, tasks=named(*both), flow=where)))
    for device, *both in _twice(tasks, devices):
        faults.append(fault(both[-1], Reason.of("rules.device_twice", device=device, tasks=named(*both), flow=where)))
    for svar, *both in _twice(tasks, _given):
        reason = Reason.of("rules.constant_twice", constants=(svar,), tasks=named(*both), flow=where)
        faults.append(fault(both[-1], reason))
    for svar, *both in _late(tasks):
        faults.append(fault(both[-1], Reason.of("rules.constant_late", constant=svar, tasks=named(*both), flow=where)))
    for svar, task in _unsupplied(tasks):
        faults.append(fault(task, Reason.of("rules.constant_missing", constant=svar, tasks=named(task), flow=where)))
    return tuple(faults)


def variables(tasks: Iterable[Task]) -> frozenset[str]:
    """Every state variable that one of the tasks reads or writes."""
    return frozenset[str]().union(*(task.inputs | task.outputs for task in tasks))


def _shown(task: Task, source: TaskOrigin | None) -> Reason:
    if source is None:
        return Reason.of("rules.icon", name=task.name)
    configuration, position = source.configuration, source.position
    if source.flow is None:
        return Reason.of("rules.task_in", name=task.name, configuration=configuration, position=position)
    return Reason.of(
        "rules.task_in_flow", name=task.name, configuration=configuration, position=position, flow=source.flow
    )


def _twice(tasks: Sequence[Task], keys: Callable[[Task], Iterable[str]]) -> Iterator[_Both]:
    """What several tasks have: each later one with the first."""
    first: dict[str, Task] = {}
    for task in tasks:
        for key in sorted(keys(task)):
            if first.setdefault(key, task) is not task:
                yield key, first[key], task


def _module(task: Task) -> Iterable[str]:
    return (task.module,)


def devices(task: Task) -> Iterable[str]:
    """The devices that a task claims."""
    return {line.words[0] for line in task.local if line.key == DEVICE and line.words}


def _given(task: Task) -> Iterable[str]:
    return frozenset(task.svars(task.outconst))


def _late(tasks: Sequence[Task]) -> Iterator[_Both]:
    """Equation (3): variables that one task gives only while it runs and another one needs at initialisation."""
    readers: dict[str, list[Task]] = {}
    for task in tasks:
        for svar in placement.needed_at_start(task):
            readers.setdefault(svar, []).append(task)
    for writer in tasks:
        for svar in sorted(placement.given_while_running(writer) & readers.keys()):
            for reader in readers[svar]:
                if reader is not writer:
                    yield svar, writer, reader


def _unsupplied(tasks: Sequence[Task]) -> Iterator[tuple[str, Task]]:
    given = {svar for task in tasks for svar in _given(task)}
    for task in tasks:
        for svar in sorted(placement.needed_at_start(task) - given):
            yield svar, task
