"""Acts on the canvas: place, move, flip, align, remove, exchange (requirements C06 to C10, C24)."""

from collections.abc import Iterable
from dataclasses import replace

from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import UNKNOWN_RTPU, Configuration, Group, Placed
from onika.model.rules import loci, placement
from onika.wire import act
from onika.wire.view import Remedy, ShowLibraries

_LIMIT = 100_000
"""Pixels: nothing is placed farther out, so that it can be found again."""


@on_document
def place(model: Model, document: Document, asked: act.Place, _outside: Surroundings) -> Done | No:
    """Place a task from a library."""
    refused = _refused(model, document, asked.task, ())
    if refused:
        return refused
    rate = model.shelf.rates.get(asked.task, 0.0)
    spot = inside(asked.x, asked.y)
    new = Placed(asked.task, *spot, asked.in_left, rate, asked.rtpu or UNKNOWN_RTPU)
    configuration = document.content.configuration
    return changed(
        model, document, replace(configuration, placed=(*configuration.placed, new)), f"placing {asked.task}"
    )


@on_document
def exchange(model: Model, document: Document, asked: act.Exchange, _outside: Surroundings) -> Done | No:
    """Place a task where another stands."""
    old = document.content.placed(asked.old)
    if old is None:
        return No(f"there is no {asked.old} on the canvas")
    refused = _refused(model, document, asked.new, (asked.old,))
    if refused:
        return refused
    new = Placed(asked.new, old.x, old.y, old.in_left, model.shelf.rates.get(asked.new, 0.0), old.rtpu)
    configuration = document.content.configuration
    placed = tuple(new if one is old else one for one in configuration.placed)
    exchanged = replace(configuration, placed=placed, groups=_taken_over(configuration.groups, asked.old, asked.new))
    return changed(model, document, exchanged, f"replacing {asked.old} by {asked.new}")


@on_document
def remove(model: Model, document: Document, asked: act.Remove, _outside: Surroundings) -> Done | No:
    """Remove tasks."""
    missing = absent(document, asked.tasks)
    if missing:
        return missing
    configuration = document.content.configuration
    placed = tuple(one for one in configuration.placed if one.task not in asked.tasks)
    return changed(model, document, replace(configuration, placed=placed), f"removing {several(asked.tasks)}")


@on_document
def move(model: Model, document: Document, asked: act.Move, _outside: Surroundings) -> Done | No:
    """Move tasks and loci."""
    missing = absent(document, asked.tasks)
    if missing:
        return missing
    configuration = document.content.configuration
    known = {one.svar for one in configuration.loci}
    lost = [svar for svar in asked.loci if svar not in known]
    if lost:
        return No(f"there is no locus of {lost[0]} on the canvas")
    tasks = {name: inside(*spot) for name, spot in asked.tasks.items()}
    spots = {svar: inside(*spot) for svar, spot in asked.loci.items()}
    placed = tuple(_at(one, tasks.get(one.task)) for one in configuration.placed)
    moved = tuple(
        replace(one, x=spots[one.svar][0], y=spots[one.svar][1]) if one.svar in spots else one
        for one in configuration.loci
    )
    label = f"moving {several((*asked.tasks, *asked.loci))}"
    return _as_it_stands(model, document, replace(configuration, placed=placed, loci=moved), label)


@on_document
def flip(model: Model, document: Document, asked: act.Flip, _outside: Surroundings) -> Done | No:
    """Turn the direction of data flow."""
    missing = absent(document, asked.tasks)
    if missing:
        return missing
    configuration = document.content.configuration
    placed = tuple(
        replace(one, in_left=not one.in_left) if one.task in asked.tasks else one for one in configuration.placed
    )
    turned = replace(configuration, placed=placed)
    boxes = model.shelf.boxes(document.content.names)
    return _as_it_stands(model, document, loci.flipped(turned, asked.tasks, boxes), f"flipping {several(asked.tasks)}")


@on_document
def align(model: Model, document: Document, asked: act.Align, _outside: Surroundings) -> Done | No:
    """Bring tasks onto one line, or to equal distances."""
    missing = absent(document, asked.tasks)
    if missing:
        return missing
    configuration = document.content.configuration
    chosen = [one for one in configuration.placed if one.task in asked.tasks]
    boxes = model.shelf.boxes(asked.tasks)
    heights = {name: box.height for name, box in boxes.items()}
    spots = _aligned(chosen, heights, asked.edge)
    placed = tuple(_at(one, spots.get(one.task)) for one in configuration.placed)
    return _as_it_stands(model, document, replace(configuration, placed=placed), f"aligning {several(asked.tasks)}")


