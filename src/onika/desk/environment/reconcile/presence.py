"""Who else is connected with the runtime, and what holders offer to whom (requirement X12)."""

from collections.abc import Sequence
from dataclasses import replace

import msgspec

from onika.desk.environment.outcome.outcome import Ask, Done, No, Order, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.reconcile import holders as holds
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.state.live import Offer
from onika.desk.environment.state.model import Model
from onika.wire import act, event, holding, live, page, request, steer, view


def look_around(model: Model, _asked: act.Company, _outside: Surroundings) -> Procedure:
    """Ask anew who is there, who holds what, and where flows are."""
    if model.runtime.state != "linked":
        return No("there is no runtime yet, so nobody else is there")
    model, response = yield Ask(model, live.Survey(), orders=(ask_flows(), ask_company()))
    return surveyed(model, response) if isinstance(response, live.Standing) else No(refusal(response))


def ask_company() -> Order:
    """Ask who is there, and by which name this environment is known."""
    return Order(holding.Sessions(), _answered)


def ask_what() -> Order:
    """Ask what there is."""
    return Order(live.Survey(), surveyed)


def ask_flows() -> Order:
    """Ask where the flows of applications are."""
    return Order(steer.Who(), _placed)


def came(model: Model, told: event.Company) -> Done:
    """Somebody has come or gone."""
    return Done(_with_sessions(model, told.sessions, you(model)))


def offered(model: Model, told: event.Offered, at_s: float = 0.0) -> Done:
    """A holder offers something, or does so no more; those whom it is about are told."""
    me = you(model)
    model = replace(model, runtime=holds.offered(model.runtime, told, at_s))
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


def surveyed(model: Model, response: request.Response) -> Done:
    """What there is now."""
    if not isinstance(response, live.Standing):
        return Done(model)
    return Done(replace(model, runtime=runtime_view(model.runtime, response)))


def _placed(model: Model, response: request.Response) -> Done:
    if not isinstance(response, steer.Positions):
        return Done(model)
    return Done(replace(model, runtime=holds.placed(model.runtime, response)))


def _answered(model: Model, response: request.Response) -> Done:
    if not isinstance(response, holding.Company):
        return Done(model)
    return Done(_with_sessions(model, response.sessions, response.you))


def _with_sessions(model: Model, sessions: Sequence[holding.SessionStanding], me: str) -> Model:
    views = {
        one.name: view.SessionView(one.role, one.is_here, one.only_watches, one.name == me, one.lease_s)
        for one in sessions
    }
    return replace(model, runtime=msgspec.structs.replace(model.runtime, sessions=views))


def _words(told: event.Offered, me: str) -> str:
    is_accepted = told.outcome == "accepted"
    if told.to == me:
        if is_accepted:
            return f"{told.subsystem} is held here now: {told.holder} has handed it over"
        text = f"{told.holder} offers {told.subsystem}: take it, or decline"
        return f"{told.holder} offers {told.subsystem} no more: {told.outcome}" if told.outcome else text
    if is_accepted:
        return f"{told.to} has taken {told.subsystem}"
    if told.outcome:
        return f"{told.subsystem} is no longer offered to {told.to}: {told.outcome}"
    return f"{told.subsystem} is offered to {told.to}"
