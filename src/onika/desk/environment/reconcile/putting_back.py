"""A configuration that a run has taken over is put back when that is over: its tasks live again (requirement C18).

What was ON comes ON again only where the run has done all its actions, or has never begun, and nothing was stopped
meanwhile; whatever has ended early leaves everything OFF. While all is stopped nothing comes to life: it is put back
when motion is allowed again.
"""

from collections.abc import Collection
from dataclasses import replace
from functools import partial

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.reconcile.joining import connected
from onika.desk.environment.reconcile.watched_runs import application_in
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts, TakenOver
from onika.desk.environment.state.model import Model
from onika.wire import event, live, page, request
from onika.wire.runtime_standing import Standing
from onika.words.reason import NOTHING, Reason


def after_event(model: Model, message: event.Event) -> Done:
    """The model after a piece of news; where a run is over, what it had taken over is put back."""
    match message:
        case event.Stopped():
            return due(_off(model, [run.view.number for run in model.runs_here]) if message.is_stopped else model)
        case event.Result():
            return due(_off(model, [run.view.number for run in model.runs_here if _has_ended_early(run)]))
    return Done(model)


def due(model: Model) -> Done:
    """Ask for everything that is to be put back now."""
    if model.runtime.is_stopped or model.runtime.state != "linked":
        return Done(model)
    orders = []
    for document, taken in _taken(model):
        if taken.is_asked or _goes_on(model, taken):
            continue
        if document.live is not None or document.watched is not None:  # its user does something else with it
            model = model.with_document(replace(document, taken=None))
            continue
        model = model.with_document(replace(document, taken=replace(taken, is_asked=True)))
        orders.append(Order(live.Take(taken.subsystem), partial(_held, doc=document.id, subsystem=taken.subsystem)))
    return Done(model, orders=tuple(orders))


def lost(model: Model) -> Done:
    """The runtime is gone: nothing is put back any more."""
    says = []
    for document, _ in _taken(model):
        model = model.with_document(replace(document, taken=None))
        says.append(_not_put_back(document, Reason.of("run.runtime_gone_with_it")))
    return Done(model, says=tuple(says))


def _taken(model: Model) -> list[tuple[Document, TakenOver]]:
    documents = model.documents_here.values()
    return [(document, document.taken) for document in documents if document.taken is not None]


def _goes_on(model: Model, taken: TakenOver) -> bool:
    """Whether the run that has taken it over is not over yet."""
    return any(run.view.number == taken.run for run in model.going)


def _has_ended_early(run: Run) -> bool:
    return run.is_over and not run.view.is_completed


def _off(model: Model, runs: Collection[int]) -> Model:
    """Nothing that these runs have taken over comes ON again."""
    for document, taken in _taken(model):
        if taken.run not in runs:
            continue
        model = model.with_document(replace(document, taken=replace(taken, on=frozenset())))
    return model


def _held(model: Model, response: request.Response, doc: str, subsystem: str) -> Done:
    """Its subsystem is held again; where somebody else has it, it is only looked at."""
    document = model.documents.get(doc)
    is_held = isinstance(response, request.Done)
    if document is not None and document.taken is not None:
        return Done(model, orders=(Order(live.Survey(), partial(_seen, doc=doc, is_held=is_held)),))
    is_in_use = any(other.live and other.live.subsystem == subsystem for other in model.documents_here.values())
    return Done(model, orders=() if is_in_use or not is_held else (Order(live.Release(subsystem)),))


def _seen(model: Model, response: request.Response, doc: str, is_held: bool) -> Done:
    """What there is now: the document joins it, unless its user has done something else with it meanwhile."""
    document = model.documents.get(doc)
    taken = document.taken if document is not None else None
    if document is None or taken is None:
        return Done(model)
    model = model.with_document(replace(document, taken=None))
    if document.live is not None or document.watched is not None:
        return Done(model)
    if not isinstance(response, Standing):
        return Done(model, says=(_not_put_back(document, Reason.of("run.runtime_gone_with_it")),))
    hindrance = _hindrance(model, taken.subsystem, response)
    if hindrance:
        return Done(model, says=(_not_put_back(document, hindrance),))
    holder = next((home.holder for home in response.subsystems if home.name == taken.subsystem), "")
    joins = model.with_document(replace(document, taken=None, live=SubsystemFacts(taken.subsystem)))
    done = connected(joins, doc, response, holder if is_held else "", taken.on)
    return replace(done, says=(*done.says, _put_back(done.model.documents[doc], taken)))


def _hindrance(model: Model, subsystem: str, standing: Standing) -> Reason:
    """Why its subsystem is not its own any more."""
    application = application_in(standing, subsystem)
    if application:
        return Reason.of("host.runs_in_already", application=application, subsystem=subsystem)
    for other in model.documents_here.values():
        if other.live is not None and other.live.subsystem == subsystem:
            return Reason.of("desk.subsystem_connected", name=other.name, subsystem=subsystem)
    return NOTHING


def _put_back(document: Document, taken: TakenOver) -> page.Say:
    wanted = document.content.wanted
    on = tuple(name for name in document.content.names if name in taken.on and wanted.get(name, False))
    if on:
        return page.Say("info", Reason.of("run.is_put_back_on", name=document.name, tasks=on), document.id)
    return page.Say("info", Reason.of("run.is_put_back", name=document.name), document.id)


def _not_put_back(document: Document, why: Reason) -> page.Say:
    return page.Say("warning", Reason.of("run.is_not_put_back", name=document.name, why=why), document.id)
