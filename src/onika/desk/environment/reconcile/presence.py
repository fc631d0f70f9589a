"""Who else is connected with the runtime, and what holders offer to whom (requirement X12)."""

from collections.abc import Sequence
from dataclasses import replace

import msgspec

from onika.desk.environment.outcome.outcome import Ask, Done, No, Order, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile import holders as holds
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.state.live import Offer
from onika.desk.environment.state.model import Model
from onika.wire import act, event, holding, live, page, request, steer, view
from onika.wire.runtime_standing import Standing
from onika.words.reason import Reason


def look_around(model: Model, _asked: act.Company, _outside: Services) -> Procedure:
    """Ask anew who is there, who holds what, and where flows are."""
    if model.runtime.state != "linked":
        return No(Reason.of("run.nobody_else"))
    model, response = yield Ask(model, live.Survey(), orders=(ask_flows(), ask_company()))
    if isinstance(response, Standing):
        return surveyed(model, response)
    return No(refusal(response))


def ask_company() -> Order:
    """Ask who is there, and by which name this environment is known."""
    return Order(holding.Sessions(), _answered)


def ask_what() -> Order:
    """Ask what there is."""
    return Order(live.Survey(), surveyed)


def ask_flows() -> Order:
    """Ask where the flows of applications are."""
    return Order(steer.Who(), _placed)


def came(model: Model, message: event.Company) -> Done:
    """Somebody has come or gone."""
    return Done(_with_sessions(model, message.sessions, you(model)))


def offered(model: Model, message: event.Offered, at_s: float = 0.0) -> Done:
    """A holder offers something, or does so no more; those whom it is about are told."""
    me = you(model)
    model = replace(model, runtime=holds.offered(model.runtime, message, at_s))
    document = next(
        (
            document
            for document in model.documents_here.values()
            if document.live and document.live.subsystem == message.subsystem
        ),
        None,
    )
    says: tuple[page.Say, ...] = ()
    if me in (message.holder, message.to):
        reason = _words_of_offer_here(message) if message.to == me else _words_of_own_offer(message)
        says = (page.Say("info", reason, document.id if document else ""),)
    if document is None or document.live is None:
        return Done(model, says=says)
    offer = None if message.outcome else Offer(message.holder, message.to, message.to == me)
    return Done(model.with_document(replace(document, live=replace(document.live, offer=offer))), says=says)


def you(model: Model) -> str:
    """The name by which the runtime knows this environment; empty: it was not told yet."""
    return next((name for name, session in model.runtime.sessions.items() if session.is_you), "")


def surveyed(model: Model, response: request.Response) -> Done:
    """What there is now."""
    if not isinstance(response, Standing):
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
        session.name: view.SessionView(
            session.role, session.is_here, session.only_watches, session.name == me, session.lease_s
        )
        for session in sessions
    }
    return replace(model, runtime=msgspec.structs.replace(model.runtime, sessions=views))


def _is_accepted(message: event.Offered) -> bool:
    return isinstance(message.outcome, Reason) and message.outcome.key == "host.offer_accepted"


def _words_of_offer_here(message: event.Offered) -> Reason:
    subsystem, holder = message.subsystem, message.holder
    if _is_accepted(message):
        return Reason.of("run.handed_over", subsystem=subsystem, holder=holder)
    if message.outcome:
        return Reason.of("run.offer_ended", holder=holder, subsystem=subsystem, outcome=message.outcome)
    return Reason.of("run.offered_here", holder=holder, subsystem=subsystem)


def _words_of_own_offer(message: event.Offered) -> Reason:
    subsystem, to = message.subsystem, message.to
    if _is_accepted(message):
        return Reason.of("run.has_taken", to=to, subsystem=subsystem)
    if message.outcome:
        return Reason.of("run.offered_no_more", subsystem=subsystem, to=to, outcome=message.outcome)
    return Reason.of("run.offered_to", subsystem=subsystem, to=to)
