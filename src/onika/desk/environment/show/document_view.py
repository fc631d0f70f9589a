"""How documents, libraries and tasks look to a page."""

from collections.abc import Mapping
from typing import TypeVar, cast

from msgspec import structs

from onika.desk.environment.show.wiring import MadeDocument, group_views, locus_views, placed_views
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.state.undo_order import label_of, redoable, undoable
from onika.model.parameter import default_words
from onika.model.task import Task
from onika.store.module_catalogue import merged
from onika.store.shipped import is_shipped
from onika.wire.sheet import ModuleSheet
from onika.wire.view import (
    DocumentView,
    KeptView,
    LibraryView,
    Objection,
    ParameterView,
    PinView,
    ProblemView,
    State,
    TaskView,
)

_V = TypeVar("_V")


def library_views(libraries: OpenLibraries, arrangements: Mapping[str, tuple[str, ...]]) -> dict[str, LibraryView]:
    """The open libraries, by their paths; those in which nothing is to be seen come last.

    arrangements    how tasks are arranged, by the paths of their folders
    """
    in_order = sorted(libraries.libraries, key=lambda library: not library.tasks and not library.faults)
    return {
        str(library.base.path): LibraryView(
            name=library.base.path.name,
            path=str(library.base.path),
            order=order,
            tasks=len(library.tasks),
            faults=tuple(fault.sentence for fault in library.faults),
            arranged=arrangements.get(str(library.base.path / "module"), ()),
            is_shipped=is_shipped(library.base.path),
        )
        for order, library in enumerate(in_order)
    }


def module_sentences(libraries: OpenLibraries) -> dict[str, dict[str, dict[str, str]]]:
    """What modules of the open libraries say in other languages."""
    return merged(library.catalogues for library in libraries.libraries)


def task_views(
    libraries: OpenLibraries, former: Mapping[str, TaskView], before: OpenLibraries | None
) -> dict[str, TaskView]:
    """Every task of the open libraries; what looks as it did in the libraries `before` is the same object."""
    views = {}
    is_near = before is not None and _is_near(libraries, before)
    for order, (name, task) in enumerate(libraries.tasks.items()):
        former_view = former.get(name)
        if former_view is not None and before is not None and is_near and _is_same(name, libraries, before):
            views[name] = former_view
            continue
        view = _task(name, task, order, libraries)
        views[name] = former_view if former_view is not None and former_view == view else view
    return views


def _is_near(libraries: OpenLibraries, before: OpenLibraries) -> bool:
    """Whether two shelves can differ in single tasks only."""
    return libraries.libraries is before.libraries and libraries.preferences is before.preferences


def _is_same(name: str, libraries: OpenLibraries, before: OpenLibraries) -> bool:
    """Whether there is nothing new to see of a task."""
    task = libraries.tasks[name]
    return (
        task is before.tasks[name]
        and libraries.rates.get(name) == before.rates.get(name)
        and libraries.sheets.get(task.module) is before.sheets.get(task.module)
    )


def _task(name: str, task: Task, order: int, libraries: OpenLibraries) -> TaskView:
    library, box = libraries.homes[name], libraries.box(name)
    filed = libraries.records[name].task
    sheet = libraries.sheets.get(task.module)
    ports = {port.name: port for port in sheet.ports} if sheet else {}
    code = libraries.code_file(name)
    pins = []
    for pin in box.pins if box else ():
        port = ports.get(pin.name)
        declared = (port.shape, port.unit, port.meaning) if port else ("", "", "")
        pins.append(PinView(pin.name, pin.svar, pin.kind.value, pin.y, *declared))
    return TaskView(
        name=name,
        module=task.module,
        library=str(library.base.path),
        order=order,
        description=task.description,
        width=box.width if box else 0,
        height=box.height if box else 0,
        pins=tuple(pins),
        type=task.type.value,
        hz=libraries.rates.get(name, task.frequency),
        file_hz=filed.frequency,
        object_type=task.object_type or "",
        is_trigger=bool(sheet.trigger) if sheet else task.object_type is not None,
        local=tuple((line.key, line.words) for line in task.local),
        parameters=_parameters(task, sheet),
        is_changed=name in libraries.edits,
        path=str(libraries.task_file(name)),
        code=str(code) if code else "",
    )


