"""A document beside what runs: connecting merges the two, looking again takes the facts over (C12, Equation (1))."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice
from pathlib import Path

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.reconcile import holders
from onika.desk.environment.reconcile.live_facts import alive, settled, with_standing
from onika.desk.environment.reconcile.world_kinds import kinds
from onika.desk.environment.run_state import subsystem_views
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.configuration import Configuration, Placed
from onika.model.own_lines import NO_OWN_LINES, OwnLines
from onika.model.planned import task_of
from onika.model.rules import loci
from onika.model.rules.merge import Merge, merge
from onika.wire import live, page, request, view
from onika.wire.runtime_standing import Standing, TaskStanding
from onika.words.reason import NOTHING, Reason

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


def merged(model: Model, document: Document, subsystem_facts: SubsystemFacts, standing: Standing) -> Merged:
    """Equation (1) with (4): what runs wins, what runs and is not placed comes onto the canvas, the rest is spawned.

    So are tasks of configurations that are kept alive (C32).
    """
    there = alive(standing, subsystem_facts.subsystem)
    content = document.content
    resting = set(content.union) - set(content.names)
    running = tuple(
        _placed(task_standing, model.libraries) for name, task_standing in there.items() if name not in resting
    )
    living = {name: task_of(task_standing.task) for name, task_standing in there.items()}
    tasks = {**model.libraries_of(document).tasks, **living}
    merged_tasks = merge(content.configuration.placed, running, tasks)
    configuration = _configuration(model, content.configuration, merged_tasks)
    wanted = {
        name: task_standing.is_wanted_on or task_standing.state in ("ON", "ASKING")
        for name, task_standing in there.items()
    }
    message = replace(with_standing(subsystem_facts, standing), state="live", turns={}, pending={}, early={})
    kept = (name for name in content.union if name in resting and name not in there)
    spawn = () if message.is_foreign else (*(placed.task for placed in merged_tasks.spawn), *kept)
    document = replace(document, content=Content(configuration, wanted, content.kept), live=message)
    return Merged(document, spawn, tuple(_says(document, merged_tasks, message)))


def look_again(doc: str) -> Order:
    """Ask what there is, and take the facts over."""
    return Order(live.Survey(), partial(seen, doc=doc))


def seen(model: Model, response: request.Response, doc: str) -> Done:
    """What there is now: facts of tasks, and tasks that somebody else has brought to life."""
    if not isinstance(response, Standing):
        return Done(model)
    model = replace(model, runtime=runtime_view(model.runtime, response))
    document = model.documents.get(doc)
    subsystem_facts = document.live if document else None
    if document is None or subsystem_facts is None or subsystem_facts.state != "live":
        return Done(model)
    message = with_standing(subsystem_facts, response)
    document = replace(document, live=message)
    if not message.pending:
        document = settled(document.having(_with_strangers(model, document, message, response)))
    return Done(model.with_document(document))


_MOST_OFFERED = 20
"""So many libraries of one runtime are shown; what it says is not to be trusted."""
_LONGEST_ADDRESS = 500


def _offered(libraries: tuple[str, ...]) -> tuple[str, ...]:
    short = (address for address in dict.fromkeys(libraries) if 0 < len(address) <= _LONGEST_ADDRESS)
    return tuple(islice(short, _MOST_OFFERED))


def runtime_view(former: view.RuntimeView, standing: Standing) -> view.RuntimeView:
    """The runtime as it stands."""
    return view.RuntimeView(
        state="linked",
        address=former.address,
        is_cut=former.is_cut,
        round_trip_ms=former.round_trip_ms,
        is_virtual=standing.is_virtual,
        is_stopped=standing.is_stopped,
        stop_text=former.stop_text if standing.is_stopped else NOTHING,
        units={
            rtpu_standing.name: view.UnitView(round(rtpu_standing.load, 2), rtpu_standing.is_lost)
            for rtpu_standing in standing.rtpus
        },
        worlds=dict.fromkeys(standing.worlds, True),
        world_kinds={**former.world_kinds, **kinds({name: name in standing.simulated for name in standing.worlds})},
        outdated={name: why for name, why in former.outdated.items() if name in standing.worlds},
        displaced=_elsewhere(standing, is_harmless=False),
        moved=_elsewhere(standing, is_harmless=True),
        pressed={name: parts for name, parts in former.pressed.items() if name in standing.worlds},
        subsystems={subsystem.name: subsystem.application or subsystem.holder for subsystem in standing.subsystems},
        holds=holders.surveyed(former.holds, standing),
        sessions=former.sessions,
        inside=subsystem_views.surveyed(former.inside, standing),
        libraries=_offered(standing.libraries),
        book=former.book,
        slot_ends=former.slot_ends,
        clock_set_s=former.clock_set_s,
    )


def _elsewhere(standing: Standing, *, is_harmless: bool) -> dict[str, tuple[Reason, ...]]:
    """In words what is elsewhere in each world, as far as that does harm, or none."""
    worlds = {
        world: tuple(displacement.text for displacement in displaced if displacement.is_harmless is is_harmless)
        for world, displaced in standing.displaced.items()
    }
    return {world: reasons for world, reasons in worlds.items() if reasons}


def with_loci(model: Model, document: Document) -> Model:
    """The model with a document whose tasks have changed, its loci settled."""
    configuration = document.content.configuration
    boxes = model.libraries_of(document).boxes(document.content.names)
    placed = loci.settled(configuration, boxes, configuration)
    return model.with_document(document.having(replace(document.content, configuration=placed)))


def _placed(standing: TaskStanding, libraries: OpenLibraries) -> Placed:
    """A task that lives, as it would be placed: what it has otherwise than its file is of the configuration."""
    planned = standing.task
    changed = standing.frequency is not None and standing.frequency != planned.frequency
    file = Path(planned.place).stem
    filed = libraries.tasks.get(file)
    is_of_file = filed is not None and filed.module == planned.module
    own = OwnLines.between(filed, task_of(planned)) if filed is not None and is_of_file else NO_OWN_LINES
    return Placed(
        planned.name,
        frequency=standing.frequency or 0.0 if changed else 0.0,
        rtpu=standing.rtpu,
        own=own,
        rmod=file if is_of_file and file != planned.name else "",
    )


def _configuration(model: Model, former: Configuration, merged_tasks: Merge) -> Configuration:
    """What is placed afterwards, each at its place; newcomers stand to the right of all others."""
    stays = {placed.task: placed for placed in (*merged_tasks.update, *merged_tasks.spawn)}
    placed = [stays.get(placed.task, placed) for placed in former.placed if placed.task not in merged_tasks.remove]
    both = tuple(placed) + merged_tasks.add
    boxes = model.libraries.within(replace(former, placed=both)).boxes(tuple(placed.task for placed in both))
    x = max((placed.x + _width(boxes, placed.task) for placed in placed), default=0) + _GAP
    top = y = min((placed.y for placed in placed), default=_GAP)
    column = 0
    for newcomer in merged_tasks.add:
        if y > top + _BELOW:
            x, y, column = x + column + _GAP, top, 0
        placed.append(replace(newcomer, x=x, y=y))
        y += (boxes[newcomer.task].height if newcomer.task in boxes else _GAP) + _GAP
        column = max(column, _width(boxes, newcomer.task))
    if tuple(placed) == former.placed:
        return former
    return loci.settled(replace(former, placed=tuple(placed)).regrouped(former.groups), boxes, former)


def _width(boxes: Mapping[str, object], name: str) -> int:
    return getattr(boxes.get(name), "width", 136)


def _with_strangers(model: Model, document: Document, subsystem_facts: SubsystemFacts, standing: Standing) -> Content:
    """With tasks that somebody else has brought to life, and without the wish for those that live no more."""
    content, there = document.content, alive(standing, subsystem_facts.subsystem)
    here = set(content.union)
    new = tuple(_placed(task_standing, model.libraries) for name, task_standing in there.items() if name not in here)
    wanted = {name: is_on for name, is_on in content.wanted.items() if name in here}
    wanted |= {placed.task: there[placed.task].state in ("ON", "ASKING") for placed in new}
    configuration = content.configuration
    if new:
        configuration = _configuration(model, configuration, Merge({}, new, (), ()))
    if wanted == content.wanted and configuration is content.configuration:
        return content
    return replace(content, configuration=configuration, wanted=wanted)


def _says(document: Document, merged_tasks: Merge, subsystem_facts: SubsystemFacts) -> list[page.Say]:
    """What connecting has done, one line for each thing."""
    messages = []
    for name, refusals in merged_tasks.remove.items():
        reasons = tuple(refusal.reason for refusal in refusals)
        reason = Reason.of("run.leaves_canvas", name=name, reasons=reasons)
        messages.append(page.Say("warning", reason, document.id))
    if merged_tasks.add:
        names = tuple(placed.task for placed in merged_tasks.add)
        messages.append(page.Say("info", Reason.of("run.run_already", names=names), document.id))
    if subsystem_facts.is_foreign:
        name, holder = subsystem_facts.subsystem, subsystem_facts.holder
        messages.append(page.Say("warning", Reason.of("run.only_watch", name=name, holder=holder), document.id))
    return messages
