"""Going on from an instant of a recorded run: the same run up to there in a simulator, then as it is steered (X05).

The runtime of this environment ends for it. Up to the instant the run goes as fast as it can; from there on time
passes as it does on the wall, so that a person can follow and steer. Nothing is steered before the instant: till then
it is the recorded run. What is run later runs in the simulator too, until the runtime is started anew.
"""

from dataclasses import replace
from functools import partial

from msgspec import structs

from onika.desk.environment.outcome.outcome import (
    Ask,
    Done,
    InterimModel,
    No,
    Order,
    Procedure,
    RequiredRuntime,
    Simulator,
    Steps,
    Work,
)
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile import run_reducer
from onika.desk.environment.reconcile.descriptions import describe
from onika.desk.environment.reconcile.following import given_up
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.review.opening import NOT_HERE, put_away
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.run_state.run import Run
from onika.desk.environment.runs import flow_placement
from onika.desk.environment.runs.obstacles import left
from onika.desk.environment.state.model import Model
from onika.desk.run.recorded_run import RecordedRun, recorded_run
from onika.desk.run.runtime_conversation import in_short
from onika.desk.run.settings import RecordingSource
from onika.wire import act, live, page, request, view
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.reason import NOTHING, Reason

_ENDING = (request.Abort, request.Stop, live.Reset)


def continue_run(model: Model, command: act.Continue, outside: Services) -> Procedure:
    """Repeat the run that is looked at up to an instant, then let it go on; the value is the number of the run."""
    wrong = _refused(model, command, outside)
    if wrong is not None:
        return wrong
    if model.review_session is None or outside.reading is None:
        return NOT_HERE
    subject = model.review_session.subject
    model, recorded = yield Work(model, outside.reading, partial(_read, subject, command.at_s))
    if isinstance(recorded, No):
        return recorded
    wrong = _refused(model, command, outside)
    if wrong is None and model.review_session is not None and not model.review_session.subject.is_of(subject):
        wrong = No(Reason.of("run.another_looked_at"))
    if wrong is not None:
        return wrong
    former = model.run
    model, wrong = yield from _repeated(model, _run(model, subject, command.at_s, outside), recorded)
    if wrong is not None:
        yield InterimModel(replace(model, run=former))  # nothing runs; the recording is still looked at
        return wrong
    put_away(model, outside.reading)
    return _goes_on(replace(model, review_session=None))


def _read(subject: ReviewedRun, at_s: float) -> RecordedRun | No:
    recorded = recorded_run(RecordingSource(subject.path, at_s))
    if isinstance(recorded, RecordedRun):
        return recorded
    reasons = tuple(Reason.of("run.it_cannot_continue", why=fault.reason) for fault in recorded)
    return No(Reason.of("run.together", parts=reasons))


def _refused(model: Model, command: act.Continue, outside: Services) -> No | None:
    if outside.reading is None:
        return NOT_HERE
    if model.review_session is None:
        return No(Reason.of("run.none_looked_at"))
    recording = model.review_session.subject.view
    if recording.cannot_continue:
        return No(Reason.of("run.cannot_continue", name=recording.name, why=recording.cannot_continue))
    if not recording.begin_s <= command.at_s <= recording.end_s:
        begin_s, end_s, at_s = recording.begin_s, recording.end_s, command.at_s
        return No(Reason.of("run.instant_expected", begin_s=begin_s, end_s=end_s, at_s=at_s))
    if model.going:
        running = model.going[0].view
        return No(Reason.of("run.runs_one", name=running.name), (_abort(running.doc),))
    ends = _ends(model)
    if ends and not command.confirmed:
        go_on = Remedy(Reason.of("run.end_and_go_on"), act.Continue(command.at_s, confirmed=True))
        return No(ends, (go_on,))
    return None


def _abort(doc: str) -> Remedy:
    return Remedy(Reason.of("run.abort_it"), act.Steer("abort", doc))


