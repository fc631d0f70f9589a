"""Putting the workcell back: everything stands where it stood at the start, in the same runtime (law 18)."""

from dataclasses import replace

from msgspec import structs

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure, Steps
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.runs import restart
from onika.desk.environment.state.model import Model
from onika.desk.plan.flow_worlds import worlds_by_flow
from onika.wire import act, live, page, request
from onika.wire.plan import Plan
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.reason import Reason


def put_back(model: Model, _asked: act.PutBack, outside: Services) -> Procedure:
    """Put back what can be; of what nobody here can move, say what a person has to put where."""
    runtime = model.runtime
    if runtime.state == "lost" and not runtime.address:
        return (yield from restart.start_anew(model, act.StartAnew(), outside))
    if runtime.state != "linked":
        return No(Reason.of("run.nothing_to_put_back"))
    model, response = yield Ask(model, live.PutBack())
    if not isinstance(response, live.WorldsPutBack):
        return _refused(model, response)
    model, standing = yield Ask(model, live.Survey())
    if isinstance(standing, Standing):
        model = replace(model, runtime=runtime_view(model.runtime, standing))
    by_hand = tuple(response.by_hand.values())
    if by_hand and not response.worlds:
        return No(Reason.of("run.together", parts=by_hand))
    says = (page.Say("info", Reason.of("run.workcell_is_back")), *(page.Say("warning", why) for why in by_hand))
    return Done(model, says=says)


def before_run(model: Model, plan: Plan, command: act.Run) -> Steps[tuple[Model, No | None]]:
    """Put back the worlds in which a run is about to begin; or why it does not begin."""
    worlds = dict.fromkeys(world for home in worlds_by_flow(plan).values() for world in home)
    open_worlds = tuple(world for world in worlds if world in model.runtime.worlds)
    if not open_worlds:
        return model, None
    model, response = yield Ask(model, live.PutBack(open_worlds))
    if not isinstance(response, live.WorldsPutBack):
        return model, _refused(model, response)
    if response.by_hand:
        as_it_stands = Remedy(Reason.of("run.run_as_it_stands"), structs.replace(command, puts_back=False))
        return model, No(Reason.of("run.together", parts=tuple(response.by_hand.values())), (as_it_stands,))
    return model, None


def _refused(model: Model, response: request.Response) -> No:
    """Something drives it; a runtime of ours can be ended with that."""
    anew = () if model.runtime.address else (Remedy(Reason.of("run.start_runtime_anew"), act.StartAnew()),)
    return No(refusal(response), anew)
