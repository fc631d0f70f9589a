"""A document beside what runs: connecting merges the two, looking again takes the facts over (C12, Equation (1))."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.outcome.remedy import plain
from onika.desk.environment.reconcile import holders
from onika.desk.environment.reconcile.live_facts import alive, settled, with_standing
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import Live
from onika.desk.environment.state.model import Model
from onika.model.configuration import Configuration, Placed
from onika.model.planned import task_of
from onika.model.rules import loci
from onika.model.rules.merge import Merge, merge
from onika.wire import live, page, request, view

_GAP = 40
"""Pixels between what stands on the canvas and what comes onto it."""
_BELOW = 1200
"""Pixels after which another column begins."""


@dataclass(frozen=True, slots=True)
class Merged:
    """A document merged with what runs, and what is to be brought to life now."""

    document: Document
    spawn: tuple[str, ...]
    says: tuple[page.Say, ...]


def merged(model: Model, document: Document, known: Live, standing: live.Standing) -> Merged:
    """Equation (1) with (4): what runs wins, what runs and is not placed comes onto the canvas, the rest is spawned."""
    there = alive(standing, known.subsystem)
    running = tuple(_placed(one) for one in there.values())
    tasks = {**model.shelf.tasks, **{name: task_of(one.task) for name, one in there.items()}}
    found = merge(document.content.configuration.placed, running, tasks)
    configuration = _configuration(model, document.content.configuration, found)
    wanted = {name: one.is_wanted_on or one.state in ("ON", "ASKING") for name, one in there.items()}
    known = replace(with_standing(known, standing), state="live", turns={}, pending={}, early={})
    spawn = () if known.is_foreign else tuple(one.task for one in found.spawn)
    document = replace(document, content=Content(configuration, wanted), live=known)
    return Merged(document, spawn, tuple(_says(document, found, known)))


def look_again(doc: str) -> Order:
    """Ask what there is, and take the facts over."""
    return Order(live.Survey(), partial(seen, doc=doc))


def seen(model: Model, response: request.Response, doc: str) -> Done:
    """What there is now: facts of tasks, and tasks that somebody else has brought to life."""
    if not isinstance(response, live.Standing):
        return Done(model)
    model = replace(model, runtime=runtime_view(model.runtime, response))
    document = model.documents.get(doc)
    known = document.live if document else None
    if document is None or known is None or known.state != "live":
        return Done(model)
    known = with_standing(known, response)
    document = replace(document, live=known)
    if not known.pending:
        document = settled(document.having(_with_strangers(model, document, known, response)))
    return Done(model.with_document(document))


def runtime_view(former: view.RuntimeView, standing: live.Standing) -> view.RuntimeView:
    """The runtime as it stands."""
    return view.RuntimeView(
        state="linked",
        address=former.address,
        is_virtual=standing.is_virtual,
        is_stopped=standing.is_stopped,
        stop_text=former.stop_text if standing.is_stopped else "",
        units={one.name: view.UnitView(round(one.load, 2), one.is_lost) for one in standing.rtpus},
        worlds=dict.fromkeys(standing.worlds, True),
        subsystems={one.name: one.application or one.holder for one in standing.subsystems},
        holds=holders.surveyed(former.holds, standing),
        sessions=former.sessions,
    )


def with_loci(model: Model, document: Document) -> Model:
    """The model with a document whose tasks have changed, its loci settled."""
    configuration = document.content.configuration
    boxes = model.shelf.boxes(document.content.names)
    placed = loci.settled(configuration, boxes, configuration)
    return model.with_document(document.having(replace(document.content, configuration=placed)))


def _placed(one: live.TaskStanding) -> Placed:
    filed = one.task.frequency
    changed = one.frequency is not None and one.frequency != filed
    return Placed(one.task.name, frequency=one.frequency or 0.0 if changed else 0.0, rtpu=one.rtpu)


def _configuration(model: Model, former: Configuration, found: Merge) -> Configuration:
    """What is placed afterwards, each at its place; newcomers stand to the right of all others."""
    stays = {one.task: one for one in (*found.update, *found.spawn)}
    placed = [stays.get(one.task, one) for one in former.placed if one.task not in found.remove]
    boxes = model.shelf.boxes(tuple(one.task for one in (*placed, *found.add)))
    x = max((one.x + _width(boxes, one.task) for one in placed), default=0) + _GAP
    top = y = min((one.y for one in placed), default=_GAP)
    column = 0
    for one in found.add:
        if y > top + _BELOW:
            x, y, column = x + column + _GAP, top, 0
        placed.append(replace(one, x=x, y=y))
        y += (boxes[one.task].height if one.task in boxes else _GAP) + _GAP
        column = max(column, _width(boxes, one.task))
    if tuple(placed) == former.placed:
        return former
    return loci.settled(replace(former, placed=tuple(placed)).regrouped(former.groups), boxes, former)


def _width(boxes: Mapping[str, object], name: str) -> int:
    return getattr(boxes.get(name), "width", 136)


def _with_strangers(model: Model, document: Document, known: Live, standing: live.Standing) -> Content:
    """With tasks that somebody else has brought to life, and without the wish for those that live no more."""
    content, there = document.content, alive(standing, known.subsystem)
    here = set(content.names)
    new = tuple(_placed(one) for name, one in there.items() if name not in here)
    wanted = {name: is_on for name, is_on in content.wanted.items() if name in here}
    wanted |= {one.task: there[one.task].state in ("ON", "ASKING") for one in new}
    configuration = content.configuration
    if new:
        configuration = _configuration(model, configuration, Merge({}, new, (), ()))
    if wanted == content.wanted and configuration is content.configuration:
        return content
    return Content(configuration, wanted)


def _says(document: Document, found: Merge, known: Live) -> list[page.Say]:
    """What connecting has done, one line for each thing."""
    said = [
        page.Say("warning", f"{name} leaves the canvas: {'; '.join(plain(one.reason) for one in why)}", document.id)
        for name, why in found.remove.items()
    ]
    if found.add:
        names = ", ".join(one.task for one in found.add)
        said.append(
            page.Say(
                "info",
                f"{names} {'runs' if len(found.add) == 1 else 'run'} already and came onto the canvas",
                document.id,
            )
        )
    if known.is_foreign:
        said.append(
            page.Say("warning", f"{known.subsystem} is held by {known.holder}: you can only watch", document.id)
        )
    return said
