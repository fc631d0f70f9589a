"""A run that begins where the last one of its application ended before its time, perhaps redirected (decision 76)."""

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.model import Model
from onika.desk.plan import begin_places
from onika.wire import act
from onika.wire.plan import Plan, PlannedFlow
from onika.words.reason import Reason


def placed(model: Model, command: act.Run, name: str, plan: Plan) -> Plan | No:
    """The plan, with its flows where those of the last run ended, where that is wanted; or why not."""
    if not command.goes_on:
        return plan
    former = model.run
    if former is None or former.doc != command.doc or not former.is_over or former.view.is_completed:
        return No(Reason.of("run.goes_on_not_there", name=name))
    if former.parts:
        return No(Reason.of("run.goes_on_apart", name=name))
    if tuple(map(_shape, former.plan.flows)) != tuple(map(_shape, plan.flows)):
        return No(Reason.of("run.goes_on_changed", name=name))
    places = begin_places.places(plan, former.ends, former.plan)
    return No(places) if isinstance(places, Reason) else begin_places.begun_at(plan, places)


def _shape(flow: PlannedFlow) -> tuple[object, ...]:
    """What has to be the same, so that the numbers of its actions mean the same."""
    return flow.parent, tuple(action.name for action in flow.actions)
