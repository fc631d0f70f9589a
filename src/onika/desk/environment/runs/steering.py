"""Acts on the run of an application: steering, skips to a step, answers, breakpoints (E07, E13, E15)."""

from collections.abc import Sequence
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.canvas import task_commands
from onika.desk.environment.control import held_subsystems
from onika.desk.environment.outcome.outcome import Ask, Done, No, Order, Procedure, Steps
from onika.desk.environment.outcome.runtime_refusal import refusal, simply_done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile import run_reducer
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.run_state.run_view import standing
from onika.desk.environment.runs.run_start import aborts
from onika.desk.environment.state.model import Model
from onika.desk.run import steering
from onika.wire import act, request, steer
from onika.wire.view import Remedy
from onika.words.reason import Reason, reason_of


def steer_line(model: Model, command: act.Steer, _outside: Services) -> Done | No | Procedure:
    """Do what a line of steering says, for a run that goes on."""
    run = _going(model, command.doc)
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
    if run.view.state == "beginning":  # what is asked for already comes to its end first
        if isinstance(wish.message, request.Abort):
            return Done(model.with_run(replace(run, is_given_up=True)))
        if isinstance(wish.message, steer.Pause | steer.Resume):
            return Done(model.with_run(replace(run, is_to_pause=isinstance(wish.message, steer.Pause))))
    if isinstance(wish.message, steer.Resume):
        is_named = len(command.line.split()) > 1
        has_nested = any(part.is_nested for part in run.flow_index.parts)
        return _resumed(model, run, wish.subsystem if is_named or not has_nested else "")  # empty: whoever rests
    return _steered(model, run, addressed(model, run, wish.message))


def skip_to(model: Model, command: act.SkipTo, _outside: Services) -> No | Procedure:
    """Send the flow of a step to it at once; to the first action of what runs an application, or of a branch."""
    run = _going(model, command.doc)
    if isinstance(run, No):
        return run
    action_place = next(run.actions_of(command.step), None)
    if action_place is None:
        return No(Reason.of("run.not_begun_with"))
    flow, index = action_place
    return _steered(model, run, (steer.Skip(run.homes[flow], index),))


def answer(model: Model, command: act.Answer, outside: Services) -> No | Procedure:
    """Answer what a task of the run asks, named as `SUBSYSTEM/TASK`, or one of a configuration, or of a taken run."""
    if not command.doc:
        return held_subsystems.answer(model, command, outside)
    run = model.run_of(command.doc)
    if run is None:
        return task_commands.answer(model, command, outside)
    if command.task not in run.view.asks:
        return No(Reason.of("run.asks_nothing", task=command.task))
    subsystem, _, task = command.task.rpartition("/")
    return simply_done(model.at(run.station_of(subsystem)), request.Reply(subsystem, task, command.line))


def dismiss(model: Model, command: act.Dismiss, _outside: Services) -> Done | No:
    """Put away what is shown of a run that is over."""
    run = model.run_of(command.doc) if command.doc else model.run
    if run is None:
        return Done(model)
    if not run.is_over:
        abort = Remedy(Reason.of("run.abort_it"), act.Steer("abort", run.doc))
        return No(Reason.of("run.still_runs", name=run.view.name), (abort,))
    return Done(model.without_run(run))


def addressed(model: Model, run: Run, wish: request.Request) -> tuple[request.Request, ...]:
    """What is wished of a whole run as it is asked where others run beside it: flow by flow, so that none is meant too.

    An abort names one flow, and ends the run of which that is.
    """
    is_for_all = isinstance(wish, _OF_ALL) and not wish.subsystem
    if (len(model.going) < 2 and not run.parts) or not is_for_all:
        return (wish,)
    if isinstance(wish, request.Abort):
        return tuple(structs.replace(wish, subsystem=abort.subsystem) for abort in aborts(run))
    return tuple(structs.replace(wish, subsystem=home) for home in run.homes)


_OF_ALL = (steer.Pause, steer.Resume, steer.Step, steer.Recover, request.Abort)
"""What is wished of every flow where none is named."""


def _going(model: Model, doc: str) -> Run | No:
    """The run of an application that goes on; where none is named, the one that was begun last."""
    going = [run for run in model.going if doc in ("", run.doc)]
    return going[0] if going else No(Reason.of("run.nothing_runs"))


def _asked(model: Model, run: Run, wishes: Sequence[request.Request]) -> Steps[tuple[Model, request.Response]]:
    """Ask for each where its flow is; done where one of them is, else why the first is not."""
    responses = []
    for wish in wishes:
        subsystem = getattr(wish, "subsystem", "") or run.homes[0]
        model, response = yield Ask(model.at(run.station_of(subsystem)), wish)
        responses.append(response)
    return model, next((response for response in responses if isinstance(response, request.Done)), responses[0])


def _steered(model: Model, run: Run, wishes: Sequence[request.Request]) -> Procedure:
    """Ask for it, then where the flows are."""
    model, response = yield from _asked(model, run, wishes)
    if not isinstance(response, request.Done):
        return No(refusal(response))
    return Done(model, orders=_who(model, run))


def _who(model: Model, run: Run) -> tuple[Order, ...]:
    """Ask each station of a run where its flows are."""
    stations = dict.fromkeys(run.station_of(home) for home in run.homes)
    return tuple(run_reducer.who().at(station) for station in stations) if model.going else ()


def _resumed(model: Model, run: Run, whom: str) -> Procedure:
    """Those that pause go on; where none does, why the others stand, and what lets them go on."""
    model, response = yield from _asked(model, run, addressed(model, run, steer.Resume(whom)))
    if isinstance(response, request.Done):
        return Done(model, orders=_who(model, run))
    now = model.run_of(run.doc)
    stands = standing(now, whom) if now is not None else ()
    if not stands:
        return No(refusal(response))
    reason = Reason.of("run.nothing_pauses", parts=tuple(why for why, _ in stands))
    return No(reason, tuple(remedy for _, remedy in stands))


def _look(model: Model) -> Procedure:
    model, response = yield Ask(model, steer.Who())
    if isinstance(response, steer.Positions):
        return run_reducer.placed(model, response)
    return No(refusal(response))
