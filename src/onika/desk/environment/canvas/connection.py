"""Acts that connect a document with a runtime, and leave it again (requirements C12, C18)."""

from collections.abc import Set
from dataclasses import replace
from itertools import count

import msgspec

from onika.desk.environment.outcome.on_file import closed, on_document
from onika.desk.environment.outcome.outcome import Ask, Done, InterimModel, No, Procedure, RequiredRuntime, Steps
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.joining import connected
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.presence import ask_company
from onika.desk.environment.reconcile.station_names import station_at, station_name
from onika.desk.environment.reconcile.watched_runs import application_in
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts, WatchedRun
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.wire import act, live, request, view
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy, ShowConnect
from onika.words.name import TASK_NAME
from onika.words.reason import NOTHING, Reason

_MAIN = "main"


@on_document
def connect(model: Model, document: Document, command: act.Connect, _outside: Services) -> Procedure:
    """Merge a document with what runs in a subsystem, which comes into being with its first task."""
    if command.subsystem and not TASK_NAME.match(command.subsystem):
        text = Reason.of("desk.name_of_letters")
        return No(Reason.of("desk.no_subsystem_name", name=command.subsystem), fields={"subsystem": text})
    subsystem_facts = document.live
    if subsystem_facts is not None and subsystem_facts.state != "lost":
        again = Remedy(Reason.of("desk.disconnect_it"), act.Disconnect(document.id))
        place = subsystem_facts.subsystem or Reason.of("desk.its_runtime")
        return No(Reason.of("desk.connected_already", name=document.name, subsystem=place), (again,))
    wish = command.subsystem or (subsystem_facts.subsystem if subsystem_facts else "")
    there = _there(model, document, command)
    url = command.url or (there.runtime.address if subsystem_facts is not None or there.station else "")
    assigned = replace(document, live=SubsystemFacts(wish), watched=None, station=there.station)
    asking = there.with_document(assigned)
    if asking.runtime.state != "linked":
        asking = replace(asking, runtime=view.RuntimeView("starting", url))
    asking, outcome = yield from _joined(asking, document.id, wish, RequiredRuntime(url, command.token))
    if isinstance(outcome, Done | No):
        return outcome
    yield InterimModel(_as_before(asking, document, outcome, is_new=there.station not in model.stations))
    why = Reason.of("desk.not_connected_for", name=document.name, why=outcome)
    return No(why, (Remedy(Reason.of("desk.connect_to"), show=ShowConnect()),))


@on_document
def disconnect(model: Model, document: Document, command: act.Disconnect, _outside: Services) -> Done | No:
    """Leave what runs as it is; the layout stays, what was known of its tasks does not."""
    if document.live is None and document.watched is None and document.taken is None:
        return No(Reason.of("desk.not_connected", name=document.name))
    content = replace(document.content, wanted={}, kept=())
    return Done(model.with_document(replace(document, content=content, live=None, watched=None, taken=None)))


def _there(model: Model, document: Document, command: act.Connect) -> Model:
    """The model with the station in focus at which a document is to be turned on, known from now on.

    The first runtime that is connected at all is that of the first station, wherever it is.
    """
    if not command.url:
        return model.at(document.station if command.station is None else command.station)
    station = station_at(model, command.url)
    if station is None and model.runtime_at("").state == "none":
        station = ""
    if station is not None:
        return model.at(station)
    name = station_name(model, command.url)
    return model.at("").with_station(name, view.RuntimeView("starting", command.url)).at(name)


def _joined(model: Model, doc: str, wish: str, reach: RequiredRuntime) -> Steps[tuple[Model, Done | No | Reason]]:
    """Hold a subsystem, and merge the document with what runs in it; a sentence says why that cannot be."""
    model, standing = yield Ask(model, live.Survey(), reach)
    document = model.documents.get(doc)
    if document is None:
        return model, closed(DocumentKind.CONFIGURATION)
    if not isinstance(standing, Standing):
        return model, refusal(standing)
    model = replace(model, runtime=runtime_view(model.runtime, standing))
    name = wish or _subsystem(model, document, standing)
    application = application_in(standing, name)
    if application:
        return model, _watching(model, document, WatchedRun(name, application, model.station))
    reason = _occupied(model, name, document)
    if reason:
        return model, reason
    model, response = yield Ask(model.with_document(replace(document, live=SubsystemFacts(name))), live.Take(name))
    is_held = isinstance(response, request.Done)
    model, standing = yield Ask(model, live.Survey())
    document = model.documents.get(doc)
    if document is None or document.live is None:
        return model, closed(DocumentKind.CONFIGURATION)
    if not isinstance(standing, Standing):
        return model, refusal(standing)
    holders = [subsystem.holder for subsystem in standing.subsystems if subsystem.name == document.live.subsystem]
    done = connected(model, doc, standing, holders[0] if is_held and holders else "")
    return done.model, replace(done, orders=(*done.orders, ask_company()))


def _watching(model: Model, document: Document, watched: WatchedRun) -> Done:
    """A document that looks into a running application: nothing of it is asked of the runtime."""
    subsystem, application = watched.subsystem, watched.application
    content = replace(document.content, wanted={}, kept=())
    model = model.with_document(replace(document, content=content, live=None, watched=watched))
    return Done(model, value=Reason.of("desk.looks_into", subsystem=subsystem, application=application))


def _as_before(model: Model, former: Document, reason: Reason, *, is_new: bool) -> Model:
    """The model where a document could not be connected; a station that was new for it is none."""
    document = model.documents[former.id]
    before = replace(document, live=former.live, watched=former.watched, station=former.station)
    model = model.with_document(before)
    if model.runtime.state == "starting":
        model = replace(model, runtime=msgspec.structs.replace(model.runtime, state="lost", text=reason))
    station = model.station
    return model.at("").without_station(station).at(former.station) if is_new else model


def _subsystem(model: Model, document: Document, standing: Standing) -> str:
    """Of its own name, else the only one whose tasks are held by hand, else a new one."""
    used = {other.live.subsystem for other in model.documents_here.values() if other.live and other.id != document.id}
    free = [subsystem for subsystem in standing.subsystems if subsystem.name not in used and not subsystem.application]
    if any(subsystem_standing.name == document.name for subsystem_standing in free):
        return document.name
    if len(free) == 1 and free[0].tasks:
        return free[0].name
    applications = {subsystem.name for subsystem in standing.subsystems if subsystem.application}
    return _new_name(document.name, used | applications)


def _new_name(document: str, taken: Set[str]) -> str:
    """As the document is called, where that is a name of a subsystem; with a number where it is taken.

    Another document may be called otherwise by now than the subsystem it is connected with.
    """
    wished = document if TASK_NAME.match(document) else _MAIN
    if wished not in taken:
        return wished
    numbered = (f"{wished}-{number}" for number in count(2))
    return next(name for name in numbered if name not in taken)


def _occupied(model: Model, name: str, document: Document) -> Reason:
    """Why this subsystem is not for this document."""
    for other in model.documents_here.values():
        if other.live is not None and other.live.subsystem == name and other.id != document.id:
            return Reason.of("desk.subsystem_connected", name=other.name, subsystem=name)
    return NOTHING
