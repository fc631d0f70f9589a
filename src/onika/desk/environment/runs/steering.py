"""Acts on the run of an application: steering, skips to a step, answers, breakpoints (E07, E13, E15)."""

from dataclasses import replace

from onika.desk.environment.canvas import task_commands
from onika.desk.environment.control import held_subsystems
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal, simply_done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile import run_reducer
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.run_state.run_view import standing
from onika.desk.environment.state.model import Model
from onika.desk.run import steering
from onika.wire import act, request, steer
from onika.wire.view import Remedy
from onika.words.reason import Reason, reason_of


def steer_line(model: Model, command: act.Steer, _outside: Services) -> Done | No | Procedure:
    """Do what a line of steering says, for the run that goes on."""
    run = _going(model)
    if isinstance(run, No):
        return run
    try:
        wish = steering.act(command.line, run.flow_index)
    except ValueError as wrong:
        return No(reason_of(wrong))
    if isinstance(wish, steering.PositionQuery):
        return _look(model)
    if not isinstance(wish, steering.SteeringOrder):
        return No(Reason.of("run.for_scripts", line=command.line))
    if isinstance(wish.message, request.Abort) and run.view.state == "beginning":
        return Done(replace(model, run=replace(run, is_given_up=True)))  # what is asked for already comes to its end
    if isinstance(wish.message, steer.Resume):
        is_named = len(command.line.split()) > 1
        has_nested = any(part.is_nested for part in run.flow_index.parts)
        return _resumed(model, wish.subsystem if is_named or not has_nested else "")  # empty: whoever rests
    return _steered(model, wish.message)


def skip_to(model: Model, command: act.SkipTo, _outside: Services) -> No | Procedure:
    """Send the flow of a step to it at once; to the first action of what runs an application, or of a branch."""
    run = _going(model)
    if isinstance(run, No):
        return run
    action_place = next(run.actions_of(command.step), None)
    if action_place is None:
        return No(Reason.of("run.not_begun_with"))
    flow, index = action_place
    return _steered(model, steer.Skip(run.homes[flow], index))


def answer(model: Model, command: act.Answer, outside: Services) -> No | Procedure:
    """Answer what a task of the run asks, named as `SUBSYSTEM/TASK`, or one of a configuration, or of a taken run."""
    if not command.doc:
        return held_subsystems.answer(model, command, outside)
    run = model.run
    if run is None or command.doc != run.doc:
        return task_commands.answer(model, command, outside)
    if command.task not in run.view.asks:
        return No(Reason.of("run.asks_nothing", task=command.task))
    subsystem, _, task = command.task.rpartition("/")
    return simply_done(model, request.Reply(subsystem, task, command.line))


def dismiss(model: Model, _asked: act.Dismiss, _outside: Services) -> Done | No:
    """Put away what is shown of a run that is over."""
    if model.run is not None and not model.run.is_over:
        abort = Remedy(Reason.of("run.abort_it"), act.Steer("abort"))
        return No(Reason.of("run.still_runs", name=model.run.view.name), (abort,))
    return Done(replace(model, run=None))


def _going(model: Model) -> Run | No:
    run = model.run
    if run is None or run.is_over:
        return No(Reason.of("run.nothing_runs"))
    return run


def _steered(model: Model, wish: request.Request) -> Procedure:
    """Ask for it, then where the flows are."""
    model, response = yield Ask(model, wish)
    if not isinstance(response, request.Done):
        return No(refusal(response))
    return Done(model, orders=(run_reducer.who(),) if _is_going(model) else ())


def _resumed(model: Model, whom: str) -> Procedure:
    """Those that pause go on; where none does, why the others stand, and what lets them go on."""
    model, response = yield Ask(model, steer.Resume(whom))
    if isinstance(response, request.Done):
        return Done(model, orders=(run_reducer.who(),) if _is_going(model) else ())
    stands = standing(model.run, whom) if model.run is not None else ()
    if not stands:
        return No(refusal(response))
    reason = Reason.of("run.nothing_pauses", parts=tuple(why for why, _ in stands))
    return No(reason, tuple(remedy for _, remedy in stands))


def _look(model: Model) -> Procedure:
    model, response = yield Ask(model, steer.Who())
    if isinstance(response, steer.Positions):
        return run_reducer.placed(model, response)
    return No(refusal(response))


def _is_going(model: Model) -> bool:
    return model.run is not None and not model.run.is_over
