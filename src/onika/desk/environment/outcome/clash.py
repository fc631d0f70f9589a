"""Tasks that would not fit into open configurations any more if a change of theirs were taken over (reading 9)."""

from collections.abc import Collection, Iterator

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.remedy import coded, reasons
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.rules import placement
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import Objection, Remedy, ShowPin, ShowTask
from onika.words.fault import Refusal
from onika.words.reason import Reason


def clashes(model: Model, after: OpenLibraries, names: Collection[str]) -> tuple[Objection, ...]:
    """Everything that speaks against `after` in the open documents, and did not before; `names` are changed there."""
    found: list[Objection] = []
    for name in sorted(names):
        task = after.tasks.get(name)
        if task is None or task == model.libraries.tasks.get(name):
            continue
        found += reasons(placement.alias_refusals(task, ()), "", task)
        for document in model.documents.values():
            if name in document.content.names:
                configuration = document.content.configuration
                found += beside(name, document, model.libraries.within(configuration), after.within(configuration))
    return tuple(dict.fromkeys(found))


def refused(what: Reason, against: tuple[Objection, ...], field: str = "") -> No:
    """The no to a change that something speaks against."""
    text = Reason.of("desk.several_reasons", reasons=tuple(one.text for one in against))
    remedies = tuple(dict.fromkeys(remedy for one in against for remedy in one.remedies))
    return No(Reason.of("desk.named_wrong", name=what, why=text), remedies, {field: text} if field else {})


def beside(changed: str, document: Document, before: OpenLibraries, after: OpenLibraries) -> Iterator[Objection]:
    """What speaks against a changed task of a document, and did not before."""
    task = after.tasks[changed]
    for name in document.content.names:
        other = after.tasks.get(name)
        if other is None or name == changed:
            continue
        known = _known(before.tasks.get(changed), before.tasks.get(name))
        for refusal in placement.refusals(task, (other,)):
            if refusal.reason not in known:
                reason = Reason.of("run.objection_in", name=document.name, reason=_told(refusal, task))
                yield Objection(reason, _remedies(refusal, other, document))


def _known(task: Task | None, other: Task | None) -> set[Reason]:
    if task is None or other is None:
        return set()
    return {refusal.reason for refusal in placement.refusals(task, (other,))}


def _told(refusal: Refusal, task: Task) -> Reason:
    """Why a task may not stand there, with its name where the rule leaves that to the reader."""
    if refusal.reason.key == "rules.output_written":
        return Reason.of("run.task_speaks", task=task.name, reason=refusal.reason)
    return refusal.reason


def _remedies(refusal: Refusal, other: Task, document: Document) -> tuple[Remedy, ...]:
    """The ways out on the side of the other task: what is wrong with the changed one is being typed just now."""
    svars = [str(way.args["svar"]) for way in refusal.remedies if way.key == "rules.alias"]
    aliases = (
        Remedy(Reason.of("run.alias", svar=svar, task=other.name), show=ShowPin(other.name, coded(other, svar)))
        for svar in svars
    )
    removal = Reason.of("run.remove_from", task=other.name, name=document.name)
    remove = Remedy(removal, act.Remove(document.id, (other.name,)))
    return (remove, *aliases, Remedy(Reason.of("run.show_task", task=other.name), show=ShowTask(other.name)))
