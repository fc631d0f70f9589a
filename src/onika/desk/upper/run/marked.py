"""Marks on the steps of an application whose joint targets another robot takes by way of their poses (E09, law 26)."""

from dataclasses import replace

from onika.desk.environment.model import Model
from onika.wire.plan import Plan
from onika.wire.request import Prepared


def marked(model: Model, doc: str, plan: Plan, prepared: Prepared) -> Model:
    """With the marks of a run that is about to begin; `plan` has the numbers of its steps as lines."""
    opened = model.applications.get(doc)
    if opened is None:
        return model
    marks: dict[int, str] = {}
    for one in prepared.resolved:
        spot = plan.flows[one.flow].actions[one.action].spot
        if spot:
            words = f"{one.target} is re-resolved for {one.task}, by the pose that it is for {one.instead_of}"
            marks[spot[0]] = "; ".join(dict.fromkeys((*filter(None, [marks.get(spot[0])]), words)))
    return model if marks == opened.marks else model.with_application(replace(opened, marks=marks))
