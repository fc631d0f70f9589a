"""How a run gets on: what is told of it becomes what is shown of its flows and steps (requirements E07, E11, E14)."""

from dataclasses import replace

from msgspec import structs

from onika.desk.environment.run_state import halted_arm
from onika.desk.environment.run_state.question import ask_view
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.run_state.run_view import in_short, is_question, left_for, stop_view, tag, with_black_box
from onika.desk.environment.run_state.transfer_view import jump_view
from onika.desk.plan import begin_places
from onika.desk.plan.begin_places import FlowEnd
from onika.desk.run import transfer_text
from onika.desk.run.flow_status import WAITS, FlowStatus
from onika.wire import event
from onika.wire.view import MeetView, StepRunView
from onika.words.reason import NOTHING, Reason

ABORTED = "desk.aborted_by_user"
"""Why a run ends that its user wants to end, as a key."""
_MOST_MEETS = 60
_BEFORE = ("ready", "spawning")
_ENDS = ("killing", "ended")
_STANDS = ("stopped", "paused", *WAITS)


def after(run: Run, message: event.Event) -> Run:
    """The run after a piece of news; itself where that says nothing of it."""
    match message:
        case event.Began():
            return _began(run, message)
        case event.Done():
            return _done(run, message)
        case event.Met() if message.subsystems and message.subsystems[0] in run.view.flows:
            met = MeetView(tag(message.tag), message.subsystems, message.skew_us, message.at_s)
            return run.shown(meets=(*run.view.meets, met)[-_MOST_MEETS:])
        case event.Explained() if message.subsystem in ("", *run.view.flows):
            key = message.subsystem if message.choices else ""
            return run.shown(stops={**run.view.stops, key: halted_arm.beside(run, stop_view(run, message))})
        case event.Drive():
            return halted_arm.heard(run, message)
        case event.LastSecondsKept():
            return run.shown(stops={key: with_black_box(stop, message) for key, stop in run.view.stops.items()})
        case event.Result():
            return over(run, message)
    is_of_flow = getattr(message, "subsystem", None) in run.view.flows
    return _after_news_of_flow(run, message) if is_of_flow else run


def _after_news_of_flow(run: Run, message: event.Event) -> Run:
    """The run after news of one of its flows, or of a task of it."""
    match message:
        case event.Moved():
            return _moved(run, message)
        case event.Asked():
            return run.shown(asks={**run.view.asks, _key(message): ask_view(message)})
        case event.TaskState():
            return _turned(run, message)
        case event.Failed():
            return replace(run, failures={**run.failures, _key(message): message})
        case event.Warned():
            return _warned(run, message)
        case event.Stepped() if message.is_too_far:
            return run.noted(transfer_text.sentence(message))
    return run


def _warned(run: Run, message: event.Warned) -> Run:
    """A warning, with the task that it is of; a question that nobody answered is shown as a question anyway.

    What ends an action speaks for it: it is named by what its user has placed.
    """
    if message.task:
        what = _called_by_user(run, message.subsystem, message.task) or message.task
        return run.noted(Reason.of("run.what_why", what=what, why=message.text))
    if is_question(message.text):
        return run
    return run.noted(message.text)


def _called_by_user(run: Run, subsystem: str, task: str) -> str:
    """The action that goes on there, where it has a target and this is the task that it is told; else nothing."""
    flow = run.number_of(subsystem)
    index = run.view.flows[subsystem].index
    action = None if flow is None else run.action(flow, index)
    is_told = action is not None and action.target is not None and action.tasks[-1:] == (task,)
    return run.called(subsystem, index) if is_told else ""


def over(run: Run, result: event.Result) -> Run:
    """The run at its end (E14); what was under way is left."""
    for subsystem, flow in run.view.flows.items():
        run = _closed(run, subsystem, flow.step, result.runtime_s)
    for remark in result.remarks:
        run = run.noted(remark)
    ends = {number: _end(run.status(home)) for number, home in enumerate(run.homes)}
    can_go_on = not (result.completed or run.parts) and begin_places.is_anywhere(run.plan, ends)
    run = replace(run, ends=ends).shown(is_completed=result.completed, can_go_on=can_go_on)
    return replace(run, statuses={}, on=frozenset(), awaits=None).shown(
        state="over",
        puzzle=None if run.attempt is None else run.attempt.result(run.view, result),
        asks={},
        stops={key: stop for key, stop in run.view.stops.items() if not key},
        cause=_cause(run, run.wording.with_icons(result.cause)),
        done=result.done,
        took_s=result.runtime_s,
        black_box=result.black_box,
        jumps=tuple(map(jump_view, result.steps)),
    )


def _end(status: FlowStatus) -> FlowEnd:
    return FlowEnd(status.action, status.is_acting)


def lost(run: Run, cause: Reason, black_box: str = "") -> Run:
    """The run where nothing more can be heard of it (E10): aborted, as far as it had come."""
    at_s = max((flow.began_s for flow in run.view.flows.values()), default=0.0)
    result = event.Result(False, cause, run.view.done, run.view.of, at_s, 0.0, {}, (), "", black_box=black_box)
    return over(run, result)


