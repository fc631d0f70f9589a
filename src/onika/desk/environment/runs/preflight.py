"""Looking, before a run, at everything that could keep an application from it; nothing moves (requirement X02).

What is open is judged as it is shown; then the runtime looks at modules, argument lines, targets and devices, as it
does before each run. It is launched where there is none.
"""

from dataclasses import dataclass, replace
from functools import partial

from onika.desk.environment.outcome.fault_view import Troubles
from onika.desk.environment.outcome.on_application import on_application
from onika.desk.environment.outcome.outcome import Done, No, Order, Reach
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.outcome.unread_faults import not_run
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.runs import flow_placement
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.runs.preflight_result import looked
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.run.runtime import in_short
from onika.wire import act, live, request
from onika.wire.plan import Plan
from onika.wire.request import TargetValues
from onika.wire.view import FaultView, Remedy


@dataclass(frozen=True, slots=True)
class _Look:
    """A look on its way."""

    name: str
    troubles: Troubles
    plan: Plan
    targets: tuple[TargetValues, ...]
    found: tuple[FaultView, ...]
    """What was seen without a runtime."""


@on_application
def preflight(model: Model, opened: OpenApplication, asked: act.Preflight, outside: Surroundings) -> Done | No:
    """Look at everything; replied with how many faults there are."""
    busy = _busy(model, opened.name) or not_run(opened)
    if busy is not None:
        return busy
    if model.syntax is None:
        return No("there is no syntax definition that can be read: nothing is known of the types of icons")
    prepared = ready(opened, outside.site, model.syntax)
    troubles = Troubles.of(opened, model.syntax, prepared, outside.site)
    found = tuple(troubles.views(prepared))
    if prepared.plan is None or not any(flow.tasks for flow in prepared.plan.flows):
        return Done(model, value=_count(found)) if _count(found) else No(f"{opened.name} has nothing to run")
    look = _Look(opened.name, troubles, prepared.plan, prepared.targets, found)
    url = model.runtime.address
    state = model.runtime if model.runtime.state == "linked" else flow_placement.starting(model.runtime)
    order = Order(live.Survey(), partial(_surveyed, look=look), opened.id, Reach(url))
    return Done(replace(model, runtime=state), orders=(order,), is_answered_later=True)


def _surveyed(model: Model, response: request.Response, look: _Look) -> Done | No:
    if not isinstance(response, live.Standing):
        why = refusal(response)
        return No(f"no runtime: {in_short(why)}", instead=Done(flow_placement.lost(model, why)))
    model = replace(model, runtime=runtime_view(model.runtime, response))
    busy = _busy(model, look.name)  # somebody began a run meanwhile
    if busy is not None:
        return replace(busy, instead=Done(model))
    order = Order(request.Prepare(look.plan, look.targets), partial(_prepared, look=look), look.troubles.doc)
    return Done(model, orders=(order,), is_answered_later=True)


def _prepared(model: Model, response: request.Response, look: _Look) -> Done | No:
    if not isinstance(response, request.Prepared):
        return No(f"{look.name} cannot be checked: {refusal(response)}")
    model = looked(model, look.troubles, look.plan, response)
    opened = model.applications.get(look.troubles.doc)
    one = opened.looked if opened is not None else None
    return Done(model, value=_count((*look.found, *(one.faults if one is not None else ()))))


def _busy(model: Model, name: str) -> No | None:
    """A run is not disturbed."""
    if model.run is None or model.run.is_over:
        return None
    remedies = (Remedy("Abort it", act.Steer("abort")),)
    return No(f"{model.run.view.name} runs: {name} is checked when that has ended", remedies)


def _count(found: tuple[FaultView, ...]) -> int:
    """Each that keeps it from running, once."""
    return len({(one.step, one.text) for one in found if one.level == "fault"})
