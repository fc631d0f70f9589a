"""Marks on the steps of an application whose joint targets another robot takes by way of their poses (E09, law 26)."""

from dataclasses import replace

from onika.desk.environment.outcome.fault_view import FaultViews
from onika.desk.environment.state.model import Model
from onika.wire.plan import Plan
from onika.wire.request import Prepared
from onika.words.reason import Reason


def marked(model: Model, troubles: FaultViews, plan: Plan, prepared: Prepared) -> Model:
    """With the marks of what was looked at; `plan` has the numbers of its steps as lines."""
    opened = model.applications.get(troubles.doc)
    if opened is None:
        return model
    marks: dict[int, tuple[Reason, ...]] = {}
    for resolved in prepared.resolved:
        spot = plan.flows[resolved.flow].actions[resolved.action].spot
        if spot:
            new, old = resolved.task, resolved.instead_of
            reason = Reason.of("run.target_resolved_here", target=resolved.target, new=new, old=old)
            step = troubles.target_of(spot[0], resolved.target) if len(spot) == 1 else spot[0]
            marks[step] = tuple(dict.fromkeys((*marks.get(step, ()), reason)))
    said = {step: Reason.of("run.together", parts=reasons) for step, reasons in marks.items()}
    if said == opened.marks:
        return model
    return model.with_application(replace(opened, marks=said))
