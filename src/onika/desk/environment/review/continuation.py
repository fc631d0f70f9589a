"""Going on from an instant of a recorded run: the same run up to there in a simulator, then as it is steered (X05).

The runtime of this environment ends for it. Up to the instant the run goes as fast as it can; from there on time
passes as it does on the wall, so that a person can follow and steer. Nothing is steered before the instant: till then
it is the recorded run. What is run later runs in the simulator too, until the runtime is started anew.
"""

from dataclasses import dataclass, replace
from functools import partial

from msgspec import structs

from onika.desk.environment.following import given_up
from onika.desk.environment.outcome.outcome import Done, No, Order, Reach, Simulator
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.outcome.worker import Outcome
from onika.desk.environment.reconcile.descriptions import describe
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.review.opening import NOT_HERE, put_away
from onika.desk.environment.run_state.recorded_run import Subject
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.runs import flow_placement, run_reducer
from onika.desk.environment.runs.obstacles import left
from onika.desk.environment.state.model import Model
from onika.desk.plan.icon_names import listed
from onika.desk.run.recorded_run import RecordedRun, Source, recorded_run
from onika.desk.run.runtime import in_short
from onika.wire import act, live, page, request, view
from onika.wire.view import Remedy

_ABORT = Remedy("Abort it", act.Steer("abort"))
_BY_USER = "aborted by the user"
_ENDING = (request.Abort, request.Stop, live.Reset)


@dataclass(frozen=True, slots=True)
class _Start:
    """A recorded run on its way to be repeated."""

    subject: Subject
    recorded: RecordedRun
    run: Run
    former: Run | None
    outside: Surroundings


def continue_run(model: Model, asked: act.Continue, outside: Surroundings) -> Done | No:
    """Repeat the run that is looked at up to an instant, then let it go on; the value is the number of the run."""
    wrong = _refused(model, asked, outside)
    if wrong is not None:
        return wrong
    if model.looking is None or outside.reading is None:
        return NOT_HERE
    subject = model.looking.subject

    def work() -> Outcome:
        recorded = recorded_run(Source(subject.path, asked.at_s))
        if not isinstance(recorded, RecordedRun):
            why = (f"it cannot be continued: expected {one.expected}, found {one.found}" for one in recorded)
            no = No("; ".join(why))
            return lambda _: no
        return partial(_replacing, asked=asked, subject=subject, recorded=recorded, outside=outside)

    return Done(model, orders=(outside.reading.order(work),), is_answered_later=True)


def _refused(model: Model, asked: act.Continue, outside: Surroundings) -> No | None:
    if outside.reading is None:
        return NOT_HERE
    if model.looking is None:
        return No("no recording is looked at")
    recording = model.looking.subject.view
    if recording.cannot_continue:
        return No(f"{recording.name} cannot be continued: {recording.cannot_continue}")
    if not recording.begin_s <= asked.at_s <= recording.end_s:
        return No(f"expected an instant from {recording.begin_s:g} to {recording.end_s:g} s, found {asked.at_s:g}")
    if model.run is not None and not model.run.is_over:
        return No(f"{model.run.view.name} runs, and one application runs at a time", (_ABORT,))
    ends = _ends(model)
    if ends and not asked.confirmed:
        go_on = Remedy("End it and go on in the simulator", act.Continue(asked.at_s, confirmed=True))
        return No(ends, (go_on,))
    return None


def _ends(model: Model) -> str:
    """What ends where the runtime gives way to a simulator; empty: nothing lives there."""
    runtime = model.runtime
    if runtime.state != "linked":
        return ""
    connected = [(one.name, one.live) for one in model.documents.values() if one.live is not None]
    others = runtime.subsystems.keys() - {known.subsystem for _, known in connected}
    found = [*(name for name, known in connected if known.tasks), *sorted(others)]
    if not found:
        return ""
    if runtime.address:
        return (
            f"the runtime at {runtime.address} is left for the simulator, and {listed(found)} with it: "
            "what this environment held there comes to rest"
        )
    what = "simulator" if runtime.is_virtual else "runtime"
    tasks = "its tasks" if len(found) == 1 else "their tasks"
    return f"the {what} that lives now ends for the simulator of this run, and {listed(found)} with {tasks}"