@on_document
def show(model: Model, document: Document, asked: act.Show, _outside: Surroundings) -> Done | No:
    """Show or hide the connections of variables."""
    configuration = document.content.configuration
    turned = tuple(replace(one, show=asked.is_shown) if one.svar in asked.svars else one for one in configuration.loci)
    verb = "showing" if asked.is_shown else "hiding"
    label = f"{verb} the connections of {several(asked.svars)}"
    return _as_it_stands(model, document, replace(configuration, loci=turned), label)


def changed(model: Model, document: Document, configuration: Configuration, label: str) -> Done:
    """With other tasks: the loci are settled, and what is wanted follows."""
    names = tuple(one.task for one in configuration.placed)
    boxes = model.shelf.boxes((*names, *document.content.names))
    settled = loci.settled(configuration, boxes, document.content.configuration)
    content = document.content.with_configuration(settled)
    if document.live is not None:
        content = replace(content, wanted={**dict.fromkeys(names, False), **content.wanted})
    return Done(model.with_document(document.having(content)), label, document.id)


def several(names: Iterable[str]) -> str:
    """A few names, or how many there are."""
    found = tuple(names)
    return " and ".join(found) if len(found) <= 2 else f"{len(found)} things"


def _as_it_stands(model: Model, document: Document, configuration: Configuration, label: str) -> Done:
    content = replace(document.content, configuration=configuration)
    return Done(model.with_document(document.having(content)), label, document.id)


def _refused(model: Model, document: Document, name: str, leaving: tuple[str, ...]) -> No | None:
    """Why a task may not join, if so."""
    tasks = model.shelf.tasks
    task = tasks.get(name)
    if task is None:
        return No(f"no open library has a task {name}", (Remedy("Open a library…", show=ShowLibraries()),))
    others = [tasks[one] for one in document.content.names if one in tasks and one not in leaving]
    found = reasons(placement.refusals(task, others), document.id, task)
    if not found:
        return None
    remedies = tuple(dict.fromkeys(one for reason in found for one in reason.remedies))
    return No(f"{name} cannot be placed: {'; '.join(reason.text for reason in found)}", remedies)


def absent(document: Document, names: Iterable[str]) -> No | None:
    """Why tasks that are not on the canvas cannot be meant, if so."""
    known = set(document.content.names)
    lost = [name for name in names if name not in known]
    return No(f"there is no {' and no '.join(lost)} on the canvas") if lost else None


def inside(x: int, y: int) -> tuple[int, int]:
    """The nearest spot that can be found again."""
    return max(-_LIMIT, min(_LIMIT, x)), max(-_LIMIT, min(_LIMIT, y))


def _taken_over(groups: Iterable[Group], old: str, new: str) -> tuple[Group, ...]:
    """A task in the place of another in its supermodule."""
    return tuple(
        replace(one, tasks=tuple(new if name == old else name for name in one.tasks)) if old in one.tasks else one
        for one in groups
    )


def _at(one: Placed, spot: tuple[int, int] | None) -> Placed:
    return one if spot is None else replace(one, x=spot[0], y=spot[1])


def _aligned(chosen: list[Placed], heights: dict[str, int], edge: str) -> dict[str, tuple[int, int]]:
    bottoms = {one.task: one.y + heights.get(one.task, 0) for one in chosen}
    match edge:
        case "left":
            return {one.task: (min(other.x for other in chosen), one.y) for one in chosen}
        case "right":
            return {one.task: (max(other.x for other in chosen), one.y) for one in chosen}
        case "top":
            return {one.task: (one.x, min(other.y for other in chosen)) for one in chosen}
        case "bottom":
            low = max(bottoms.values(), default=0)
            return {one.task: (one.x, low - heights.get(one.task, 0)) for one in chosen}
        case "columns":
            xs = _spread(sorted(one.x for one in chosen))
            return {one.task: (xs[n], one.y) for n, one in enumerate(sorted(chosen, key=lambda one: one.x))}
    ys = _spread(sorted(one.y for one in chosen))
    return {one.task: (one.x, ys[n]) for n, one in enumerate(sorted(chosen, key=lambda one: one.y))}


def _spread(values: list[int]) -> list[int]:
    """The same first and last value, the others at equal distances."""
    if len(values) < 3:
        return values
    step = (values[-1] - values[0]) / (len(values) - 1)
    return [round(values[0] + step * n) for n in range(len(values))]