def _parameters(task: Task, sheet: ModuleSheet | None) -> tuple[ParameterView, ...]:
    """The parameters of a task: those that its module declares, then other lines of its LOCAL block."""
    lines = {line.key: line.words for line in task.local}
    declared = {local.name: local for local in sheet.locals} if sheet else {}
    views = [
        ParameterView(
            name,
            lines.get(name, default_words(local)),
            local.shape,
            local.unit,
            local.meaning,
            local.low,
            local.high,
            default_words(local),
        )
        for name, local in declared.items()
    ]
    return (*views, *(ParameterView(name, words) for name, words in lines.items() if name not in declared))


def document_view(
    document: Document,
    order: int,
    model: Model,
    greyed: dict[str, tuple[Objection, ...]],
    objected: dict[str, tuple[Objection, ...]],
    troubles: dict[str, ProblemView],
    seen: MadeDocument | None,
) -> DocumentView:
    """A document; parts that look as they did are the same objects."""
    libraries = model.libraries_of(document)
    old = seen.view if seen else DocumentView("", 0)
    view = DocumentView(
        name=document.name,
        order=order,
        path=str(document.opened.path) if document.opened else "",
        base=str(document.base or ""),
        is_dirty=document.is_dirty,
        is_moved=document.is_moved,
        has_changed_on_disk=document.has_changed_on_disk,
        undo=label_of(undoable(model, document)),
        redo=label_of(redoable(model, document)),
        tasks=placed_views(document, libraries, seen),
        loci=locus_views(document, libraries, seen),
        groups=group_views(document, seen),
        kept=_kept(_kept_views(document), old.kept),
        own=_kept(_own(document, order, libraries), old.own),
        greyed=greyed,
        objections=_kept({name: why for name, why in objected.items() if name not in greyed}, old.objections),
        problems=_kept(troubles, old.problems),
        station=document.station,
        taken_by=document.taken.application if document.taken is not None else "",
    )
    if document.watched is not None:
        application, has_ended = document.watched.application, document.live is None
        view = structs.replace(view, application=application, has_ended=has_ended, subsystem=document.watched.subsystem)
    return _with_subsystem(view, document.live)


def _kept_views(document: Document) -> dict[str, KeptView]:
    """The configurations that are kept alive, with what is known of their tasks."""
    facts = document.live.tasks if document.live is not None else {}
    return {
        kept.name: KeptView(
            order,
            {name: cast("State", facts[name].state if name in facts else "") for name in kept.names},
            str(kept.opened.path) if kept.opened else "",
            kept.is_unsaved,
        )
        for order, kept in enumerate(document.content.kept)
    }


def _own(document: Document, order: int, libraries: OpenLibraries) -> dict[str, TaskView]:
    """The tasks that are otherwise here than in the library, as they are here."""
    tasks = libraries.tasks
    return {
        placed.task: structs.replace(
            _task(placed.task, tasks[placed.task], order, libraries),
            file=placed.file,
            is_changed=tasks[placed.task] != libraries.filed(placed.task),
        )
        for placed in document.content.configuration.otherwise
        if placed.task in tasks
    }


def _with_subsystem(view: DocumentView, live: SubsystemFacts | None) -> DocumentView:
    """With the subsystem that the document is connected with, who holds it, and to whom it is offered."""
    if live is None:
        return view
    held = structs.replace(
        view,
        connection=live.state,
        subsystem=live.subsystem,
        holder=live.holder,
        is_held_here=live.is_held_here,
        black_box=live.black_box,
        recording=live.recording,
    )
    if live.offer is None:
        return held
    offer = live.offer
    return structs.replace(held, offered_by=offer.holder, offered_to=offer.to, is_offered_here=offer.is_here)


def _kept(new: dict[str, _V], old: dict[str, _V]) -> dict[str, _V]:
    """The same objects for what is equal, and the same map where everything is."""
    same = {key: old[key] if old.get(key) == value else value for key, value in new.items()}
    if len(same) == len(old) and all(old.get(key) is value for key, value in same.items()):
        return old
    return same