def _replacing(
    model: Model, asked: act.Continue, subject: Subject, recorded: RecordedRun, outside: Surroundings
) -> Done | No:
    """The simulator takes the place of the runtime, if nothing has come between."""
    wrong = _refused(model, asked, outside)
    if wrong is None and model.looking is not None and not model.looking.subject.is_of(subject):
        wrong = No("another recording is looked at now")
    if wrong is not None:
        return wrong
    recorded, notes = _not_ended(recorded)
    run = _run(model, subject, (*recorded.notes, *notes), asked.at_s, outside)
    after = left(model, [one.live.subsystem for one in model.documents.values() if one.live is not None])
    says = tuple(
        page.Say("info", f"{one.name} is no longer connected: the simulator has taken the place of its runtime", one.id)
        for one in model.documents.values()
        if one.live is not None and one.live.tasks
    )
    after = replace(after, runtime=view.RuntimeView("starting"), run=run)
    simulator = Simulator(recorded.run.rtpus, recorded.run.options)
    start = _Start(subject, recorded, run, model.run, outside)
    reach = Reach(is_anew=True, simulator=simulator)
    order = Order(live.Survey(), partial(_surveyed, start=start), run.doc, reach)
    return Done(after, orders=(order,), is_answered_later=True, says=says, replies=given_up(model, after))


def _not_ended(recorded: RecordedRun) -> tuple[RecordedRun, tuple[str, ...]]:
    """Without the word that ended it then, so that it can go on; what is to be said of that."""
    kept = tuple(one for one in recorded.inputs if not isinstance(request.decode_request(one.body), _ENDING))
    notes = () if len(kept) == len(recorded.inputs) else ("the recorded run was ended by hand; here it is not",)
    return replace(recorded, inputs=kept), notes


def _run(model: Model, subject: Subject, notes: tuple[str, ...], at_s: float, outside: Surroundings) -> Run:
    """What is shown of it: as the recorded one was at its beginning, with the steps of the application of now."""
    run = subject.replay.begun.shown(
        state="beginning",
        number=model.performed + 1,
        began_at_s=outside.calendar(),
        recording="",
        repeats_until_s=at_s,
    )
    for note in notes:
        run = run.noted(note)
    return run


def _surveyed(model: Model, response: request.Response, start: _Start) -> Done | No:
    if not isinstance(response, live.Standing):
        why = refusal(response)
        return _off(flow_placement.lost(model, why), start, No(f"no simulator: {in_short(why)}"))
    model = replace(model, runtime=runtime_view(model.runtime, response))
    order = Order(start.recorded.run.prepare, partial(_prepared, start=start), start.run.doc)
    return Done(model, orders=(order,), is_answered_later=True)


def _prepared(model: Model, response: request.Response, start: _Start) -> Done | No:
    if not isinstance(response, request.Prepared):
        return _off(model, start, No(f"the simulator does not take the recorded plan: {refusal(response)}"))
    if response.faults:
        first = response.faults[0]
        text = f"expected {first.expected}, found {first.found}"
        return _off(model, start, No(f"the simulator does not take the recorded plan: {text}"))
    if model.run is not None and model.run.is_given_up:
        return _off(model, start, No(f"{start.run.view.name} was aborted before it had begun"))
    begin = start.recorded.begin(request.Begin(may_ask=True, on_loss="stop"))
    begin = structs.replace(begin, on_error="wait")  # somebody is there to clear it
    return Done(model, orders=(Order(begin, partial(_running, start=start), start.run.doc),), is_answered_later=True)


def _running(model: Model, response: request.Response, start: _Start) -> Done | No:
    """The run goes on, and is shown in place of the recording."""
    name = start.run.view.name
    if not isinstance(response, request.Done):
        return _off(model, start, No(f"{name} cannot be gone on with: {refusal(response)}"))
    if start.outside.reading is not None:
        put_away(model, start.outside.reading)
    model = replace(model, looking=None)
    if model.run is None:
        return Done(model)
    run = model.run if model.run.is_over else model.run.shown(state="running")
    described = describe(replace(model, run=run, performed=model.performed + 1))
    end = (Order(request.Abort(_BY_USER), doc=run.doc, is_aside=True),) if run.is_given_up else ()
    until_s = run.view.repeats_until_s
    how = f"up to {until_s:.1f} s and goes on from there" if until_s > 0 else "from its beginning"
    says = (page.Say("info", f"{name} is repeated in the simulator {how}", run.doc),)
    return Done(described.model, value=run.view.number, says=says, orders=(*end, run_reducer.look(), *described.orders))


def _off(model: Model, start: _Start, why: No) -> No:
    """Nothing runs; the recording is still looked at."""
    return replace(why, instead=Done(replace(model, run=start.former)))
