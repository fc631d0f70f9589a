"""How a run gets on: what is told of it becomes what is shown of its flows and steps (requirements E07, E11, E14)."""

import re
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.run_state.question import ask_view
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.run_state.run_view import is_question, left_for, stop_view, tag
from onika.desk.environment.run_state.transfer_view import jump_view
from onika.desk.run import transfer_text
from onika.wire import event
from onika.wire.view import MeetView, StepRunView

ABORTED = "aborted by the user"
_WHERE = re.compile(r"^\w+: (?:ModuleError|LawBroken): ")
"""Where in a module it was said: a module's own error is a sentence for people."""
_MOST_MEETS = 60
_WAITS = ("waiting", "joining")
_BEFORE = ("ready", "spawning")
_ENDS = ("killing", "ended")
_STANDS = ("stopped", "paused", *_WAITS)


def after(run: Run, told: event.Event) -> Run:
    """The run after a piece of news; itself where that says nothing of it."""
    match told:
        case event.Began():
            return _began(run, told)
        case event.Done():
            return _done(run, told)
        case event.Moved() if told.subsystem in run.view.flows:
            return _moved(run, told)
        case event.Met() if told.subsystems and told.subsystems[0] in run.view.flows:
            met = MeetView(tag(told.tag), told.subsystems, told.skew_us, told.at_s)
            return run.shown(meets=(*run.view.meets, met)[-_MOST_MEETS:])
        case event.Asked() if told.subsystem in run.view.flows:
            return run.shown(asks={**run.view.asks, _key(told): ask_view(told)})
        case event.TaskState() if told.subsystem in run.view.flows:
            return _turned(run, told)
        case event.Failed() if told.subsystem in run.view.flows:
            return replace(run, failures={**run.failures, _key(told): told})
        case event.Warned() if told.subsystem in run.view.flows:
            is_shown = not told.task and is_question(told.text)
            return run if is_shown else run.noted(f"{told.task}: {told.text}" if told.task else told.text)
        case event.Stepped() if told.subsystem in run.view.flows and told.is_too_far:
            return run.noted(transfer_text.sentence(told))
        case event.Explained() if told.subsystem in ("", *run.view.flows):
            key = told.subsystem if told.choices else ""
            return run.shown(stops={**run.view.stops, key: stop_view(run, told)})
        case event.Result():
            return over(run, told)
    return run


def over(run: Run, result: event.Result) -> Run:
    """The run at its end (E14); what was under way is left."""
    for subsystem, flow in run.view.flows.items():
        run = _closed(run, subsystem, flow.step, result.runtime_s)
    return replace(run, busy={}, on=frozenset(), awaits=None).shown(
        state="over",
        asks={},
        stops={key: one for key, one in run.view.stops.items() if not key},
        is_completed=result.completed,
        cause=_cause(run, run.speech.said(result.cause)),
        done=result.done,
        took_s=result.runtime_s,
        jumps=tuple(map(jump_view, result.steps)),
    )


def lost(run: Run, cause: str) -> Run:
    """The run where nothing more can be heard of it (E10): aborted, as far as it had come."""
    at_s = max((one.began_s for one in run.view.flows.values()), default=0.0)
    return over(run, event.Result(False, cause, run.view.done, run.view.of, at_s, 0.0, {}, (), ""))


def _cause(run: Run, told: str) -> str:
    """Why it ended; where somebody ended it because it stood, also why it stood."""
    standing = sorted((one for key, one in run.view.stops.items() if key), key=lambda one: one.at_s)
    reason = standing[0].text if standing else run.reason
    return f"ended by you, after: {_WHERE.sub('', reason)}" if reason and told == ABORTED else told


def _began(run: Run, told: event.Began) -> Run:
    action = run.action(told.flow, told.index)
    if action is None or action.name != told.action:
        return run
    subsystem, step = run.homes[told.flow], action.spot[0] if action.spot else 0
    former = run.view.flows[subsystem]
    if former.step != step or _goes_round(run, told, former.index):
        run = _closed(run, subsystem, former.step, told.at_s)
    run = _opened(run, told, step)
    should_take_s = run.durations.get((told.flow, told.index), 0.0)
    run = run.in_flow(
        subsystem,
        state="running" if former.state in _BEFORE else former.state,  # it is not told: the action says it
        step=step,
        action=run.speech.action(action),
        within=tuple(map(run.speech.icon, action.within)),
        index=told.index,
        began_s=told.at_s,
        should_take_s=should_take_s,
    )
    return replace(run, busy={**run.busy, subsystem: told.index}, reason="")


