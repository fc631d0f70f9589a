"""What a runtime tells of the run of an application: what is shown follows, and what is worth a line is said."""

from dataclasses import replace
from functools import partial

from msgspec import structs

from onika.desk.environment.outcome.outcome import Done, Ending, No, Order
from onika.desk.environment.reconcile.current_values import measured, values_of
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.run_state import flow_progress, run_view
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.runs import recording
from onika.desk.environment.state.model import Model
from onika.wire import event, live, page, request, steer
from onika.wire.view import ShowStep


def heard(model: Model, told: event.Event) -> Done:
    """The model after a piece of news, as far as it is about the run."""
    run = model.run
    if run is None or run.is_over:
        return Done(model)
    if isinstance(told, event.Edited) and run.view.state == "beginning":
        return _edited(model, run, told)
    now = flow_progress.after(run, told)
    if now is run:
        return Done(model)
    if isinstance(told, event.Result):
        now = recording.measured(now)
    return Done(
        replace(model, run=now),
        orders=_orders(model, run, now, told),
        says=_says(now, told, is_held=model.runtime.is_stopped),
    )


def lost(model: Model, reason: str) -> Done:
    """The runtime is gone: the run is reported aborted (E10); one that had not begun is refused to who wanted it."""
    run = model.run
    if run is None or run.is_over:
        return Done(model)
    if run.view.state == "beginning":
        news = () if run.awaits is None else ((Ending(run.awaits), No(reason)),)
        return Done(replace(model, run=replace(run, awaits=None)), news=news)
    now = recording.measured(flow_progress.lost(run, f"the runtime is lost: {reason}"))
    return Done(replace(model, run=now), says=(end(now),))


def who() -> Order:
    """Ask where the flows are: whether they will pause, and which loops they are in."""
    return Order(steer.Who(), placed)


def look() -> Order:
    """Ask what there is: worlds are opened by a run, and subsystems come and go with it."""
    return Order(live.Survey(), _surveyed)


def _edited(model: Model, run: Run, told: event.Edited) -> Done:
    """A live change has come to its end while the run is about to begin; it may be what the run waits for."""
    if run.awaits != told.number:
        return Done(replace(model, run=replace(run, outcomes={**run.outcomes, told.number: told.cause})))
    news = ((Ending(told.number), No(told.cause) if told.cause else None),)
    return Done(replace(model, run=replace(run, awaits=None)), news=news)


def _orders(model: Model, former: Run, run: Run, told: event.Event) -> tuple[Order, ...]:
    match told:
        case event.Began():
            is_first = not former.view.steps
            return (*((look(),) if is_first else ()), *((who(),) if run.has_loops(told.flow) else ()))
        case event.Asked():
            return _ask_present(model, run, told)
        case event.Result():
            return (look(),)
    return ()


def _says(run: Run, told: event.Event, *, is_held: bool) -> tuple[page.Say, ...]:
    doc = run.doc
    match told:
        case event.Explained() if told.choices and not is_held:  # an end is told with the result, a stop by the stop
            where = run.step_at(told.subsystem, told.index)
            who_ = "/".join(one for one in (told.subsystem, told.task) if one)
            text = run.speech.with_icons(f"{who_}: {told.text}" if who_ else told.text)
            return (page.Say("error", text, doc, ShowStep(where) if where else None, told.at_s),)
        case event.Warned() | event.Stepped():
            return (page.Say("warning", run.view.notes[-1], doc, None, told.at_s),)
        case event.Result():
            return (end(run),)
    return ()


def end(run: Run) -> page.Say:
    """How a run has ended, in words."""
    view = run.view
    if view.is_completed:
        return page.Say("success", f"{view.name} is done: {_actions(view.done)} in {view.took_s:.1f} s", run.doc)
    return page.Say("error", f"{view.name} was aborted after {_actions(view.done)}: {view.cause}", run.doc)


def _actions(count: int) -> str:
    return f"{count} action{'' if count == 1 else 's'}"


def _ask_present(model: Model, run: Run, told: event.Asked) -> tuple[Order, ...]:
    """Where the arm stands, as a possible answer."""
    moving = [one.partition("/")[2] for one in run.on if one.startswith(f"{told.subsystem}/")]
    wanted = measured(model, told.task, moving)
    if not wanted:
        return ()
    then = partial(_present, key=f"{told.subsystem}/{told.task}", wanted=wanted)
    return (Order(live.Read(told.subsystem, tuple(dict.fromkeys(wanted.values()))), then),)


def _present(model: Model, response: request.Response, key: str, wanted: dict[str, str]) -> Done:
    run = model.run
    if run is None or key not in run.view.asks or not isinstance(response, live.Values):
        return Done(model)
    asked = structs.replace(run.view.asks[key], present=values_of(response, wanted))
    return Done(replace(model, run=run.shown(asks={**run.view.asks, key: asked})))


def placed(model: Model, response: request.Response) -> Done:
    """Where the flows are, as the runtime says."""
    run = model.run
    if run is None or run.is_over or not isinstance(response, steer.Positions):
        return Done(model)
    flows = dict(run.view.flows)
    for one in response.flows:
        known = flows.get(one.subsystem)
        if known is not None:
            is_pausing = one.is_pausing and one.state != "paused"
            flows[one.subsystem] = structs.replace(known, is_pausing=is_pausing, loops=run_view.loops(one.loops))
    return Done(replace(model, run=run.shown(flows=flows)))


def _surveyed(model: Model, response: request.Response) -> Done:
    if not isinstance(response, live.Standing):
        return Done(model)
    return Done(replace(model, runtime=runtime_view(model.runtime, response)))
