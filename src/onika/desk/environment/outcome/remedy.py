"""The words of a rule's remedies as buttons that do what they say (requirement X01)."""

import re
from collections.abc import Iterable, Sequence

from onika.model.task import Task
from onika.wire import act
from onika.wire.view import Objection, Remedy, ShowPin, ShowTask
from onika.words.fault import Fault, Refusal
from onika.words.reason import Reason, Text

_NAMED = re.compile(r"(replace|show|alias) `?([^`]+)`?\Z")
_TOLD = 4
"""Faults of a file that are told in a refusal; `onika check` lists all."""
_OTHER = re.compile(r"give ([^ ]+) another alias\Z")


def reasons(refused: Iterable[Refusal], doc: str, task: Task) -> tuple[Objection, ...]:
    """Why `task` may not be placed in a document."""
    return tuple(
        Objection(plain(one.reason), tuple(_remedy(word, doc, task) for word in one.remedies)) for one in refused
    )


def plain(text: Text) -> str:
    """A sentence without the marks that terminals show names with."""
    return str(text).replace("`", "")


def unreadable(file: str, faults: Sequence[Fault]) -> str:
    """Why nothing of a file can be opened, in a few sentences even where every line of it is wrong."""
    told = "; ".join(plain(str(one)) for one in faults[:_TOLD])
    more = f"; and {len(faults) - _TOLD} more, see onika check" if len(faults) > _TOLD else ""
    return f"{file} cannot be opened: {told}{more}"


def overwriting(refused: Refusal, again: act.AnyAct, label: Text = "") -> tuple[Remedy, ...]:
    """The button that saves all the same; none where that would be refused too, as on a full disk."""
    match refused.remedies:
        case ("save it elsewhere",):
            return ()
        case ("save it all the same", *_):
            return (Remedy(Reason.of("desk.save_all_the_same"), again),)
    return (Remedy(label or Reason.of("desk.overwrite_it"), again),)


def _remedy(words: str, doc: str, task: Task) -> Remedy:
    named = _NAMED.match(words)
    if other := _OTHER.match(words):
        return Remedy(f"Alias {other[1]}…", show=ShowPin(task.name, other[1]))
    if named is None:
        text = plain(words)
        return Remedy(text[:1].upper() + text[1:])
    kind, name = named.groups()
    match kind:
        case "replace":
            return Remedy(f"Replace {name}", act.Exchange(doc, name, task.name))
        case "alias":
            return Remedy(f"Alias {name}…", show=ShowPin(task.name, coded(task, name)))
    return Remedy(f"Show {name}", show=ShowTask(name))


def coded(task: Task, svar: str) -> str:
    """The coded name behind which a task has a state variable."""
    names = tuple(task.kinds())
    return next((name for name, one in zip(names, task.svars(names), strict=True) if one == svar), svar)
