"""Marks on the steps of an application whose joint targets another robot takes by way of their poses (E09, law 26)."""

from dataclasses import replace

from onika.desk.environment.outcome.fault_view import Troubles
from onika.desk.environment.state.model import Model
from onika.wire.plan import Plan
from onika.wire.request import Prepared


def marked(model: Model, troubles: Troubles, plan: Plan, prepared: Prepared) -> Model:
    """With the marks of what was looked at; `plan` has the numbers of its steps as lines."""
    opened = model.applications.get(troubles.doc)
    if opened is None:
        return model
    marks: dict[int, str] = {}
    for resolved in prepared.resolved:
        spot = plan.flows[resolved.flow].actions[resolved.action].spot
        if spot:
            new, old = resolved.task, resolved.instead_of
            words = f"{resolved.target} is re-resolved for {new}, by the pose that it is for {old}"
            step = troubles.target_of(spot[0], resolved.target) if len(spot) == 1 else spot[0]
            marks[step] = "; ".join(dict.fromkeys((*filter(None, [marks.get(step)]), words)))
    return model if marks == opened.marks else model.with_application(replace(opened, marks=marks))
