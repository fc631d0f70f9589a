"""The promise only to watch: given for as long as a session lasts, and ended by coming anew (requirement X12)."""

from dataclasses import replace

from msgspec import structs

from onika.desk.environment.control.held_subsystems import is_held_here
from onika.desk.environment.outcome.outcome import Ask, Done, InterimModel, No, Procedure, RequiredRuntime
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.live_facts import with_standing
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.presence import ask_company, ask_flows
from onika.desk.environment.reconcile.runtime_loss import lost
from onika.desk.environment.state.model import Model
from onika.wire import act, holding, live, request
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.reason import Reason


def only_watch(model: Model, _asked: act.OnlyWatch, _outside: Services) -> Procedure:
    """This environment changes nothing in this runtime any more."""
    held = _held_here(model)
    if held is not None:
        return held
    model, response = yield Ask(model, holding.OnlyWatch())
    if not isinstance(response, request.Done):
        return No(refusal(response))
    return Done(model, orders=(ask_company(),), value=Reason.of("run.only_watches_now"))


def _held_here(model: Model) -> No | None:
    """Why that cannot be promised now: what is held here is to be released first; None: nothing is."""
    here = [document for document in model.documents_here.values() if document.live and document.live.is_held_here]
    homes = {document.live.subsystem for document in here if document.live}
    others = [name for name in model.runtime.holds if name not in homes and is_held_here(model, name)]
    if not here and not others:
        return None
    by_document = [_release(document.name, act.Release(document.id)) for document in here]
    by_hand = [name for name in others if not model.runtime.holds[name].application]
    by_subsystem = [_release(name, act.Release(subsystem=name)) for name in by_hand]
    names = (*(document.name for document in here), *others)
    return No(Reason.of("run.held_here_first", names=names), (*by_document, *by_subsystem))


def _release(name: str, release: act.Release) -> Remedy:
    """The button that lets others have it."""
    return Remedy(Reason.of("run.release", name=name), release)


def watch_no_more(model: Model, _asked: act.WatchNoMore, _outside: Services) -> Procedure:
    """This environment leaves and comes anew, under another name; what runs is left as it is."""
    me = next((session for session in model.runtime.sessions.values() if session.is_you), None)
    if me is None or not me.only_watches:
        return No(Reason.of("run.no_promise"))
    if not model.runtime.address:
        again = Remedy(Reason.of("run.start_runtime_anew"), act.StartAnew())
        return No(Reason.of("run.promise_ends_anew"), (again,))
    model, response = yield Ask(model, live.Survey(), RequiredRuntime(model.runtime.address, is_anew=True))
    if not isinstance(response, Standing):
        why = refusal(response)
        done = lost(model, why)
        yield InterimModel(done.model, says=done.says, orders=done.orders, news=done.news)
        return No(Reason.of("run.not_reached_anew", why=why))
    model = replace(model, runtime=runtime_view(structs.replace(model.runtime, sessions={}), response))
    for document in model.documents_here.values():
        if document.live is not None and document.live.state == "live":
            subsystem_facts = with_standing(replace(document.live, me="", offer=None), response)
            model = model.with_document(replace(document, live=subsystem_facts))
    return Done(model, value=Reason.of("run.may_change_again"), orders=(ask_company(), ask_flows()))
