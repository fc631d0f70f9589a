"""Acts on supermodules: tasks that are handled as one, saved, recalled and expanded (§7, requirement C17)."""

import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.canvas import clipboard, task_commands
from onika.desk.environment.canvas.placement import absent, inside, several
from onika.desk.environment.file.configurations import read
from onika.desk.environment.outcome.on_file import closed, on_document
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import overwriting
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.clipboard import Clipboard, copied
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.model.configuration import Configuration, Group
from onika.model.rules import loci
from onika.store.own_copy import saving_place
from onika.store.shipped import is_shipped
from onika.store.user_path import user_path
from onika.wire import act
from onika.wire.view import Objection, Remedy, ShowTask
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason


@on_document
def group(model: Model, document: Document, command: act.Group, _outside: Services) -> Done | No:
    """Handle tasks as one, in this order; supermodules that are among them whole go into it, under its name."""
    tasks = tuple(dict.fromkeys(command.tasks))
    if not TASK_NAME.match(command.name):
        return No(
            Reason.of("desk.no_supermodule_name", name=command.name), fields={"name": Reason.of("desk.name_of_letters")}
        )
    if not tasks:
        return No(Reason.of("desk.nothing_selected"))
    refused = absent(document, tasks) or _taken(document, command.name, tasks)
    if refused:
        return refused
    configuration = document.content.configuration
    new = Group(command.name, tasks)
    others = [
        group for group in configuration.groups if group.name != command.name and not set(group.tasks) <= set(tasks)
    ]
    label = Reason.of("desk.making_supermodule", tasks=several(tasks), name=command.name)
    return _regrouped(model, document, replace(configuration, groups=(*others, new)), label)


def ungroup(model: Model, command: act.Ungroup, _outside: Services) -> Done | No:
    """Expand a supermodule into its parts."""
    group_place = _of(model, command.doc, command.name)
    if isinstance(group_place, No):
        return group_place
    document, group = group_place
    configuration = document.content.configuration
    others = tuple(other for other in configuration.groups if other is not group)
    return _regrouped(
        model, document, replace(configuration, groups=others), Reason.of("desk.expanding", name=command.name)
    )


def save_group(model: Model, command: act.SaveGroup, outside: Services) -> Done | No:
    """Save a supermodule as a configuration of its own; the value is the path of its file."""
    group_place = _of(model, command.doc, command.name)
    if isinstance(group_place, No):
        return group_place
    document, group = group_place
    base = user_path(command.base, outside.site.own) if command.base else document.base
    if isinstance(base, Reason):
        return No(base, fields={"base": base})
    if base is None:
        reason = Reason.of("desk.supermodule_place", file=document.name, name=command.name)
        return No(reason, _elsewhere(command, None, outside))
    directory = saving_place(base, outside.site)
    if isinstance(directory, Refusal):
        return No(directory.reason, _elsewhere(command, base, outside))
    path = directory.configuration_file(command.name)
    if document.opened is not None and document.opened.path.resolve() == path.resolve():
        return No(Reason.of("desk.supermodule_file", path=str(path), name=command.name))
    done = directory.save_configuration(_part(model, document, group), overwrites=command.overwrites)
    if isinstance(done, Refusal):
        again = act.SaveGroup(command.doc, command.name, command.base, overwrites=True)
        return No(done.reason, (*overwriting(done, again), *_elsewhere(command, base, outside)))
    return Done(model, value=str(done.path))


@on_document
def insert(model: Model, document: Document, command: act.Insert, outside: Services) -> Done | No:
    """Place all tasks of a configuration as a supermodule of its name; the value is the names of the tasks."""
    reading = read(command.path, outside)
    if isinstance(reading, No):
        return reading
    configuration = reading.opened.value
    name = configuration.name
    if not configuration.placed:
        return No(Reason.of("desk.without_tasks", name=name))
    new = Group(name, tuple(_in_order(configuration)))
    taken = Clipboard(configuration.placed, configuration.loci, (new,))
    against = [*_namesake(document, name), *clipboard.objections(model, document, taken)]
    if against:
        return clipboard.refusal(Reason.of("desk.not_inserted", name=name), against)
    return clipboard.placed(
        model, document, taken.at(*inside(command.x, command.y)), Reason.of("desk.inserting", step=name)
    )


