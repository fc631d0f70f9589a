"""Acts about who may move the robots: stop, reset, take, release, hand over, decline, only watch (law 27)."""

from dataclasses import replace
from functools import partial

from onika.desk.environment.company import ask_company
from onika.desk.environment.living import simply_done
from onika.desk.environment.model import Model
from onika.desk.environment.on_document import closed
from onika.desk.environment.outcome import Done, No, Order
from onika.desk.environment.refusing import refusal
from onika.desk.environment.surroundings import Surroundings
from onika.wire import act, holding, live, request
from onika.wire.view import Remedy

_CAUSE = "Stop was pressed in the page"


def stop(model: Model, _asked: act.Stop, _outside: Surroundings) -> Done | No:
    """Every drive holds, at once, whoever holds what; where there is no runtime, the answer says so."""
    return Done(model, orders=(Order(request.Stop(_CAUSE), _stopped),), is_answered_later=True)


def reset(model: Model, _asked: act.Reset, _outside: Surroundings) -> Done | No:
    """Motion is allowed again; nothing comes on by itself."""
    return Done(model, orders=(Order(live.Reset(), simply_done),), is_answered_later=True)


def take(model: Model, asked: act.Take, _outside: Surroundings) -> Done | No:
    """Become the one who may change a document's subsystem."""
    return _hand(model, asked)


def release(model: Model, asked: act.Release, _outside: Surroundings) -> Done | No:
    """Let another become the one who may."""
    return _hand(model, asked)


def hand(model: Model, asked: act.Hand, _outside: Surroundings) -> Done | No:
    """Offer a document's subsystem to another session; to nobody: no more."""
    document = model.documents.get(asked.doc)
    if document is None:
        return closed()
    known = document.live
    if known is None or known.state != "live" or not known.is_held_here:
        take_it = (Remedy("Take it", act.Take(document.id)),) if known is not None and not known.holder else ()
        return No(f"{document.name} is not held here, so it cannot be handed over", take_it)
    order = Order(holding.Hand(known.subsystem, asked.to), simply_done, document.id)
    return Done(model, orders=(order,), is_answered_later=True)


def decline(model: Model, asked: act.Decline, _outside: Surroundings) -> Done | No:
    """Say no to what is offered."""
    document = model.documents.get(asked.doc)
    if document is None:
        return closed()
    if document.live is None or document.live.offer is None or not document.live.offer.is_here:
        return No(f"nobody offers {document.name} to this environment")
    order = Order(holding.Decline(document.live.subsystem), simply_done, document.id)
    return Done(model, orders=(order,), is_answered_later=True)


def only_watch(model: Model, _asked: act.OnlyWatch, _outside: Surroundings) -> Done | No:
    """This environment changes nothing in this runtime any more."""
    here = [one for one in model.documents.values() if one.live and one.live.is_held_here]
    if here:
        remedies = tuple(Remedy(f"Release {one.name}", act.Release(one.id)) for one in here)
        return No(f"{', '.join(one.name for one in here)} is held here; release it first", remedies)
    return Done(model, orders=(Order(holding.OnlyWatch(), _watches),), is_answered_later=True)


def _watches(model: Model, response: request.Response) -> Done | No:
    if not isinstance(response, request.Done):
        return No(refusal(response))
    return Done(model, orders=(ask_company(),), value="this environment only watches from now on")


def _hand(model: Model, asked: act.Take | act.Release) -> Done | No:
    document = model.documents.get(asked.doc)
    if document is None:
        return closed()
    known = document.live
    if known is None or known.state != "live":
        return No(f"{document.name} is not connected", (Remedy("Connect", act.Connect(document.id)),))
    order: request.Request = live.Take(known.subsystem)
    if isinstance(asked, act.Release):
        if known.is_foreign:
            return No(f"{known.subsystem} is held by {known.holder}")
        order = live.Release(known.subsystem)
    then = partial(_handed, doc=document.id, is_taken=isinstance(asked, act.Take))
    return Done(model, orders=(Order(order, then, document.id),), is_answered_later=True)


def _handed(model: Model, response: request.Response, doc: str, is_taken: bool) -> Done | No:
    if not isinstance(response, request.Done):
        return No(refusal(response))
    then = partial(_seen, doc=doc, is_taken=is_taken)
    return Done(model, orders=(Order(live.Survey(), then, doc),), is_answered_later=True)


def _seen(model: Model, response: request.Response, doc: str, is_taken: bool) -> Done | No:
    """Who holds it now; after it was taken, that is the name by which the runtime knows this environment."""
    document = model.documents.get(doc)
    known = document.live if document else None
    if document is None or known is None or not isinstance(response, live.Standing):
        return Done(model)
    holder = next((one.holder for one in response.subsystems if one.name == known.subsystem), "")
    known = replace(known, holder=holder, me=holder if is_taken else known.me)
    return Done(model.with_document(replace(document, live=known)))


def _stopped(model: Model, response: request.Response) -> Done | No:
    if isinstance(response, request.Done):
        return Done(model)
    return Done(model, value=f"there is nothing to stop: {refusal(response)}")