def _opened(run: Run, told: event.Began, step: int) -> Run:
    """A step begins; one that runs an application goes on with its next action."""
    known = run.view.steps.get(str(step))
    action = run.action(told.flow, told.index)
    is_nested = action is not None and len(action.spot) > 1
    if known is not None and known.state == "running" and is_nested:
        return run
    took_s, times = (known.took_s, known.times) if known else (0.0, 0)
    return _in_step(run, step, StepRunView("running", told.at_s, took_s, times))


def _goes_round(run: Run, told: event.Began, former: int) -> bool:
    """Whether an application begins anew behind its own end, in a loop in which nothing else stands."""
    actions = run.plan.flows[told.flow].actions
    spot = actions[told.index].spot[:1]
    places = [at for at, one in enumerate(actions) if one.spot[:1] == spot]
    return (told.index, former) == (places[0], places[-1])


def _done(run: Run, told: event.Done) -> Run:
    action = run.action(told.flow, told.index)
    if action is None:
        return run
    subsystem = run.homes[told.flow]
    run = replace(run, busy={key: at for key, at in run.busy.items() if key != subsystem})
    run = run.in_flow(subsystem, done=run.view.flows[subsystem].done + 1).shown(done=run.view.done + 1)
    if len(action.spot) == 1:
        return _closed(run, subsystem, action.spot[0], told.at_s)
    return run


def _moved(run: Run, told: event.Moved) -> Run:
    former = run.view.flows[told.subsystem]
    waits_since_s = (former.waits_since_s if former.state == told.state else told.at_s) if told.state in _WAITS else 0.0
    run = run.in_flow(
        told.subsystem,
        state=told.state,
        tag=tag(told.tag) if told.state in _WAITS else "",
        waits_for=told.waits_for,
        waits_since_s=waits_since_s,
        is_pausing=former.is_pausing and told.state != "paused",
        text=run.speech.said(told.text),
    )
    if told.state == "done":
        run = _closed(run, told.subsystem, former.step, told.at_s)
    if told.state in _STANDS:
        return run
    gone = {told.subsystem, *left_for(run, told.subsystem)} & run.view.stops.keys()
    if not gone:
        return run
    if told.state in _ENDS and told.subsystem in gone:
        run = replace(run, reason=run.reason or run.view.stops[told.subsystem].text)
    return run.shown(stops={key: one for key, one in run.view.stops.items() if key not in gone})


def _turned(run: Run, told: event.TaskState) -> Run:
    key = _key(told)
    if told.state != "ASKING" and key in run.view.asks:
        run = run.shown(asks={one: asked for one, asked in run.view.asks.items() if one != key})
    if told.state != "ERROR" and key in run.failures:
        run = replace(run, failures={one: failed for one, failed in run.failures.items() if one != key})
    return replace(run, on=run.on | {key} if told.state == "ON" else run.on - {key})


def _closed(run: Run, subsystem: str, step: int, at_s: float) -> Run:
    """A step is done, or left where its action was under way; of nested flows only those around them know."""
    known = run.view.steps.get(str(step))
    if known is None or known.state != "running" or run.view.flows[subsystem].is_nested:
        return run
    is_left = subsystem in run.busy
    times = known.times if is_left else known.times + 1
    took_s = round(max(at_s - known.began_s, 0.0), 3)
    return _in_step(run, step, structs.replace(known, state="left" if is_left else "done", took_s=took_s, times=times))


def _in_step(run: Run, step: int, shown: StepRunView) -> Run:
    return run.shown(steps={**run.view.steps, str(step): shown}) if step else run


def _key(told: event.Asked | event.Failed | event.TaskState) -> str:
    return f"{told.subsystem}/{told.task}"
