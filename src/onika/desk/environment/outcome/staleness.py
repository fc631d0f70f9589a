"""Living tasks whose files say something else by now: told as long as it is so, with a way to take it over (law 21)."""

from collections.abc import Iterator, Mapping

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import TaskFacts
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.planned import task_of
from onika.model.rules.worlds import worlds_of
from onika.model.task import Task
from onika.wire import act
from onika.wire.plan import PlannedTask
from onika.wire.view import ProblemView, Remedy, RuntimeView, ShowSource, ShowTask
from onika.words.reason import NOTHING, Reason


def stale(document: Document, libraries: OpenLibraries, runtime: RuntimeView) -> dict[str, ProblemView]:
    """What is to be told of a document; nothing while a change is under way."""
    live = document.live
    if live is None or live.state != "live" or live.pending:
        return {}
    return {**dict(_stale(document, live.tasks, libraries)), **dict(_outdated_worlds(live.tasks, runtime))}


def says_otherwise(planned: PlannedTask, task: Task) -> bool:
    """Whether the file of a task describes another one than lives; its rate is of the configuration."""
    return _lines(task_of(planned)) != _lines(task)


def _stale(
    document: Document, tasks: Mapping[str, TaskFacts], libraries: OpenLibraries
) -> Iterator[tuple[str, ProblemView]]:
    for name in document.content.names:
        facts, task = tasks.get(name), libraries.tasks.get(name)
        if facts is None or facts.planned is None or task is None:
            continue
        reason = _reason(name, facts.planned, task, libraries)
        if reason:
            take = Remedy(Reason.of("run.take_file_over"), act.Renew(document.id, name))
            look = Remedy(Reason.of("run.source"), show=ShowSource(name))
            yield f"stale {name}", ProblemView(reason, "warning", ShowTask(name), (take, look))


def _outdated_worlds(tasks: Mapping[str, TaskFacts], runtime: RuntimeView) -> Iterator[tuple[str, ProblemView]]:
    """Open worlds of which a task drives a device; only the runtime that was started here is started anew from here."""
    remedies = () if runtime.address else (Remedy(Reason.of("run.start_runtime_anew"), act.StartAnew()),)
    for world, reason in runtime.outdated.items():
        driving = next((name for name, facts in tasks.items() if _drives(facts.planned, world)), None)
        if driving is not None:
            yield f"stale world {world}", ProblemView(reason, "warning", ShowTask(driving), remedies)


def _drives(planned: PlannedTask | None, world: str) -> bool:
    return planned is not None and world in worlds_of([task_of(planned)])


def _reason(name: str, planned: PlannedTask, task: Task, libraries: OpenLibraries) -> Reason:
    if says_otherwise(planned, task):
        return Reason.of("run.lives_as_filed_before", task=name, path=str(libraries.task_file(name)))
    digest = libraries.digests.get(task.module, planned.digest)
    is_from_files = planned.digest != ""  # else the runtime has code of its own for it
    if not is_from_files or digest == planned.digest or not _is_described_by(name, task.module, libraries):
        return NOTHING
    return Reason.of("run.lives_with_older_code", task=name, path=str(libraries.code_file(name)))


def _is_described_by(name: str, module: str, libraries: OpenLibraries) -> bool:
    """Whether the code that is known of a module is that of this task: several libraries may have one of its name."""
    first = next((other for other, task in libraries.tasks.items() if task.module == module), name)
    return libraries.code_file(first) == libraries.code_file(name)


def _lines(task: Task) -> tuple[object, ...]:
    ports = (task.inconst, task.outconst, task.invar, task.outvar)
    return task.module, task.type, dict(task.aliases), ports, task.local
