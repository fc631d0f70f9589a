"""A recording is opened to be looked at, and its application with it; reading it keeps nobody waiting (X05).

The file is read aside; then its application is opened, where it can be found, and compiled aside as it is now, so that
what was recorded is shown at its icons.
"""

from dataclasses import replace
from functools import partial
from pathlib import Path

from onika.desk.environment.file import file_acts
from onika.desk.environment.outcome.fault_view import place_of
from onika.desk.environment.outcome.outcome import Done, No, Procedure, Steps, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.messages import IconWording
from onika.desk.environment.run_state.recorded_run import ReviewedRun, subject
from onika.desk.environment.run_state.review_session import ReviewSession
from onika.desk.environment.run_state.step_mapping import CurrentApplication, recast
from onika.desk.environment.runs.begin import durations, ready
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.run.run_review import Review
from onika.model.application import with_numbers_as_lines
from onika.model.syntax import Syntax
from onika.record.reader import UNREADABLE, flaw
from onika.record.run import RunRecord
from onika.store.site import Site
from onika.store.user_path import user_path
from onika.wire import act
from onika.wire.plan import Plan
from onika.words.reason import NOTHING, Reason

NOT_HERE = No(Reason.of("run.no_recordings_here"))
_NO_SYNTAX = Syntax((), ())


def open_recording(model: Model, command: act.OpenRecording, outside: Services) -> Procedure:
    """Look at a recorded run; the value is the path of its file."""
    aside = outside.reading
    if aside is None:
        return NOT_HERE
    model, recorded = yield from read(model, command.path, outside, aside, opens=True)
    if isinstance(recorded, No):
        return recorded
    put_away(model, aside)
    return Done(replace(model, review_session=ReviewSession(recorded)), value=recorded.view.path)


def close_recording(model: Model, _asked: act.CloseRecording, outside: Services) -> Done | No:
    """Put it away; none need be looked at."""
    if outside.reading is not None:
        put_away(model, outside.reading)
    return Done(replace(model, review_session=None))


def put_away(model: Model, aside: BackgroundWorker) -> None:
    """Put everything away that is looked at."""
    if model.review_session is not None:
        put_one_away(model.review_session.subject, aside)
        put_one_away(model.review_session.other, aside)


def put_one_away(looked_at: ReviewedRun | None, aside: BackgroundWorker) -> None:
    """Close the file of a run that nobody looks at any more, as soon as nobody reads in it."""
    if looked_at is not None:
        looked_at.away.set()
        aside.do(looked_at.review.close)


def read(
    model: Model, path: str, outside: Services, aside: BackgroundWorker, *, opens: bool
) -> Steps[tuple[Model, ReviewedRun | No]]:
    """Read a recording; its application is opened where that is wanted and it is not open, and then compiled."""
    file = user_path(path, outside.site.own)
    if isinstance(file, Reason):
        return model, No(file)
    model, review = yield Work(model, aside, partial(_review, file))
    if isinstance(review, No):
        return model, review
    model, opened, note = _opened(model, review.run, outside, opens=opens)
    syntax = model.syntax or _NO_SYNTAX
    return (yield Work(model, aside, partial(_compiled, review, opened, note, outside.site, syntax)))


def _review(file: Path) -> Review | No:
    try:
        return Review(file)
    except UNREADABLE as wrong:
        return _unreadable(file, wrong)


def _compiled(
    review: Review, opened: OpenApplication | None, note: Reason, site: Site, syntax: Syntax
) -> ReviewedRun | No:
    try:
        return subject_of(review, opened, note, site, syntax)
    except UNREADABLE as wrong:
        review.close()
        return _unreadable(review.path, wrong)


def _unreadable(file: Path, wrong: Exception) -> No:
    return No(Reason.of("desk.recording_unseen", file=file.name, why=flaw(wrong)))


# -- its application


def _opened(
    model: Model, run: RunRecord, outside: Services, *, opens: bool
) -> tuple[Model, OpenApplication | None, Reason]:
    """The open application whose run it was, opened where it is not; or why there is none."""
    plan = run.prepare.plan
    if run.is_by_hand:
        return model, None, Reason.of("run.was_by_hand", subsystem=plan.application)
    application = open_one(model, plan)
    if application is not None or not opens:
        return model, application, NOTHING
    place = _place(plan)
    done = file_acts.open_file(model, act.Open(place if Path(place).is_file() else plan.application), outside)
    if isinstance(done, No):
        return model, None, Reason.of("run.is_not_open", name=plan.application, why=done.reason)
    return done.model, done.model.applications[str(done.value)], NOTHING


def open_one(model: Model, plan: Plan) -> OpenApplication | None:
    """The open application that was recorded; None: it is not open."""
    place = _place(plan)
    same = [
        application
        for application in model.applications.values()
        if place_of(application).file in (place, str(Path(place).absolute()))
    ]
    if not same and not Path(place).is_file():  # recorded in another folder, or on another machine
        same = [
            application
            for application in model.applications.values()
            if application.opened and application.name == plan.application
        ]
    return same[0] if same else None


def _place(plan: Plan) -> str:
    """What stood for the file of the application: where the first action that is in no other one stands."""
    own = (action.place for flow in plan.flows for action in flow.actions if not action.within)
    return next(own, plan.application)


def subject_of(review: Review, opened: OpenApplication | None, note: Reason, site: Site, syntax: Syntax) -> ReviewedRun:
    """A recording shown at the icons of an application as it is now; `note` is what else is to be said of it."""
    present = None if opened is None else _present(opened, site, syntax)
    mapping = recast(review.run.prepare.plan, present)
    mapping = replace(mapping, notes=(*((note,) if note else ()), *mapping.notes))
    return subject(review, mapping, durations(review.run.prepare.targets, syntax))


def _present(opened: OpenApplication, site: Site, syntax: Syntax) -> CurrentApplication:
    prepared = ready(opened, site, syntax)
    wording = IconWording.of(place_of(opened), with_numbers_as_lines(opened.application), prepared.program, syntax)
    belonging = StepMembership.of(opened.application, syntax)
    return CurrentApplication(opened.id, opened.name, prepared.plan, belonging, wording)
