"""What if? A fault is put to the runtime of this environment; nothing is touched, and nothing is begun (X24).

It is asked of what is there now, or of an application at its first step, which is prepared for that as before a run.
"""

from onika.desk.environment.outcome.on_file import closed
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure, Steps
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.wire import act, foresight, request
from onika.wire.foresight import Effect, Foreseen, Foresight
from onika.wire.view import EffectView, ForesightsView, ForesightView, Remedy
from onika.words.reason import Reason


def what_if(model: Model, command: act.WhatIf, outside: Services) -> Procedure:
    """Reply with a `view.ForesightsView`."""
    is_planned = bool(command.doc)
    if is_planned:
        opened = model.applications.get(command.doc)
        if opened is None:
            return closed(DocumentKind.APPLICATION)
        model, why = yield from _prepared(model, opened, outside)
        if why is not None:
            return why
    asked = foresight.WhatIf(command.fault, command.subject, is_planned, command.on_loss, "wait")
    model, response = yield Ask(model, asked)
    if isinstance(response, Foreseen):
        return Done(model, value=ForesightsView(tuple(map(_view, response.foresights))))
    return No(refusal(response))


def _prepared(model: Model, opened: OpenApplication, outside: Services) -> Steps[tuple[Model, No | None]]:
    """Have the runtime prepare an application; a run is not disturbed, and what could not run is not foreseen."""
    why = _busy(model, opened.name)
    if why is not None:
        return model, why
    if model.syntax is None:
        return model, No(Reason.of("run.no_icon_types"))
    prepared = ready(opened, outside.site, model.syntax)
    if prepared.plan is None:
        return model, No(Reason.of("run.not_foreseen", name=opened.name))
    model, response = yield Ask(model, request.Prepare(prepared.plan, prepared.targets))
    if not isinstance(response, request.Prepared):
        return model, No(refusal(response))
    if response.faults:
        return model, No(Reason.of("run.not_foreseen", name=opened.name))
    return model, None


def _busy(model: Model, name: str) -> No | None:
    """What would follow is said of what is there now, and a run is there."""
    running = next(iter(model.going), None)
    if running is None:
        return None
    remedies = (Remedy(Reason.of("run.abort_it"), act.Steer("abort", running.doc)),)
    return No(Reason.of("run.is_checked_later", running=running.view.name, name=name), remedies)


def _view(foreseen: Foresight) -> ForesightView:
    effects = tuple(map(_effect, foreseen.effects))
    what = (foreseen.fault, foreseen.subject, foreseen.question)
    return ForesightView(*what, foreseen.answer, effects, foreseen.to_do, foreseen.notes)


def _effect(effect: Effect) -> EffectView:
    what = (effect.within_ms, effect.kind, effect.subject, effect.before, effect.after, effect.text)
    return EffectView(*what, is_told=bool(effect.told))
