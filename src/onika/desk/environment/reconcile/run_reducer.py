"""What a runtime tells of the run of an application: what is shown follows, and what is worth a line is said."""

from dataclasses import replace
from functools import partial

from msgspec import structs

from onika.desk.environment.outcome.outcome import Done, EditEnd, No, Order, RunEnd
from onika.desk.environment.reconcile.current_values import measured, values_of
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.run_state import flow_progress, halted_arm, run_parts, run_view
from onika.desk.environment.run_state.recording_size import with_recording_size
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.state.model import Model
from onika.desk.run.runtime_conversation import black_box_in
from onika.wire import event, live, page, request, steer
from onika.wire.runtime_standing import Standing
from onika.wire.view import ShowStep
from onika.words.reason import Reason


def after_event(model: Model, message: event.Event) -> Done:
    """The model after a piece of news, as far as it is about the run."""
    run = meant(model, message)
    if run is None or run.is_over:
        return Done(model)
    if isinstance(message, event.Edited) and run.view.state == "beginning":
        return _edited(model, run, message)
    former, (run, told) = run, run_parts.of_whole(run, message, model.station)
    if told is None:  # the end of a part
        return Done(model.with_run(run))
    now, message = flow_progress.after(run, told), told
    if now is former:
        return Done(model)
    if isinstance(message, event.Result):
        now = with_recording_size(now)
    return Done(
        model.with_run(now),
        orders=_orders(model, run, now, message),
        says=_says(now, message, is_held=model.runtime.is_stopped),
        news=((RunEnd(now.view.number), None),) if now.is_over else (),
    )


def lost(model: Model, reason: Reason) -> Done:
    """The runtime is gone: the run is reported aborted (E10); one that had not begun is refused to who wanted it."""
    done = Done(model)
    for run in model.going_here:
        ended = _lost(done.model, run, reason)
        done = Done(ended.model, says=(*done.says, *ended.says), news=(*done.news, *ended.news))
    return done


def _lost(model: Model, run: Run, reason: Reason) -> Done:
    if run.view.state == "beginning":
        news = () if run.awaits is None else ((EditEnd(run.awaits, run.station), No(reason)),)
        return Done(model.with_run(replace(run, awaits=None)), news=news)
    cause = Reason.of("run.lost_runtime", why=reason)
    if run.parts:
        return part_lost(model, run, cause)
    now = with_recording_size(flow_progress.lost(run, cause, black_box_in(reason)))
    return Done(model.with_run(now), says=(end(now),), news=((RunEnd(now.view.number), None),))


def part_lost(model: Model, run: Run, cause: Reason) -> Done:
    """What a station carries out of a run is not heard of any more; the rest goes on to its end."""
    if run_parts.is_ended_at(run, model.station):
        return Done(model)
    nothing = event.Result(False, cause, 0, 0, 0.0, 0.0, {}, (), "")
    run, result = run_parts.ended(run, model.station, nothing)
    if result is None:
        reason = Reason.of("run.what_why", what=model.station or Reason.of("desk.station_here"), why=cause)
        return Done(model.with_run(run.noted(reason)))
    now = flow_progress.over(run, result)
    return Done(model.with_run(now), says=(end(now),), news=((RunEnd(now.view.number), None),))


def meant(model: Model, message: event.Event) -> Run | None:
    """The run that a piece of news is about; what names none is about the one that was begun last."""
    named: str = getattr(message, "run", "") or getattr(message, "subsystem", "")
    if isinstance(message, event.Met) and message.subsystems:
        named = message.subsystems[0]
    if isinstance(message, event.Drive):
        return next((run for run in model.going_here if halted_arm.claims(run, message.device)), None)
    if not named or isinstance(message, event.Edited):
        return next(iter(model.runs_here), None)
    return model.run_in(named)


def who() -> Order:
    """Ask where the flows are: whether they will pause, and which loops they are in."""
    return Order(steer.Who(), placed)


