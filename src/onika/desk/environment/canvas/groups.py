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
from onika.desk.environment.outcome.remedy import overwriting, plain
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.clipboard import Copied, copied
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import Kind
from onika.model.configuration import Configuration, Group
from onika.model.rules import loci
from onika.store.base_directory import BaseDirectory
from onika.wire import act
from onika.wire.view import Reason, Remedy, ShowTask
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME


@on_document
def group(model: Model, document: Document, asked: act.Group, _outside: Surroundings) -> Done | No:
    """Handle tasks as one, in this order; supermodules that are among them whole go into it, under its name."""
    tasks = tuple(dict.fromkeys(asked.tasks))
    if not TASK_NAME.match(asked.name):
        form = "a name of letters, digits and _ . - that begins with a letter"
        return No(f"{asked.name!r} is no name for a supermodule", fields={"name": f"expected {form}"})
    if not tasks:
        return No("nothing is selected")
    refused = absent(document, tasks) or _taken(document, asked.name, tasks)
    if refused:
        return refused
    configuration = document.content.configuration
    new = Group(asked.name, tasks)
    others = [one for one in configuration.groups if one.name != asked.name and not set(one.tasks) <= set(tasks)]
    label = f"making {several(tasks)} the supermodule {asked.name}"
    return _regrouped(model, document, replace(configuration, groups=(*others, new)), label)


def ungroup(model: Model, asked: act.Ungroup, _outside: Surroundings) -> Done | No:
    """Expand a supermodule into its parts."""
    found = _of(model, asked.doc, asked.name)
    if isinstance(found, No):
        return found
    document, one = found
    configuration = document.content.configuration
    others = tuple(other for other in configuration.groups if other is not one)
    return _regrouped(model, document, replace(configuration, groups=others), f"expanding {asked.name}")


def save_group(model: Model, asked: act.SaveGroup, outside: Surroundings) -> Done | No:
    """Save a supermodule as a configuration of its own; the value is the path of its file."""
    found = _of(model, asked.doc, asked.name)
    if isinstance(found, No):
        return found
    document, one = found
    base = Path(asked.base) if asked.base else document.base
    if base is None:
        reason = f"{document.name} has no file yet: say in which base directory {asked.name} is to be"
        return No(reason, _elsewhere(asked, None, outside))
    directory = BaseDirectory(base)
    path = directory.configuration_file(asked.name)
    if document.opened is not None and document.opened.path.resolve() == path.resolve():
        return No(f"{path} is the file of the configuration that {asked.name} is a part of: give it another name")
    done = directory.save_configuration(_part(model, document, one), overwrites=asked.overwrites)
    if isinstance(done, Refusal):
        again = act.SaveGroup(asked.doc, asked.name, asked.base, overwrites=True)
        return No(plain(done.reason), (*overwriting(done, again), *_elsewhere(asked, base, outside)))
    return Done(model, value=str(done.path))


@on_document
def insert(model: Model, document: Document, asked: act.Insert, outside: Surroundings) -> Done | No:
    """Place all tasks of a configuration as a supermodule of its name; the value is the names of the tasks."""
    found = read(asked.path, outside)
    if isinstance(found, No):
        return found
    configuration = found.opened.value
    name = configuration.name
    if not configuration.placed:
        return No(f"{name} has no tasks")
    new = Group(name, tuple(_in_order(configuration)))
    taken = Copied(configuration.placed, configuration.loci, (new,))
    against = [*_namesake(document, name), *clipboard.objections(model.shelf, document, taken)]
    if against:
        return clipboard.refusal(f"{name} is not inserted", against)
    return clipboard.placed(model, document, taken.at(*inside(asked.x, asked.y)), f"inserting {name}")


def turn_group(model: Model, asked: act.TurnGroup, outside: Surroundings) -> Done | No:
    """Turn a supermodule ON in its order, or OFF the other way round."""
    found = _of(model, asked.doc, asked.name)
    if isinstance(found, No):
        return found
    document, one = found
    tasks = one.tasks if asked.is_on else one.tasks[::-1]
    done = task_commands.turn(model, act.Turn(document.id, tasks, asked.is_on), outside)
    return done if isinstance(done, No) else replace(done, label=f"turning {one.name} {'ON' if asked.is_on else 'OFF'}")


def _of(model: Model, doc: str, name: str) -> tuple[Document, Group] | No:
    document = model.documents.get(doc)
    if document is None:
        return closed(Kind.CONFIGURATION)
    found = document.content.configuration.group(name)
    return (document, found) if found else No(f"there is no supermodule {name}")


def _elsewhere(asked: act.SaveGroup, base: Path | None, outside: Surroundings) -> tuple[Remedy, ...]:
    """The other base directories that it could be saved in."""
    bases = [one.path for one in outside.site.directories if one.path != base and os.access(one.path, os.W_OK)]
    return tuple(Remedy(f"Save it in {one}", act.SaveGroup(asked.doc, asked.name, str(one))) for one in bases)


def _regrouped(model: Model, document: Document, configuration: Configuration, label: str) -> Done:
    content = replace(document.content, configuration=configuration)
    return Done(model.with_document(document.having(content)), label, document.id)


def _taken(document: Document, name: str, tasks: tuple[str, ...]) -> No | None:
    """Why these cannot be one, if so: the name is that of others, or a part of another supermodule is among them."""
    against: list[Reason] = []
    for one in document.content.configuration.groups:
        among = [task for task in one.tasks if task in tasks]
        if one.name == name:
            against += [] if among else _namesake(document, name)
        elif among and len(among) < len(one.tasks):
            rest = tuple(task for task in one.tasks if task not in tasks)
            verb = "is" if len(among) == 1 else "are"
            remedies = (
                Remedy(f"Take all of {one.name}", act.Group(document.id, name, (*tasks, *rest))),
                Remedy(f"Expand {one.name}", act.Ungroup(document.id, one.name)),
            )
            against.append(Reason(f"{several(among)} {verb} in the supermodule {one.name} already", remedies))
    return clipboard.refusal(f"{name} is not made", against) if against else None


def _namesake(document: Document, name: str) -> list[Reason]:
    """That a supermodule of this name is there already, if so."""
    one = document.content.configuration.group(name)
    if one is None:
        return []
    show = Remedy(f"Show {one.tasks[0]}", show=ShowTask(one.tasks[0]))
    expand = Remedy(f"Expand {name}", act.Ungroup(document.id, name))
    return [Reason(f"there is a supermodule {name} already", (show, expand))]


def _part(model: Model, document: Document, one: Group) -> Configuration:
    """The configuration of a supermodule alone: its loci stand where they are, and count its own tasks."""
    boxes = model.shelf.boxes(one.tasks)
    svars = (pin.svar for box in boxes.values() for pin in box.pins)
    taken = copied(document.content.configuration, one.tasks, svars)
    part = Configuration(one.name, taken.placed, taken.loci, (one,))
    return loci.settled(part, boxes, part)


def _in_order(configuration: Configuration) -> Iterator[str]:
    """The tasks of a file as they come: those of a supermodule in it together, in its order."""
    told: set[str] = set()
    home = {task: one for one in configuration.groups for task in one.tasks}
    for placed in configuration.placed:
        together = home[placed.task].tasks if placed.task in home else (placed.task,)
        yield from (name for name in together if name not in told)
        told.update(together)
