"""Looking, before a run, at everything that could keep an application from it; nothing moves (requirement X02).

What is open is judged as it is shown; then the runtime looks at modules, argument lines, targets and devices, as it
does before each run. It is launched where there is none.
"""

from dataclasses import replace

from onika.desk.environment.outcome.fault_view import FaultViews
from onika.desk.environment.outcome.on_file import on_application
from onika.desk.environment.outcome.outcome import Ask, Done, InterimModel, No, Procedure, RequiredRuntime
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.unread_faults import not_run
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.runs import flow_placement
from onika.desk.environment.runs.begin import ready
from onika.desk.environment.runs.preflight_result import looked
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.run.runtime_conversation import in_short
from onika.wire import act, live, request
from onika.wire.plan import Plan
from onika.wire.request import TargetValues
from onika.wire.runtime_standing import Standing
from onika.wire.view import FaultView
from onika.words.reason import Reason


@on_application
def preflight(model: Model, opened: OpenApplication, _asked: act.Preflight, outside: Services) -> Done | No | Procedure:
    """Look at everything; replied with how many faults there are."""
    why = about_to_begin(model, opened.name) or not_run(opened)
    if why is not None:
        return why
    if model.syntax is None:
        return No(Reason.of("run.no_icon_types"))
    prepared = ready(opened, outside.site, model.syntax)
    troubles = FaultViews.of(opened, model.syntax, prepared, outside.site)
    views = tuple(troubles.views(prepared))
    if prepared.plan is None or not any(flow.tasks for flow in prepared.plan.flows):
        count = _count(views)
        if count:
            return Done(model, value=count)
        return No(Reason.of("run.has_nothing", name=opened.name))
    return _checked(model, opened, troubles, prepared.plan, prepared.targets, views)


def _checked(
    model: Model,
    opened: OpenApplication,
    troubles: FaultViews,
    plan: Plan,
    targets: tuple[TargetValues, ...],
    fault_views: tuple[FaultView, ...],
) -> Procedure:
    """Have the runtime look at it too; `found` was seen without one."""
    url = model.runtime.address
    state = model.runtime if model.runtime.state == "linked" else flow_placement.starting(model.runtime)
    model, standing = yield Ask(replace(model, runtime=state), live.Survey(), RequiredRuntime(url))
    if not isinstance(standing, Standing):
        why = refusal(standing)
        yield InterimModel(flow_placement.lost(model, why))
        return No(Reason.of("run.no_runtime", why=in_short(why)))
    model = replace(model, runtime=runtime_view(model.runtime, standing))
    at_work = about_to_begin(model, opened.name)  # somebody begins a run meanwhile
    if at_work is not None:
        yield InterimModel(model)
        return at_work
    model, response = yield Ask(model, request.Prepare(plan, targets))
    if not isinstance(response, request.Prepared):
        return No(Reason.of("run.cannot_be_checked", name=opened.name, why=refusal(response)))
    model = looked(model, troubles, plan, response)
    here = model.applications.get(opened.id)
    result = here.looked if here is not None else None
    return Done(model, value=_count((*fault_views, *(result.faults if result is not None else ()))))


def about_to_begin(model: Model, name: str) -> No | None:
    """While a run is about to begin, what the runtime has prepared is that; one that goes on minds nothing."""
    beginning = next((run for run in model.going if run.view.state == "beginning"), None)
    if beginning is None:
        return None
    return No(Reason.of("run.is_checked_soon", running=beginning.view.name, name=name))


def _count(fault_views: tuple[FaultView, ...]) -> int:
    """Each that keeps it from running, once."""
    return len({(fault_view.step, str(fault_view.text)) for fault_view in fault_views if fault_view.level == "fault"})