def look() -> Order:
    """Ask what there is: worlds are opened by a run, and subsystems come and go with it."""
    return Order(live.Survey(), _surveyed)


def _edited(model: Model, run: Run, message: event.Edited) -> Done:
    """A live change has come to its end while the run is about to begin; it may be what the run waits for."""
    if run.awaits != message.number:
        return Done(model.with_run(replace(run, outcomes={**run.outcomes, message.number: message.cause})))
    news = ((EditEnd(message.number, model.station), No(message.cause) if message.cause else None),)
    return Done(model.with_run(replace(run, awaits=None)), news=news)


def _orders(model: Model, former: Run, run: Run, message: event.Event) -> tuple[Order, ...]:
    match message:
        case event.Began():
            is_first = not former.view.steps
            return (*((look(),) if is_first else ()), *((who(),) if run.has_loops(message.flow) else ()))
        case event.Asked():
            return _ask_present(model, run, message)
        case event.Result():
            return (look(),)
    return ()


def _says(run: Run, message: event.Event, *, is_held: bool) -> tuple[page.Say, ...]:
    doc = run.doc
    match message:
        case event.Explained() if message.choices and not is_held:  # an end is told with the result, a stop by the stop
            where = run.step_at(message.subsystem, message.index)
            who_ = "/".join(part for part in (message.subsystem, message.task) if part)
            reason = Reason.of("run.what_why", what=who_, why=message.text) if who_ else message.text
            text = run.wording.with_icons(reason)
            return (page.Say("error", text, doc, ShowStep(where) if where else None, is_quiet=True),)
        case event.Warned() | event.Stepped():
            return (page.Say("warning", run.view.notes[-1], doc, None, is_quiet=True),)
        case event.Result():
            return (end(run),)
    return ()


def end(run: Run) -> page.Say:
    """How a run has ended, in words."""
    view = run.view
    if view.is_completed:
        reason = Reason.of("run.done", name=view.name, done=view.done, took_s=view.took_s)
        return page.Say("success", reason, run.doc)
    reason = Reason.of("run.aborted_after", name=view.name, done=view.done, cause=view.cause)
    return page.Say("error", reason, run.doc)


def _ask_present(model: Model, run: Run, message: event.Asked) -> tuple[Order, ...]:
    """Where the arm stands, as a possible answer."""
    moving = [address.partition("/")[2] for address in run.on if address.startswith(f"{message.subsystem}/")]
    wanted = measured(model.libraries, message.task, moving)
    if not wanted:
        return ()
    then = partial(_present, key=f"{message.subsystem}/{message.task}", wanted=wanted)
    return (Order(live.Read(message.subsystem, tuple(dict.fromkeys(wanted.values()))), then),)


def _present(model: Model, response: request.Response, key: str, wanted: dict[str, str]) -> Done:
    run = model.run_in(key.partition("/")[0])
    if run is None or key not in run.view.asks or not isinstance(response, live.Values):
        return Done(model)
    ask_view = structs.replace(run.view.asks[key], present=values_of(response, wanted))
    return Done(model.with_run(run.shown(asks={**run.view.asks, key: ask_view})))


def placed(model: Model, response: request.Response) -> Done:
    """Where the flows are, as the runtime says."""
    if not isinstance(response, steer.Positions):
        return Done(model)
    for run in model.going_here:
        model = model.with_run(_at(run, response))
    return Done(model)


def _at(run: Run, positions: steer.Positions) -> Run:
    """A run where its flows are."""
    flows = dict(run.view.flows)
    for flow in positions.flows:
        shown = flows.get(flow.subsystem)
        if shown is not None:
            is_pausing = flow.is_pausing and flow.state != "paused"
            flows[flow.subsystem] = structs.replace(shown, is_pausing=is_pausing, loops=run_view.loops(flow.loops))
    return run.shown(flows=flows)


def _surveyed(model: Model, response: request.Response) -> Done:
    if not isinstance(response, Standing):
        return Done(model)
    return Done(replace(model, runtime=runtime_view(model.runtime, response)))
