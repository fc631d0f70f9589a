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
from onika.wire.view import Remedy
from onika.words.reason import Reason


def only_watch(model: Model, _asked: act.OnlyWatch, _outside: Services) -> Procedure:
    """This environment changes nothing in this runtime any more."""
    here = [document for document in model.documents.values() if document.live and document.live.is_held_here]
    homes = {document.live.subsystem for document in here if document.live}
    others = [name for name in model.runtime.holds if name not in homes and is_held_here(model, name)]
    if here or others:
        by_document = tuple(Remedy(f"Release {document.name}", act.Release(document.id)) for document in here)
        by_hand = [name for name in others if not model.runtime.holds[name].application]
        remedies = (*by_document, *(Remedy(f"Release {name}", act.Release(subsystem=name)) for name in by_hand))
        names = ", ".join((*(document.name for document in here), *others))
        return No(f"{names} is held here; release it first", remedies)
    model, response = yield Ask(model, holding.OnlyWatch())
    if not isinstance(response, request.Done):
        return No(refusal(response))
    return Done(model, orders=(ask_company(),), value="this environment only watches from now on")


def watch_no_more(model: Model, _asked: act.WatchNoMore, _outside: Services) -> Procedure:
    """This environment leaves and comes anew, under another name; what runs is left as it is."""
    me = next((session for session in model.runtime.sessions.values() if session.is_you), None)
    if me is None or not me.only_watches:
        return No("this environment has not promised that it only watches")
    if not model.runtime.address:
        again = Remedy("Start the runtime anew…", act.StartAnew())
        return No("the runtime was started here, and the promise ends with it", (again,))
    model, response = yield Ask(model, live.Survey(), RequiredRuntime(model.runtime.address, is_anew=True))
    if not isinstance(response, live.Standing):
        why = refusal(response)
        done = lost(model, why)
        yield InterimModel(done.model, says=done.says, orders=done.orders, news=done.news)
        return No(Reason.of("run.not_reached_anew", why=why))
    model = replace(model, runtime=runtime_view(structs.replace(model.runtime, sessions={}), response))
    for document in model.documents.values():
        if document.live is not None and document.live.state == "live":
            subsystem_facts = with_standing(replace(document.live, me="", offer=None), response)
            model = model.with_document(replace(document, live=subsystem_facts))
    return Done(model, value="this environment may change something again", orders=(ask_company(), ask_flows()))
