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
    elsewhere = _elsewhere(model, command)
    if elsewhere:
        return elsewhere
    wish = command.subsystem or (subsystem_facts.subsystem if subsystem_facts else "")
    url = command.url or (
        model.runtime.address if subsystem_facts is not None else ""
    )  # a lost one is looked for where it was
    former = document.watched
    model = model.with_document(replace(document, live=SubsystemFacts(wish), watched=None))
    if model.runtime.state != "linked" or url not in ("", model.runtime.address):
        model = replace(model, runtime=view.RuntimeView("starting", url))
    model, outcome = yield from _joined(model, document.id, wish, RequiredRuntime(url, command.token))
    if not isinstance(outcome, Done | No):
        yield InterimModel(_as_before(model, document.id, subsystem_facts, former, outcome))
        name = model.documents[document.id].name
        return No(
            Reason.of("desk.not_connected_for", name=name, why=outcome),
            (Remedy(Reason.of("desk.connect_to"), show=ShowConnect()),),
        )
    return outcome


@on_document
def disconnect(model: Model, document: Document, command: act.Disconnect, _outside: Services) -> Done | No:
    """Leave what runs as it is; the layout stays, what was known of its tasks does not."""
    if document.live is None and document.watched is None and document.taken is None:
        return No(Reason.of("desk.not_connected", name=document.name))
    content = replace(document.content, wanted={}, kept=())
    return Done(model.with_document(replace(document, content=content, live=None, watched=None, taken=None)))


def _elsewhere(model: Model, command: act.Connect) -> No | None:
    """Why another runtime cannot be reached now: there is one at a time."""
    if not command.url or command.url == model.runtime.address or model.runtime.state != "linked":
        return None
    users = [
        document for document in model.documents.values() if document.live is not None and document.live.state == "live"
    ]
    here = model.runtime.address or Reason.of("desk.runtime_here")
    if model.going:
        abort = Remedy(Reason.of("desk.abort_it"), act.Steer("abort", model.going[0].doc))
        return No(Reason.of("desk.application_on_runtime"), (abort,))
    if users:
        remedies = tuple(
            Remedy(Reason.of("desk.disconnect_file", name=user.name), act.Disconnect(user.id)) for user in users
        )
        return No(Reason.of("desk.one_runtime", name=users[0].name, here=here), remedies)
    left = tuple(model.runtime.subsystems)
    if not left or command.confirmed:
        return None
    meant = msgspec.structs.replace(command, confirmed=True)
    ends, rests = "desk.runtime_left_ends", "desk.runtime_left_rests"
    reason = Reason.of(rests if model.runtime.address else ends, here=here, subsystems=left)
    return No(reason, (Remedy(Reason.of("desk.go_on"), meant),))


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
        return model, _watching(model, document, WatchedRun(name, application))
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


def _as_before(
    model: Model, doc: str, former: SubsystemFacts | None, watched: WatchedRun | None, reason: Reason
) -> Model:
    """The model where a document could not be connected."""
    model = model.with_document(replace(model.documents[doc], live=former, watched=watched))
    if model.runtime.state == "starting":
        model = replace(model, runtime=msgspec.structs.replace(model.runtime, state="lost", text=reason))
    return model


def _subsystem(model: Model, document: Document, standing: Standing) -> str:
    """Of its own name, else the only one whose tasks are held by hand, else a new one."""
    used = {other.live.subsystem for other in model.documents.values() if other.live and other.id != document.id}
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
    for other in model.documents.values():
        if other.live is not None and other.live.subsystem == name and other.id != document.id:
            return Reason.of("desk.subsystem_connected", name=other.name, subsystem=name)
    return NOTHING
