"""What lives in the subsystems of running applications, whoever began them (requirements C14, C27, E11)."""

from collections.abc import Iterable, Iterator, Mapping
from typing import cast

from msgspec import structs

from onika.wire import event
from onika.wire.plan import PlannedTask
from onika.wire.runtime_standing import Standing, SubsystemStanding, TaskStanding
from onika.wire.view import LivingTaskView, RuntimeView, SharedVariableView, State, SubsystemView
from onika.words.name import resolve
from onika.words.reason import NOTHING

_KILLED = "KILLED"
_FAILED = "ERROR"
_BORN = "OFF"


def surveyed(former: Mapping[str, SubsystemView], standing: Standing) -> dict[str, SubsystemView]:
    """As it stands; why a task has failed was told before, and still counts."""
    return {
        subsystem.name: _surveyed(former.get(subsystem.name), subsystem)
        for subsystem in standing.subsystems
        if subsystem.application
    }


def turned(runtime: RuntimeView, message: event.TaskState) -> RuntimeView:
    """A task has come into another state; the same runtime where nothing is known of it."""
    task = _task(runtime, message.subsystem, message.task)
    if task is None or task.state == message.state:
        return runtime
    if message.state == _KILLED:
        return _with(runtime, message.subsystem, message.task, None)
    note = task.note if message.state == _FAILED else NOTHING
    task = structs.replace(task, state=cast("State", message.state), note=note)
    return _with(runtime, message.subsystem, message.task, task)


def failed(runtime: RuntimeView, message: event.Failed) -> RuntimeView:
    """A task has failed; the same runtime where nothing is known of it."""
    task = _task(runtime, message.subsystem, message.task)
    if task is None:
        return runtime
    return _with(runtime, message.subsystem, message.task, structs.replace(task, note=message.text))


def is_born(runtime: RuntimeView, message: event.TaskState) -> bool:
    """Whether a task has come to life for an application since the runtime was asked what there is."""
    subsystem = runtime.inside.get(message.subsystem)
    return subsystem is not None and message.state == _BORN and message.task not in subsystem.tasks


def planned(application: str, tasks: Iterable[PlannedTask]) -> SubsystemView:
    """What is to live for a flow of an application; nothing has a state yet."""
    planned_tasks = tuple(tasks)
    views = {task.name: LivingTaskView("", rtpu=task.rtpu, hz=task.frequency or 0.0) for task in planned_tasks}
    return SubsystemView(application, views, _variables(planned_tasks))


def _surveyed(former: SubsystemView | None, subsystem: SubsystemStanding) -> SubsystemView:
    before = former.tasks if former is not None else {}
    living = [task for task in subsystem.tasks if task.state != _KILLED]
    views = {task.task.name: _living(task, before.get(task.task.name)) for task in living}
    return SubsystemView(subsystem.application, views, _variables(tuple(task.task for task in living)))


def _living(standing: TaskStanding, former: LivingTaskView | None) -> LivingTaskView:
    note = standing.reason
    if not note and former is not None and standing.state == _FAILED:
        note = former.note
    return LivingTaskView(cast("State", standing.state), note, standing.rtpu, standing.frequency or 0.0)


def _variables(tasks: tuple[PlannedTask, ...]) -> dict[str, SharedVariableView]:
    """The variables of some tasks, each with those that write and read it, in the order of their names."""
    writers: dict[str, list[str]] = {}
    readers: dict[str, list[str]] = {}
    at_cycle: set[str] = set()
    for task in tasks:
        for name in _named(task, task.outconst, task.outvar):
            writers.setdefault(name, []).append(task.name)
        for name in _named(task, task.inconst, task.invar):
            readers.setdefault(name, []).append(task.name)
        at_cycle.update(_named(task, task.invar, task.outvar))
    return {
        name: SharedVariableView(name not in at_cycle, tuple(writers.get(name, ())), tuple(readers.get(name, ())))
        for name in sorted({*writers, *readers})
    }


def _named(task: PlannedTask, *ports: tuple[str, ...]) -> Iterator[str]:
    """The variables behind some ports of a task, each once."""
    coded = dict.fromkeys(name for names in ports for name in names)
    yield from dict.fromkeys(resolve(coded, dict(task.aliases)))


def _task(runtime: RuntimeView, subsystem: str, name: str) -> LivingTaskView | None:
    home = runtime.inside.get(subsystem)
    return home.tasks.get(name) if home is not None else None


def _with(runtime: RuntimeView, subsystem: str, name: str, task: LivingTaskView | None) -> RuntimeView:
    """With another task in its place; None: it is gone."""
    home = runtime.inside[subsystem]
    if task is None:
        tasks = {other: view for other, view in home.tasks.items() if other != name}
    else:
        tasks = {**home.tasks, name: task}
    return structs.replace(runtime, inside={**runtime.inside, subsystem: structs.replace(home, tasks=tasks)})
