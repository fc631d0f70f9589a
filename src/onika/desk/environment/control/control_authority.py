"""Acts about who may move the robots: stop, reset, take, release, hand over, decline (law 27, requirement X12)."""

from dataclasses import replace
from functools import partial

from onika.desk.environment.canvas.task_commands import simply_done
from onika.desk.environment.control import held_subsystems
from onika.desk.environment.outcome.outcome import Done, No, Order
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.presence import ask_flows
from onika.desk.environment.state.model import Model
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
    """Become the one who may change a subsystem; a run that is nobody's is taken as a whole."""
    name = held_subsystems.named(model, asked.doc, asked.subsystem, connects=True)
    if isinstance(name, No):
        return name
    why = held_subsystems.refused(model, name, asked)
    return _asked(model, live.Take(name), name, is_taken=True) if why is None else why


def release(model: Model, asked: act.Release, _outside: Surroundings) -> Done | No:
    """Let another become the one who may."""
    name = held_subsystems.named(model, asked.doc, asked.subsystem, connects=True)
    if isinstance(name, No):
        return name
    holder = held_subsystems.holder(model, name)
    if holder and not held_subsystems.is_held_here(model, name):
        return No(f"{name} is held by {holder}")
    return _asked(model, live.Release(name), name, is_taken=False)


def hand(model: Model, asked: act.Hand, _outside: Surroundings) -> Done | No:
    """Offer a subsystem to another session; to nobody: no more."""
    name = held_subsystems.named(model, asked.doc, asked.subsystem)
    if isinstance(name, No):
        return name
    if not held_subsystems.is_held_here(model, name):
        is_free = bool(name) and not held_subsystems.holder(model, name)
        take_it = (Remedy("Take it", act.Take(asked.doc, asked.subsystem)),) if is_free else ()
        what = held_subsystems.called(model, asked.doc, name)
        return No(f"{what} is not held here, so it cannot be handed over", take_it)
    return Done(model, orders=(Order(holding.Hand(name, asked.to), simply_done, asked.doc),), is_answered_later=True)


def decline(model: Model, asked: act.Decline, _outside: Surroundings) -> Done | No:
    """Say no to what is offered."""
    name = held_subsystems.named(model, asked.doc, asked.subsystem)
    if isinstance(name, No):
        return name
    if not held_subsystems.is_offered_here(model, name):
        return No(f"nobody offers {held_subsystems.called(model, asked.doc, name)} to this environment")
    return Done(model, orders=(Order(holding.Decline(name), simply_done, asked.doc),), is_answered_later=True)


def _asked(model: Model, asked: live.Take | live.Release, name: str, is_taken: bool) -> Done:
    document = held_subsystems.home(model, name)
    doc = document.id if document is not None else ""
    then = partial(_handed, name=name, is_taken=is_taken)
    return Done(model, orders=(Order(asked, then, doc),), is_answered_later=True)


def _handed(model: Model, response: request.Response, name: str, is_taken: bool) -> Done | No:
    if not isinstance(response, request.Done):
        return No(refusal(response))
    document = held_subsystems.home(model, name)
    then = partial(_seen, name=name, is_taken=is_taken)
    order = Order(live.Survey(), then, document.id if document is not None else "")
    return Done(model, orders=(order, ask_flows()), is_answered_later=True)


def _seen(model: Model, response: request.Response, name: str, is_taken: bool) -> Done | No:
    """Who holds it now; after it was taken, that is the name by which the runtime knows this environment."""
    if not isinstance(response, live.Standing):
        return Done(model)
    model = replace(model, runtime=runtime_view(model.runtime, response))
    document = held_subsystems.home(model, name)
    if document is None or document.live is None:
        return Done(model)
    holder = next((one.holder for one in response.subsystems if one.name == name), "")
    known = replace(document.live, holder=holder, me=holder if is_taken else document.live.me)
    return Done(model.with_document(replace(document, live=known)))


def _stopped(model: Model, response: request.Response) -> Done | No:
    if isinstance(response, request.Done):
        return Done(model)
    return Done(model, value=f"there is nothing to stop: {refusal(response)}")
