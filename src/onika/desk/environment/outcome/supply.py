"""Tasks that are ON and read what nobody writes now, or what comes too rarely: why a robot moves wrongly (C09)."""

from collections.abc import Callable, Iterable, Iterator, Mapping

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import TaskFacts
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import ProblemView, Remedy, ShowLocus, ShowTask
from onika.words.reason import Reason

RARELY = 10.0
"""So many cycles of a reader between two values of its writer are told; tasks that are shipped have five at most."""

_AT_REST = ("OFF", "ERROR")


def supply(document: Document, libraries: OpenLibraries) -> dict[str, ProblemView]:
    """What is to be told of a document; nothing while a change is under way."""
    live = document.live
    if live is None or live.state != "live" or live.pending:
        return {}
    tasks = {name: task for name in document.content.names if (task := libraries.tasks.get(name)) is not None}
    living = {name: task for name, task in tasks.items() if name in live.tasks}
    moving = {name: task for name, task in living.items() if live.tasks[name].state == "ON"}
    return {
        **dict(_silent(document, living, moving, live.tasks)),
        **dict(_rare(moving, live.tasks)),
    }


def _silent(
    document: Document, living: Mapping[str, Task], moving: Mapping[str, Task], facts: Mapping[str, TaskFacts]
) -> Iterator[tuple[str, ProblemView]]:
    """Variables whose every writer lives here and rests, while somebody reads them in every cycle."""
    written = _by_variable(living, _written)
    for svar, readers in _by_variable(moving, _read).items():
        writers = written.get(svar, ())
        if writers and all(facts[name].state in _AT_REST for name in writers):
            reason = Reason.of("run.nobody_writes_now", svar=svar, readers=readers, writers=writers)
            remedies = () if document.watched else tuple(_awakened(document, writers, facts))
            yield f"silent {svar}", ProblemView(reason, "warning", ShowLocus(svar), remedies)


def _awakened(document: Document, writers: tuple[str, ...], facts: Mapping[str, TaskFacts]) -> Iterator[Remedy]:
    for name in writers:
        if facts[name].state == "ERROR":
            yield Remedy(Reason.of("run.clear_switch_on"), act.Clear(document.id, name, turns_on=True))
        else:
            yield Remedy(Reason.of("desk.turn_on_tasks", names=(name,)), act.Turn(document.id, (name,), True))


def _rare(moving: Mapping[str, Task], facts: Mapping[str, TaskFacts]) -> Iterator[tuple[str, ProblemView]]:
    """Writers that are much slower than who reads them."""
    readers = _by_variable(moving, _read)
    for svar, writers in _by_variable(moving, _written).items():
        slow = _rate(moving, facts, writers[0])
        fast, reader = max(((_rate(moving, facts, name), name) for name in readers.get(svar, ())), default=(0.0, ""))
        if slow and fast >= RARELY * slow:
            figures = {"slow": slow, "fast": fast}
            reason = Reason.of("run.written_rarely", svar=svar, writer=writers[0], reader=reader, **figures)
            yield f"rare {svar}", ProblemView(reason, "warning", ShowTask(writers[0]))


def _rate(tasks: Mapping[str, Task], facts: Mapping[str, TaskFacts], name: str) -> float:
    """Cycles in a second; 0 of a task without a rate."""
    return facts[name].hz or tasks[name].frequency or 0.0


def _read(task: Task) -> Iterable[str]:
    return task.svars(task.invar)


def _written(task: Task) -> Iterable[str]:
    return task.svars(task.outvar)


def _by_variable(tasks: Mapping[str, Task], used: Callable[[Task], Iterable[str]]) -> dict[str, tuple[str, ...]]:
    """Of each variable the tasks that use it."""
    users: dict[str, tuple[str, ...]] = {}
    for name, task in tasks.items():
        for svar in used(task):
            users[svar] = (*users.get(svar, ()), name)
    return users
