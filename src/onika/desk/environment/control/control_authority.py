"""Acts about who may move the robots: stop, reset, take, release, hand over, decline (law 27, requirement X12)."""

from dataclasses import replace
from functools import partial

from onika.desk.environment.control import held_subsystems
from onika.desk.environment.outcome.outcome import Ask, Done, No, Order, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal, simply_done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.presence import ask_flows
from onika.desk.environment.reconcile.station_names import called
from onika.desk.environment.state.model import Model
from onika.wire import act, holding, live, page, request
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.reason import Reason


def stop(model: Model, _asked: act.Stop, _outside: Services) -> Procedure:
    """Every drive of every station holds, at once, whoever holds what; where there is no runtime, the answer says so.

    All are asked in the same moment. One of which nothing is heard is named in the answer, and not waited for.
    """
    linked = [name for name, runtime in model.every_station.items() if runtime.state == "linked"]
    cut = tuple(called(name) for name in linked if model.runtime_at(name).is_cut)
    heard = [name for name in linked if not model.runtime_at(name).is_cut]
    first = next(iter((*heard, *linked)), "")
    wish = request.Stop(Reason.of("run.stop_pressed"))
    others = tuple(Order(wish, partial(_stopped_at, name=name), station=name) for name in linked if name != first)
    model, response = yield Ask(model.at(first), wish, orders=others)
    if not isinstance(response, request.Done):
        return Done(model, value=Reason.of("run.nothing_to_stop", why=refusal(response)))
    if not cut:
        return Done(model)
    unheard = Reason.of("run.stop_unheard", stations=cut)
    return Done(model, value=unheard, says=(page.Say("warning", unheard),))


def _stopped_at(model: Model, response: request.Response, name: str) -> Done:
    """What one of several stations has answered to Stop."""
    if isinstance(response, request.Done):
        return Done(model)
    why = Reason.of("run.stop_unanswered", station=called(name), why=refusal(response))
    return Done(model, says=(page.Say("error", why),))


def reset(model: Model, command: act.Reset, _outside: Services) -> Procedure:
    """Motion is allowed again, here or at all stations where it is not; nothing comes on by itself."""
    stopped = [name for name, runtime in model.every_station.items() if runtime.is_stopped]
    if not command.is_everywhere or not stopped:
        return simply_done(model, live.Reset())
    first, *others = stopped
    orders = tuple(Order(live.Reset(), partial(_allowed_at, name=name), station=name) for name in others)
    return _reset(model.at(first), orders)


def _reset(model: Model, others: tuple[Order, ...]) -> Procedure:
    model, response = yield Ask(model, live.Reset(), orders=others)
    return Done(model) if isinstance(response, request.Done) else No(refusal(response))


def _allowed_at(model: Model, response: request.Response, name: str) -> Done:
    if isinstance(response, request.Done):
        return Done(model)
    why = Reason.of("run.not_allowed_at", station=called(name), why=refusal(response))
    return Done(model, says=(page.Say("error", why),))


def add_unit(model: Model, command: act.AddUnit, _outside: Services) -> Procedure:
    """One more processing unit, or a lost one anew; every page learns it by the event that tells it is up."""
    return simply_done(model, live.AddUnit(command.name))


def take(model: Model, command: act.Take, _outside: Services) -> No | Procedure:
    """Become the one who may change a subsystem; a run that is nobody's is taken as a whole."""
    name = held_subsystems.named(model, command.doc, command.subsystem, connects=True)
    if isinstance(name, No):
        return name
    why = held_subsystems.refused(model, name, command)
    if why is None:
        return _changed(model, live.Take(name), name)
    return why


def release(model: Model, command: act.Release, _outside: Services) -> No | Procedure:
    """Let another become the one who may."""
    name = held_subsystems.named(model, command.doc, command.subsystem, connects=True)
    if isinstance(name, No):
        return name
    holder = held_subsystems.holder(model, name)
    if holder and not held_subsystems.is_held_here(model, name):
        return No(Reason.of("run.held_by", name=name, holder=holder))
    return _changed(model, live.Release(name), name)


def hand(model: Model, command: act.Hand, _outside: Services) -> No | Procedure:
    """Offer a subsystem to another session; to nobody: no more."""
    name = held_subsystems.named(model, command.doc, command.subsystem)
    if isinstance(name, No):
        return name
    if not held_subsystems.is_held_here(model, name):
        is_free = bool(name) and not held_subsystems.holder(model, name)
        take_it = Remedy(Reason.of("desk.take_it"), act.Take(command.doc, command.subsystem))
        what = held_subsystems.called(model, command.doc, name)
        return No(Reason.of("run.not_held_here", name=what), (take_it,) if is_free else ())
    return simply_done(model, holding.Hand(name, command.to))


def decline(model: Model, command: act.Decline, _outside: Services) -> No | Procedure:
    """Say no to what is offered."""
    name = held_subsystems.named(model, command.doc, command.subsystem)
    if isinstance(name, No):
        return name
    if not held_subsystems.is_offered_here(model, name):
        what = held_subsystems.called(model, command.doc, name)
        return No(Reason.of("run.not_offered", name=what))
    return simply_done(model, holding.Decline(name))


def _changed(model: Model, wish: live.Take | live.Release, name: str) -> Procedure:
    """Ask for it, then who holds it.

    After it was taken, the holder is the name by which the runtime knows this environment.
    """
    model, response = yield Ask(model, wish)
    if not isinstance(response, request.Done):
        is_taken = isinstance(wish, live.Take) and held_subsystems.is_taken_run(model, name)
        return Done(model) if is_taken else No(refusal(response))  # two pages may take it at once
    model, standing = yield Ask(model, live.Survey(), orders=(ask_flows(),))
    if not isinstance(standing, Standing):
        return Done(model)
    model = replace(model, runtime=runtime_view(model.runtime, standing))
    document = held_subsystems.home(model, name)
    if document is None or document.live is None:
        return Done(model)
    holder = next((subsystem.holder for subsystem in standing.subsystems if subsystem.name == name), "")
    me = holder if isinstance(wish, live.Take) else document.live.me
    return Done(model.with_document(replace(document, live=replace(document.live, holder=holder, me=me))))
