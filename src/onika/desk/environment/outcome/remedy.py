"""A rule's remedies as buttons that do what they say (requirement X01)."""

from collections.abc import Iterable, Sequence

from onika.model.task import Task
from onika.wire import act
from onika.wire.view import Objection, Remedy, ShowPin, ShowTask
from onika.words.fault import Fault, Refusal
from onika.words.reason import Reason

_MOST = 4
"""Faults of a file that are told in a refusal; `onika check` lists all."""


def reasons(refused: Iterable[Refusal], doc: str, task: Task) -> tuple[Objection, ...]:
    """Why `task` may not be placed in a document."""
    return tuple(
        Objection(refusal.reason, tuple(_remedy(way, doc, task) for way in refusal.remedies)) for refusal in refused
    )


def unreadable(file: str, faults: Sequence[Fault]) -> Reason:
    """Why nothing of a file can be opened, in a few sentences even where every line of it is wrong."""
    sentences = tuple(fault.sentence for fault in faults[:_MOST])
    more = len(faults) - len(sentences)
    if more:
        return Reason.of("run.cannot_be_opened_more", file=file, faults=sentences, count=more)
    return Reason.of("run.cannot_be_opened", file=file, faults=sentences)


def overwriting(refused: Refusal, again: act.AnyAct, label: Reason | None = None) -> tuple[Remedy, ...]:
    """The button that saves all the same; none where that would be refused too, as on a full disk."""
    match [way.key for way in refused.remedies]:
        case ["files.save_elsewhere"]:
            return ()
        case ["files.save_all_the_same", *_]:
            return (Remedy(Reason.of("desk.save_all_the_same"), again),)
    return (Remedy(label or Reason.of("desk.overwrite_it"), again),)


def _remedy(way: Reason, doc: str, task: Task) -> Remedy:
    """The button of a way out, by what the rule says could be done; one without an act is only told."""
    match way.key:
        case "rules.replace":
            other = str(way.args["task"])
            return Remedy(Reason.of("run.replace_task", task=other), act.Exchange(doc, other, task.name))
        case "rules.show":
            other = str(way.args["task"])
            return Remedy(Reason.of("run.show_task", task=other), show=ShowTask(other))
        case "rules.alias":
            svar = str(way.args["svar"])
            return Remedy(Reason.of("run.alias_variable", svar=svar), show=ShowPin(task.name, coded(task, svar)))
        case "rules.alias_anew":
            pin = str(way.args["pin"])
            return Remedy(Reason.of("run.alias_variable", svar=pin), show=ShowPin(task.name, pin))
    return Remedy(way)


def coded(task: Task, svar: str) -> str:
    """The coded name behind which a task has a state variable."""
    names = tuple(task.kinds())
    return next((name for name, other in zip(names, task.svars(names), strict=True) if other == svar), svar)