def _ends(model: Model) -> Reason:
    """What ends where the runtime gives way to a simulator; nothing: nothing lives there."""
    runtime = model.runtime
    if runtime.state != "linked":
        return NOTHING
    connected = [
        (document.name, document.live) for document in model.documents_here.values() if document.live is not None
    ]
    others = runtime.subsystems.keys() - {message.subsystem for _, message in connected}
    living = (*(name for name, message in connected if message.tasks), *sorted(others))
    if not living:
        return NOTHING
    if runtime.address:
        return Reason.of("run.left_for_simulator", address=runtime.address, names=living)
    if runtime.is_virtual:
        return Reason.of("run.simulator_makes_room", names=living)
    return Reason.of("run.runtime_makes_room", names=living)


def _repeated(model: Model, run: Run, recorded: RecordedRun) -> Steps[tuple[Model, No | None]]:
    """The simulator takes the place of the runtime, and begins with the recorded run."""
    recorded, notes = _not_ended(recorded)
    for note in (*recorded.notes, *notes):
        run = run.noted(note)
    connected = [document for document in model.documents_here.values() if document.live is not None]
    after = left(model, [document.live.subsystem for document in connected if document.live is not None])
    after = replace(after, runtime=view.RuntimeView("starting"), run=run)
    says = tuple(
        page.Say("info", Reason.of("run.left_by_simulator", name=document.name), document.id)
        for document in connected
        if document.live is not None and document.live.tasks
    )
    reach = RequiredRuntime(is_anew=True, simulator=Simulator(recorded.run.rtpus, recorded.run.options))
    model, standing = yield Ask(after, live.Survey(), reach, says=says, news=given_up(model, after))
    if not isinstance(standing, Standing):
        why = refusal(standing)
        return flow_placement.lost(model, why), No(Reason.of("run.no_simulator", why=in_short(why)))
    model = replace(model, runtime=runtime_view(model.runtime, standing))
    model, prepared = yield Ask(model, recorded.run.prepare)
    wrong = _unprepared(prepared)
    if wrong is None and model.run is not None and model.run.is_given_up:
        wrong = No(Reason.of("run.aborted_before", name=run.view.name))
    if wrong is not None:
        return model, wrong
    begin = recorded.begin(request.Begin(may_ask=True, on_loss="stop"))
    model, response = yield Ask(model, structs.replace(begin, on_error="wait"))  # somebody is there to clear it
    if isinstance(response, request.Done):
        return model, None
    return model, No(Reason.of("run.not_gone_on", name=run.view.name, why=refusal(response)))


def _unprepared(response: request.Response) -> No | None:
    """Why the simulator does not take the recorded plan."""
    if not isinstance(response, request.Prepared):
        return No(Reason.of("run.plan_not_taken", why=refusal(response)))
    if not response.faults:
        return None
    return No(Reason.of("run.plan_not_taken", why=response.faults[0].reason))


def _not_ended(recorded: RecordedRun) -> tuple[RecordedRun, tuple[Reason, ...]]:
    """Without the word that ended it then, so that it can go on; what is to be said of that."""
    kept = tuple(entry for entry in recorded.inputs if not isinstance(request.decode_request(entry.body), _ENDING))
    is_whole = len(kept) == len(recorded.inputs)
    notes = () if is_whole else (Reason.of("desk.ended_by_hand_then"),)
    return replace(recorded, inputs=kept), notes


def _run(model: Model, subject: ReviewedRun, at_s: float, outside: Services) -> Run:
    """What is shown of it: as the recorded one was at its beginning, with the steps of the application of now."""
    return subject.replay.begun.shown(
        state="beginning", number=model.performed + 1, began_at_s=outside.calendar(), recording="", repeats_until_s=at_s
    )


def _goes_on(model: Model) -> Done:
    """The run goes on, and is shown in place of the recording."""
    if model.run is None:
        return Done(model)
    run = model.run if model.run.is_over else model.run.shown(state="running")
    described = describe(replace(model, run=run, performed=model.performed + 1))
    end = (Order(request.Abort(Reason.of("desk.aborted_by_user"))),) if run.is_given_up else ()
    until_s = run.view.repeats_until_s
    if until_s > 0:
        reason = Reason.of("run.repeated_to", name=run.view.name, until_s=until_s)
    else:
        reason = Reason.of("run.repeated", name=run.view.name)
    says = (page.Say("info", reason, run.doc),)
    return Done(described.model, value=run.view.number, says=says, orders=(*end, run_reducer.look(), *described.orders))
