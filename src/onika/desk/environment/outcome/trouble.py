"""What is wrong with a document and its tasks, in words, with the ways out."""

from collections.abc import Mapping, Sequence
from functools import lru_cache

from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import TaskFacts
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.rules import conflict, warning
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import (
    ErrorView,
    Objection,
    ProblemView,
    Remedy,
    ShowLibraries,
    ShowLocus,
    ShowPin,
    ShowSource,
    ShowTask,
)
from onika.words.fault import Fault, Place, Refusal
from onika.words.reason import Reason


def error_view(document: Document, name: str, facts: TaskFacts) -> ErrorView | None:
    """Why a task is in ERROR, and the ways out of it."""
    if facts.state != "ERROR":
        return None
    remedies = (
        Remedy(Reason.of("run.clear_switch_on"), act.Clear(document.id, name, turns_on=True)),
        Remedy(Reason.of("run.clear"), act.Clear(document.id, name)),
        Remedy(Reason.of("run.source"), show=ShowSource(name)),
        Remedy(Reason.of("run.remove_failed"), act.Remove(document.id, (name,))),
    )
    failed = facts.failed
    if failed is None:
        return ErrorView(facts.note or Reason.of("run.task_failed_unsaid"), remedies=remedies)
    return ErrorView(
        text=_without_entry(failed.text),
        entry=failed.entry,
        path=failed.path,
        line=failed.line,
        traceback=failed.traceback,
        at_s=failed.at_s,
        values=failed.values,
        remedies=remedies,
    )


def _without_entry(text: Reason) -> Reason:
    """What a task failed by; in which of its entry points is told beside it."""
    if text.key != "host.entry_failed":
        return text
    why = text.args["why"]
    return why if isinstance(why, Reason) else Reason.plain(str(why))


def problems(
    document: Document,
    libraries: OpenLibraries,
    *,
    with_warnings: bool = True,
    greyed: Mapping[str, tuple[Objection, ...]] | None = None,
) -> dict[str, ProblemView]:
    """Everything worth knowing of a document, by keys that stay: faults, then warnings and notes where wanted.

    `greyed`: its greyed set, where that is known. A placed task with no other reason in it than that it is placed
    has no conflict, so only few need be asked.
    """
    place = Place(document.name)
    names = document.content.names
    tasks = [libraries.tasks[name] for name in names if name in libraries.tasks]
    suspects = tasks if greyed is None else [task for task in tasks if len(greyed.get(task.name, ())) > 1]
    found = {f"missing {name}": _missing(document, name) for name in names if name not in libraries.tasks}
    found |= {
        f"conflict {later.name} {earlier.name}": _conflict(document, later, earlier, refused)
        for later, earlier, refused in conflict.conflicts(suspects)
    }
    if with_warnings:
        return found | _warnings(tasks, place)
    return found


def _warnings(tasks: Sequence[Task], place: Place) -> dict[str, ProblemView]:
    """What is odd and never forbidden: hanging inputs, further triggers, tasks that read what they write (C08, C29)."""
    found = {}
    for one in warning.hanging(tasks, place):
        svar = str(one.reason.args["svar"])
        found[f"hanging {svar}"] = ProblemView(said(one), "warning", ShowLocus(svar))
    for one in warning.further_triggers(tasks, place):
        name = str(one.reason.args["task"])
        found[f"trigger {name}"] = ProblemView(said(one), "warning", ShowTask(name))
    for task in tasks:
        for one in warning.self_fed(task, place):
            svar = str(one.reason.args["svar"])
            found[f"fed {task.name} {svar}"] = ProblemView(said(one), "note", ShowTask(task.name))
    return found


def _missing(document: Document, name: str) -> ProblemView:
    remedies = (
        Remedy(Reason.of("run.open_library"), show=ShowLibraries()),
        Remedy(Reason.of("run.remove", task=name), act.Remove(document.id, (name,))),
    )
    return ProblemView(Reason.of("run.no_task_open", name=name), "fault", ShowTask(name), remedies)


def _conflict(document: Document, later: Task, earlier: Task, refused: Sequence[Refusal]) -> ProblemView:
    """Two tasks that may not stand together; one of them goes, or a pin gets another variable."""
    found = reasons(refused, document.id, later)
    removing = [
        Remedy(Reason.of("run.remove", task=task.name), act.Remove(document.id, (task.name,)))
        for task in (later, earlier)
    ]
    aliasing = [remedy for objection in found for remedy in objection.remedies if isinstance(remedy.show, ShowPin)]
    why = Reason.of("run.together", parts=tuple(objection.text for objection in found))
    reason = Reason.of("run.what_why", what=later.name, why=why)
    return ProblemView(reason, "fault", ShowTask(later.name), tuple(dict.fromkeys((*removing, *aliasing))))


def said(fault: Fault) -> Reason:
    """A fault as a sentence without its place."""
    return _with_what_follows(fault.reason, fault.instead)


@lru_cache(maxsize=4096)
def _with_what_follows(reason: Reason, instead: Reason) -> Reason:
    return Reason.of("run.fault_instead", reason=reason, instead=instead)