def _cause(run: Run, text: Reason) -> Reason:
    """Why it ended; where somebody ended it because it stood, also why it stood."""
    standing = sorted((stop for key, stop in run.view.stops.items() if key), key=lambda stop: stop.at_s)
    reason = standing[0].text if standing else run.reason
    is_wanted = isinstance(text, Reason) and text.key == ABORTED
    if not (reason and is_wanted):
        return text
    return Reason.of("run.ended_by_you", why=in_short(reason))


def _began(run: Run, began: event.Began) -> Run:
    action = run.action(began.flow, began.index)
    if action is None or action.name != began.action:
        return run
    subsystem, step = run.homes[began.flow], action.spot[0] if action.spot else 0
    former = run.view.flows[subsystem]
    if former.step != step or _goes_round(run, began, former.index):
        run = _closed(run, subsystem, former.step, began.at_s)
    run = _opened(run, began, step)
    should_take_s = run.durations.get((began.flow, began.index), 0.0)
    run = run.in_flow(
        subsystem,
        state="running" if former.state in _BEFORE else former.state,  # it is not told: the action says it
        step=step,
        action=run.wording.action(action),
        within=tuple(map(run.wording.icon, action.within)),
        index=began.index,
        began_s=began.at_s,
        should_take_s=should_take_s,
    )
    return replace(run.with_status(subsystem, run.status(subsystem).began(began)), reason=NOTHING)


def _opened(run: Run, began: event.Began, step: int) -> Run:
    """A step begins; one that runs an application goes on with its next action."""
    former_step = run.view.steps.get(str(step))
    action = run.action(began.flow, began.index)
    is_nested = action is not None and len(action.spot) > 1
    if former_step is not None and former_step.state == "running" and is_nested:
        return run
    took_s, times = (former_step.took_s, former_step.times) if former_step else (0.0, 0)
    return _in_step(run, step, StepRunView("running", began.at_s, took_s, times))


def _goes_round(run: Run, began: event.Began, former: int) -> bool:
    """Whether an application begins anew behind its own end, in a loop in which nothing else stands."""
    actions = run.plan.flows[began.flow].actions
    spot = actions[began.index].spot[:1]
    places = [at for at, action in enumerate(actions) if action.spot[:1] == spot]
    return (began.index, former) == (places[0], places[-1])


def _done(run: Run, done: event.Done) -> Run:
    action = run.action(done.flow, done.index)
    if action is None:
        return run
    subsystem = run.homes[done.flow]
    run = run.with_status(subsystem, run.status(subsystem).done())
    run = run.in_flow(subsystem, done=run.view.flows[subsystem].done + 1).shown(done=run.view.done + 1)
    if len(action.spot) == 1:
        return _closed(run, subsystem, action.spot[0], done.at_s)
    return run


def _moved(run: Run, moved: event.Moved) -> Run:
    former = run.view.flows[moved.subsystem]
    status = run.status(moved.subsystem).moved(moved)
    run = run.with_status(moved.subsystem, status).in_flow(
        moved.subsystem,
        state=status.state,
        tag=tag(status.tag) if status.state in WAITS else "",
        waits_for=status.waits_for,
        waits_since_s=status.waits_since_s,
        is_pausing=former.is_pausing and status.state != "paused",
        text=run.wording.with_icons(moved.text),
    )
    if moved.state == "done":
        run = _closed(run, moved.subsystem, former.step, moved.at_s)
    if moved.state in _STANDS:
        return run
    gone = {moved.subsystem, *left_for(run, moved.subsystem)} & run.view.stops.keys()
    if not gone:
        return run
    if moved.state in _ENDS and moved.subsystem in gone:
        run = replace(run, reason=run.reason or run.view.stops[moved.subsystem].text)
    return run.shown(stops={key: stop for key, stop in run.view.stops.items() if key not in gone})


def _turned(run: Run, task_state: event.TaskState) -> Run:
    key = _key(task_state)
    if task_state.state != "ASKING" and key in run.view.asks:
        run = run.shown(asks={other: ask for other, ask in run.view.asks.items() if other != key})
    if task_state.state != "ERROR" and key in run.failures:
        run = replace(run, failures={other: failed for other, failed in run.failures.items() if other != key})
    return replace(run, on=run.on | {key} if task_state.state == "ON" else run.on - {key})


def _closed(run: Run, subsystem: str, step: int, at_s: float) -> Run:
    """A step is done, or left where its action was under way; of nested flows only those around them know."""
    former_step = run.view.steps.get(str(step))
    if former_step is None or former_step.state != "running" or run.view.flows[subsystem].is_nested:
        return run
    is_left = run.status(subsystem).is_acting
    times = former_step.times if is_left else former_step.times + 1
    took_s = round(max(at_s - former_step.began_s, 0.0), 3)
    return _in_step(
        run, step, structs.replace(former_step, state="left" if is_left else "done", took_s=took_s, times=times)
    )


def _in_step(run: Run, step: int, shown: StepRunView) -> Run:
    if step:
        return run.shown(steps={**run.view.steps, str(step): shown})
    return run


def _key(message: event.Asked | event.Failed | event.TaskState) -> str:
    return f"{message.subsystem}/{message.task}"
