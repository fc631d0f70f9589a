"""Acts on the canvas: place, move, flip, align, remove, exchange (requirements C06 to C10, C24)."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.other_tasks import with_other_tasks
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.task_plan import is_hardware
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import UNKNOWN_RTPU, Configuration, Group, Placed
from onika.model.rules import arrangement, loci, placement
from onika.wire import act
from onika.wire.view import Remedy, ShowLibraries
from onika.words.reason import Reason

_LIMIT = 100_000
"""Pixels: nothing is placed farther out, so that it can be found again."""


@on_document
def place(model: Model, document: Document, command: act.Place, _outside: Services) -> Done | No:
    """Place a task from a library."""
    refused = _refused(model, document, command.task, ())
    if refused:
        return refused
    rate = model.libraries.rates.get(command.task, 0.0)
    spot = inside(command.x, command.y)
    new = Placed(command.task, *spot, command.in_left, rate, command.rtpu or UNKNOWN_RTPU)
    configuration = document.content.configuration
    return with_other_tasks(
        model,
        document,
        replace(configuration, placed=(*configuration.placed, new)),
        Reason.of("desk.placing", task=command.task),
    )


@on_document
def exchange(model: Model, document: Document, command: act.Exchange, _outside: Services) -> Done | No:
    """Place a task where another stands."""
    old = document.content.placed(command.old)
    if old is None:
        return No(Reason.of("desk.not_on_canvas", name=command.old))
    refused = _refused(model, document, command.new, (command.old,))
    if refused:
        return refused
    new = Placed(command.new, old.x, old.y, old.in_left, model.libraries.rates.get(command.new, 0.0), old.rtpu)
    configuration = document.content.configuration
    placed = tuple(new if placed is old else placed for placed in configuration.placed)
    exchanged = replace(
        configuration, placed=placed, groups=_taken_over(configuration.groups, command.old, command.new)
    )
    return with_other_tasks(model, document, exchanged, Reason.of("desk.replacing", old=command.old, new=command.new))


@on_document
def remove(model: Model, document: Document, command: act.Remove, _outside: Services) -> Done | No:
    """Remove tasks."""
    missing = absent(document, command.tasks)
    if missing:
        return missing
    configuration = document.content.configuration
    placed = tuple(placed for placed in configuration.placed if placed.task not in command.tasks)
    return with_other_tasks(
        model, document, replace(configuration, placed=placed), Reason.of("desk.removing", names=several(command.tasks))
    )


@on_document
def move(model: Model, document: Document, command: act.Move, _outside: Services) -> Done | No:
    """Move tasks and loci."""
    missing = absent(document, command.tasks)
    if missing:
        return missing
    configuration = document.content.configuration
    svars = {locus.svar for locus in configuration.loci}
    lost = [svar for svar in command.loci if svar not in svars]
    if lost:
        return No(Reason.of("desk.no_locus", svar=lost[0]))
    tasks = {name: inside(*spot) for name, spot in command.tasks.items()}
    spots = {svar: inside(*spot) for svar, spot in command.loci.items()}
    placed = _placed_at(configuration, tasks)
    moved = tuple(
        replace(locus, x=spots[locus.svar][0], y=spots[locus.svar][1]) if locus.svar in spots else locus
        for locus in configuration.loci
    )
    label = Reason.of("desk.moving", icons=several((*command.tasks, *command.loci)))
    return _as_it_stands(model, document, replace(configuration, placed=placed, loci=moved), label)


@on_document
def flip(model: Model, document: Document, command: act.Flip, _outside: Services) -> Done | No:
    """Turn the direction of data flow."""
    missing = absent(document, command.tasks)
    if missing:
        return missing
    configuration = document.content.configuration
    placed = tuple(
        replace(placed, in_left=not placed.in_left) if placed.task in command.tasks else placed
        for placed in configuration.placed
    )
    turned = replace(configuration, placed=placed)
    boxes = model.libraries_of(document).boxes(document.content.names)
    return _as_it_stands(
        model,
        document,
        loci.flipped(turned, command.tasks, boxes),
        Reason.of("desk.flipping", names=several(command.tasks)),
    )


@on_document
def align(model: Model, document: Document, command: act.Align, _outside: Services) -> Done | No:
    """Bring tasks onto one line, or to equal distances."""
    missing = absent(document, command.tasks)
    if missing:
        return missing
    configuration = document.content.configuration
    chosen = [placed for placed in configuration.placed if placed.task in command.tasks]
    boxes = model.libraries_of(document).boxes(command.tasks)
    heights = {name: box.height for name, box in boxes.items()}
    spots = _aligned(chosen, heights, command.edge)
    placed = _placed_at(configuration, spots)
    return _as_it_stands(
        model, document, replace(configuration, placed=placed), Reason.of("desk.aligning", names=several(command.tasks))
    )


@on_document
def arrange(model: Model, document: Document, command: act.Arrange, _outside: Services) -> Done | No:
    """Lay tasks out in columns along the flow of data, hardware first."""
    missing = absent(document, command.tasks)
    if missing:
        return missing
    libraries = model.libraries_of(document)
    names = document.content.names
    hardware = [name for name in names if name in libraries.tasks and is_hardware(libraries.tasks[name], libraries)]
    arranged = arrangement.arranged(
        document.content.configuration, libraries.boxes(names), hardware, frozenset(command.tasks)
    )
    label = Reason.of("desk.arranging", name=several(command.tasks) if command.tasks else document.name)
    return _as_it_stands(model, document, arranged, label)


@on_document
def show(model: Model, document: Document, command: act.Show, _outside: Services) -> Done | No:
    """Show or hide the connections of variables."""
    configuration = document.content.configuration
    turned = tuple(
        replace(locus, show=command.is_shown) if locus.svar in command.svars else locus for locus in configuration.loci
    )
    showing, hiding = "desk.showing_connections", "desk.hiding_connections"
    label = Reason.of(showing if command.is_shown else hiding, names=several(command.svars))
    return _as_it_stands(model, document, replace(configuration, loci=turned), label)


def several(names: Iterable[str]) -> Reason:
    """A few names, or how many there are."""
    names = tuple(names)
    if len(names) <= 2:
        return Reason.of("desk.names_and", names=names)
    return Reason.of("desk.thing_count", count=len(names))


def _as_it_stands(model: Model, document: Document, configuration: Configuration, label: Reason) -> Done:
    content = replace(document.content, configuration=configuration)
    return Done(model.with_document(document.having(content)), label, document.id)


def _refused(model: Model, document: Document, name: str, leaving: tuple[str, ...]) -> No | None:
    """Why a task may not join, if so."""
    tasks = model.libraries_of(document).tasks
    task = model.libraries.tasks.get(name)
    if task is None:
        return No(Reason.of("desk.no_task", name=name), (Remedy(Reason.of("desk.open_library"), show=ShowLibraries()),))
    others = [tasks[name] for name in document.content.names if name in tasks and name not in leaving]
    objections = reasons(placement.refusals(task, others), document.id, task)
    if not objections:
        return None
    remedies = tuple(dict.fromkeys(remedy for reason in objections for remedy in reason.remedies))
    return No(
        Reason.of("desk.not_placed", name=name, reasons=tuple(objection.text for objection in objections)), remedies
    )


def absent(document: Document, names: Iterable[str]) -> No | None:
    """Why tasks that are not on the canvas cannot be meant, if so."""
    placed_names = set(document.content.names)
    lost = [name for name in names if name not in placed_names]
    if not lost:
        return None
    name: Reason | str = lost[0]
    for other in lost[1:]:
        name = Reason.of("desk.and_no", left=name, right=other)
    return No(Reason.of("desk.not_on_canvas", name=name))


def inside(x: int, y: int) -> tuple[int, int]:
    """The nearest spot that can be found again."""
    return max(-_LIMIT, min(_LIMIT, x)), max(-_LIMIT, min(_LIMIT, y))


def _taken_over(groups: Iterable[Group], old: str, new: str) -> tuple[Group, ...]:
    """A task in the place of another in its supermodule."""
    return tuple(
        replace(group, tasks=tuple(new if name == old else name for name in group.tasks))
        if old in group.tasks
        else group
        for group in groups
    )


def _placed_at(configuration: Configuration, spots: Mapping[str, tuple[int, int]]) -> tuple[Placed, ...]:
    """The tasks of a configuration, those that are named at their new spots."""
    return tuple(
        replace(placed, x=spots[placed.task][0], y=spots[placed.task][1]) if placed.task in spots else placed
        for placed in configuration.placed
    )


def _aligned(chosen: list[Placed], heights: dict[str, int], edge: str) -> dict[str, tuple[int, int]]:
    """Where each task stands when all stand at one edge, or at equal distances in columns or rows."""
    xs, ys = [placed.x for placed in chosen], [placed.y for placed in chosen]
    match edge:
        case "left":
            return {placed.task: (min(xs), placed.y) for placed in chosen}
        case "right":
            return {placed.task: (max(xs), placed.y) for placed in chosen}
        case "top":
            return {placed.task: (placed.x, min(ys)) for placed in chosen}
        case "bottom":
            return _at_the_bottom(chosen, heights)
        case "columns":
            in_columns = sorted(chosen, key=lambda placed: placed.x)
            return {placed.task: (x, placed.y) for placed, x in zip(in_columns, _spread(sorted(xs)), strict=True)}
    in_rows = sorted(chosen, key=lambda placed: placed.y)
    return {placed.task: (placed.x, y) for placed, y in zip(in_rows, _spread(sorted(ys)), strict=True)}


def _at_the_bottom(chosen: list[Placed], heights: dict[str, int]) -> dict[str, tuple[int, int]]:
    low = max((placed.y + heights.get(placed.task, 0) for placed in chosen), default=0)
    return {placed.task: (placed.x, low - heights.get(placed.task, 0)) for placed in chosen}


def _spread(values: list[int]) -> list[int]:
    """The same first and last value, the others at equal distances."""
    if len(values) < 3:
        return values
    step = (values[-1] - values[0]) / (len(values) - 1)
    return [round(values[0] + step * n) for n in range(len(values))]