def turn_group(model: Model, command: act.TurnGroup, outside: Services) -> Done | No:
    """Turn a supermodule ON in its order, or OFF the other way round."""
    group_place = _of(model, command.doc, command.name)
    if isinstance(group_place, No):
        return group_place
    document, group = group_place
    tasks = group.tasks if command.is_on else group.tasks[::-1]
    done = task_commands.turn(model, act.Turn(document.id, tasks, command.is_on), outside)
    if isinstance(done, No):
        return done
    key_on, key_off = "desk.turning_on", "desk.turning_off"
    return replace(done, label=Reason.of(key_on if command.is_on else key_off, name=group.name))


def _of(model: Model, doc: str, name: str) -> tuple[Document, Group] | No:
    document = model.documents.get(doc)
    if document is None:
        return closed(DocumentKind.CONFIGURATION)
    group = document.content.configuration.group(name)
    if group:
        return (document, group)
    return No(Reason.of("desk.no_supermodule", name=name))


def _elsewhere(command: act.SaveGroup, base: Path | None, outside: Services) -> tuple[Remedy, ...]:
    """The other base directories that it could be saved in."""
    bases = [
        directory.path
        for directory in outside.site.directories
        if directory.path != base and not is_shipped(directory.path) and os.access(directory.path, os.W_OK)
    ]
    return tuple(
        Remedy(Reason.of("desk.save_in", path=str(base)), act.SaveGroup(command.doc, command.name, str(base)))
        for base in bases
    )


def _regrouped(model: Model, document: Document, configuration: Configuration, label: Reason) -> Done:
    content = replace(document.content, configuration=configuration)
    return Done(model.with_document(document.having(content)), label, document.id)


def _taken(document: Document, name: str, tasks: tuple[str, ...]) -> No | None:
    """Why these cannot be one, if so: the name is that of others, or a part of another supermodule is among them."""
    against: list[Objection] = []
    for group in document.content.configuration.groups:
        among = [task for task in group.tasks if task in tasks]
        if group.name == name:
            against += [] if among else _namesake(document, name)
        elif among and len(among) < len(group.tasks):
            rest = tuple(task for task in group.tasks if task not in tasks)
            single, plural = "desk.in_supermodule", "desk.are_in_supermodule"
            key = single if len(among) == 1 else plural
            remedies = (
                Remedy(Reason.of("desk.take_all_of", name=group.name), act.Group(document.id, name, (*tasks, *rest))),
                Remedy(Reason.of("desk.expand", name=group.name), act.Ungroup(document.id, group.name)),
            )
            against.append(Objection(Reason.of(key, names=several(among), group=group.name), remedies))
    if against:
        return clipboard.refusal(Reason.of("desk.not_made", name=name), against)
    return None


def _namesake(document: Document, name: str) -> list[Objection]:
    """That a supermodule of this name is there already, if so."""
    group = document.content.configuration.group(name)
    if group is None:
        return []
    show = Remedy(Reason.of("desk.show_task", name=group.tasks[0]), show=ShowTask(group.tasks[0]))
    expand = Remedy(Reason.of("desk.expand", name=name), act.Ungroup(document.id, name))
    return [Objection(Reason.of("desk.supermodule_there", name=name), (show, expand))]


def _part(model: Model, document: Document, group: Group) -> Configuration:
    """The configuration of a supermodule alone: its loci stand where they are, and count its own tasks."""
    boxes = model.libraries_of(document).boxes(group.tasks)
    svars = (pin.svar for box in boxes.values() for pin in box.pins)
    taken = copied(document.content.configuration, group.tasks, svars)
    part = Configuration(group.name, taken.placed, taken.loci, (group,))
    return loci.settled(part, boxes, part)


def _in_order(configuration: Configuration) -> Iterator[str]:
    """The tasks of a file as they come: those of a supermodule in it together, in its order."""
    reported: set[str] = set()
    home = {task: group for group in configuration.groups for task in group.tasks}
    for placed in configuration.placed:
        together = home[placed.task].tasks if placed.task in home else (placed.task,)
        yield from (name for name in together if name not in reported)
        reported.update(together)
