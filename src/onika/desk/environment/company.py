"""Who else is connected with the runtime, and what holders offer to whom (requirement X12)."""

from collections.abc import Sequence
from dataclasses import replace

import msgspec

from onika.desk.environment.live import Offer
from onika.desk.environment.model import Model
from onika.desk.environment.outcome import Done, No, Order
from onika.wire import event, holding, page, request, view


def ask_company() -> Order:
    """Ask who is there, and by which name this environment is known."""
    return Order(holding.Sessions(), _answered, is_aside=True)


def came(model: Model, told: event.Company) -> Done:
    """Somebody has come or gone."""
    return Done(_with_sessions(model, told.sessions, you(model)))


def offered(model: Model, told: event.Offered) -> Done:
    """A holder offers something, or does so no more; those whom it is about are told."""
    me = you(model)
    document = next(
        (one for one in model.documents.values() if one.live and one.live.subsystem == told.subsystem), None
    )
    says = (
        (page.Say("info", _words(told, me), document.id if document else ""),) if me in (told.holder, told.to) else ()
    )
    if document is None or document.live is None:
        return Done(model, says=says)
    offer = None if told.outcome else Offer(told.holder, told.to, told.to == me)
    return Done(model.with_document(replace(document, live=replace(document.live, offer=offer))), says=says)


def you(model: Model) -> str:
    """The name by which the runtime knows this environment; empty: it was not told yet."""
    return next((name for name, one in model.runtime.sessions.items() if one.is_you), "")


def _answered(model: Model, response: request.Response) -> Done | No:
    if not isinstance(response, holding.Company):
        return Done(model)
    return Done(_with_sessions(model, response.sessions, response.you))


def _with_sessions(model: Model, sessions: Sequence[holding.SessionStanding], me: str) -> Model:
    views = {one.name: view.SessionView(one.role, one.is_here, one.only_watches, one.name == me) for one in sessions}
    return replace(model, runtime=msgspec.structs.replace(model.runtime, sessions=views))


def _words(told: event.Offered, me: str) -> str:
    if told.to == me:
        text = f"{told.holder} offers {told.subsystem}: take it, or decline"
        return f"{told.holder} offers {told.subsystem} no more: {told.outcome}" if told.outcome else text
    text = f"{told.subsystem} is offered to {told.to}"
    return f"{text}: {told.outcome}" if told.outcome else text
