"""What if? A fault is put to the runtime of this environment; nothing is touched, and nothing is begun (X24).

It is asked of what is there now, or of an application at its first step, which is prepared for that as before a run.
"""

from onika.desk.environment.outcome.on_file import closed
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure, Steps
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.runs import flow_placement
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.desk.plan.subsystem_renaming import rehoused
from onika.wire import act, foresight, request
from onika.wire.foresight import Effect, Foreseen, Foresight
from onika.wire.view import EffectView, ForesightsView, ForesightView
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
    if not isinstance(response, Foreseen):
        return No(refusal(response))
    beside = tuple(run.view.name for run in model.going) if is_planned else ()
    return Done(model, value=ForesightsView(tuple(_view(foreseen, beside) for foreseen in response.foresights)))


def _prepared(model: Model, opened: OpenApplication, outside: Services) -> Steps[tuple[Model, No | None]]:
    """Have the runtime prepare an application; no run is disturbed, and what could not run is not foreseen."""
    if any(run.view.state == "beginning" for run in model.going):  # its plan is the one that is prepared
        return model, No(Reason.of("run.foreseen_after_beginning", name=opened.name))
    if model.syntax is None:
        return model, No(Reason.of("run.no_icon_types"))
    prepared = ready(opened, outside.site, model.syntax)
    if prepared.plan is None:
        return model, No(Reason.of("run.not_foreseen", name=opened.name))
    taken = {home for run in model.going for home in run.homes}
    plan = rehoused(prepared.plan, flow_placement.free(model, prepared.plan, {*model.runtime.subsystems, *taken}))
    model, response = yield Ask(model, request.Prepare(plan, prepared.targets))
    if not isinstance(response, request.Prepared):
        return model, No(refusal(response))
    if response.faults:
        return model, No(Reason.of("run.not_foreseen", name=opened.name))
    return model, None


def _view(foreseen: Foresight, beside: tuple[str, ...]) -> ForesightView:
    """`beside` are the applications that run while another one is asked about."""
    effects = tuple(map(_effect, foreseen.effects))
    what = (foreseen.fault, foreseen.subject, foreseen.question)
    notes = (*foreseen.notes, Reason.of("run.foreseen_alone", beside=beside)) if beside else foreseen.notes
    return ForesightView(*what, foreseen.answer, effects, foreseen.to_do, notes)


def _effect(effect: Effect) -> EffectView:
    what = (effect.within_ms, effect.kind, effect.subject, effect.before, effect.after, effect.text)
    return EffectView(*what, is_told=bool(effect.told))
