"""Copy, cut and paste: what is placed comes all or not at all (requirements C10, C22)."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from onika.desk.environment.canvas.placement import absent, inside, remove, several
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.other_tasks import with_other_tasks
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.clipboard import Clipboard, copied, read, write
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import Configuration, Group, Placed
from onika.model.rules import conflict, loci
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import Objection, Remedy, ShowLibraries, ShowTask
from onika.words.fault import Refusal
from onika.words.reason import Reason

_NAMED_FIRST = {"rules.task_placed": "task", "rules.constant_while_running": "reader"}
"""Of reasons that begin with the name of a task, the argument that is this name."""


@on_document
def copy(model: Model, document: Document, command: act.Copy, _outside: Services) -> Done | No:
    """Take tasks into the clipboard; the value is their text."""
    refused = _nothing(command.tasks) or absent(document, command.tasks)
    if refused:
        return refused
    boxes = model.libraries_of(document).boxes(command.tasks).values()
    svars = (pin.svar for box in boxes for pin in box.pins)
    taken = copied(document.content.configuration, command.tasks, svars)
    return Done(replace(model, clipboard=taken), value=write(taken))


def cut(model: Model, command: act.Cut, outside: Services) -> Done | No:
    """Take tasks into the clipboard and remove them, as one step."""
    taken = copy(model, act.Copy(command.doc, command.tasks), outside)
    if isinstance(taken, No):
        return taken
    done = remove(taken.model, act.Remove(command.doc, command.tasks), outside)
    if isinstance(done, No):
        return done
    return replace(done, label=Reason.of("desk.cutting", icons=several(command.tasks)), value=taken.value)


@on_document
def paste(model: Model, document: Document, command: act.Paste, _outside: Services) -> Done | No:
    """Place what is in the clipboard or in a text, as one step; the value is the names of the tasks."""
    taken = read(command.text) if command.text else model.clipboard
    if isinstance(taken, Reason):
        return No(taken)
    if not taken.placed:
        return No(Reason.of("desk.nothing_copied"))
    against = objections(model, document, taken)
    if against:
        return refusal(Reason.of("desk.nothing_pasted_plain"), against)
    names = tuple(placed.task for placed in taken.placed)
    return placed(
        model, document, taken.at(*inside(command.x, command.y)), Reason.of("desk.pasting", icons=several(names))
    )


def placed(model: Model, document: Document, taken: Clipboard, label: Reason) -> Done:
    """The tasks on the canvas, and with them their supermodules and the loci that were not there before."""
    names = tuple(placed.task for placed in taken.placed)
    configuration = document.content.configuration
    svars = {locus.svar for locus in configuration.loci}
    new = tuple(_inside(placed) for placed in taken.placed)
    groups = (*configuration.groups, *_renamed(taken.groups, configuration.groups))
    both = replace(configuration, placed=(*configuration.placed, *new), groups=groups)
    done = with_other_tasks(model, document, both, label)
    after = done.model.documents[document.id]
    spots = {locus.svar: locus for locus in taken.loci if locus.svar not in svars}
    boxes = done.model.libraries_of(after).boxes(after.content.names)
    kept = replace(after.content, configuration=loci.wished(after.content.configuration, spots, boxes))
    return replace(done, model=done.model.with_document(after.having(kept)), value=names)


def _inside(placed: Placed) -> Placed:
    x, y = inside(placed.x, placed.y)
    return replace(placed, x=x, y=y)


def _nothing(names: Iterable[str]) -> No | None:
    if tuple(names):
        return None
    return No(Reason.of("desk.nothing_selected"))


def _renamed(groups: Iterable[Group], standing: Iterable[Group]) -> Iterator[Group]:
    """Supermodules under names that nobody has yet."""
    names = {group.name for group in standing}
    for group in groups:
        free = (group.name, *(f"{group.name}-{number}" for number in range(2, len(names) + 3)))
        name = next(name for name in free if name not in names)
        names.add(name)
        yield replace(group, name=name)


def objections(model: Model, document: Document, taken: Clipboard) -> list[Objection]:
    """Every reason why what was copied may not be placed, task by task."""
    here = model.libraries_of(document).tasks
    tasks = model.libraries.within(Configuration("", taken.placed)).tasks
    standing = [here[name] for name in document.content.names if name in here]
    against = _against(standing, [tasks[placed.task] for placed in taken.placed if placed.task in tasks])
    missing = set(document.content.names) - set(here)
    objections: list[Objection] = []
    for placed in taken.placed:
        task = tasks.get(placed.task)
        if placed.task in missing:
            objections.append(
                Objection(
                    Reason.of("desk.placed_already", task=placed.task),
                    (Remedy(Reason.of("desk.show_task", name=placed.task), show=ShowTask(placed.task)),),
                )
            )
        elif task is None:
            open_one = Remedy(Reason.of("desk.open_library"), show=ShowLibraries())
            objections.append(Objection(Reason.of("desk.in_no_library", task=placed.task), (open_one,)))
        else:
            for refused in against.get(task.name, ()):
                (objection,) = reasons((refused,), document.id, task)
                remedies = tuple(remedy for remedy in objection.remedies if _helps(remedy, taken))
                objections.append(Objection(_with_name(task.name, refused.reason), remedies))
    return objections


def refusal(what: Reason, against: Sequence[Objection]) -> No:
    """A no with everything that speaks against it."""
    remedies = tuple(dict.fromkeys(remedy for reason in against for remedy in reason.remedies))
    return No(
        Reason.of("desk.with_reasons", what=what, reasons=tuple(objection.text for objection in against)), remedies
    )


def _against(standing: Sequence[Task], pasted: Sequence[Task]) -> dict[str, tuple[Refusal, ...]]:
    """What speaks against the tasks that are pasted, by their names; they may contradict each other, too."""
    refusals: dict[str, tuple[Refusal, ...]] = {}
    for later, _, refused in conflict.conflicts((*standing, *pasted), len(standing)):
        refusals[later.name] = (*refusals.get(later.name, ()), *refused)
    return refusals


def _with_name(name: str, reason: Reason) -> Reason:
    """What speaks against a task, with its name in front where the sentence does not begin with it."""
    is_named = reason.args.get(_NAMED_FIRST.get(reason.key, "")) == name
    if is_named:
        return reason
    return Reason.of("desk.named_wrong", name=name, why=reason)


def _helps(remedy: Remedy, taken: Clipboard) -> bool:
    """Whether a remedy of one task is one of all: an exchange is not, as it places that task alone."""
    return len(taken.placed) == 1 or not isinstance(remedy.act, act.Exchange)
