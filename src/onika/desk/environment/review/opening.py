"""A recording is opened to be looked at, and its application with it; reading it keeps nobody waiting (X05).

The file is read aside; then its application is opened, where it can be found, and compiled aside as it is now, so that
what was recorded is shown at its icons.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

from onika.desk.environment.file import applications
from onika.desk.environment.outcome.fault_view import place_of
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.outcome.worker import Aside, Outcome
from onika.desk.environment.run_state.membership import Belonging
from onika.desk.environment.run_state.messages import Speech
from onika.desk.environment.run_state.recorded_run import Subject, subject
from onika.desk.environment.run_state.review_session import Looking
from onika.desk.environment.run_state.step_mapping import Present, recast
from onika.desk.environment.runs.begin import durations, ready
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.run.run_review import Review
from onika.model.application import with_numbers_as_lines
from onika.model.syntax import Syntax
from onika.record.reader import UNREADABLE, complaint
from onika.store.site import Site
from onika.wire import act
from onika.wire.plan import Plan

NOT_HERE = No("recordings cannot be looked at here")
_NO_SYNTAX = Syntax((), ())
Adopt = Callable[[Model, Subject], Done | No]


def open_recording(model: Model, asked: act.OpenRecording, outside: Surroundings) -> Done | No:
    """Look at a recorded run; the value is the path of its file."""
    aside = outside.reading
    if aside is None:
        return NOT_HERE

    def adopted(model: Model, found: Subject) -> Done:
        put_away(model, aside)
        return Done(replace(model, looking=Looking(found)), value=found.view.path)

    return read(model, asked.path, outside, aside, adopted, opens=True)


def close_recording(model: Model, _asked: act.CloseRecording, outside: Surroundings) -> Done | No:
    """Put it away; none need be looked at."""
    if outside.reading is not None:
        put_away(model, outside.reading)
    return Done(replace(model, looking=None))


def put_away(model: Model, aside: Aside) -> None:
    """Put everything away that is looked at."""
    if model.looking is not None:
        put_one_away(model.looking.subject, aside)
        put_one_away(model.looking.other, aside)


def put_one_away(one: Subject | None, aside: Aside) -> None:
    """Close the file of a run that nobody looks at any more, as soon as nobody reads in it."""
    if one is not None:
        one.away.set()
        aside.do(one.review.close)


def read(model: Model, path: str, outside: Surroundings, aside: Aside, adopt: Adopt, *, opens: bool) -> Done:
    """Read a recording; then it is adopted. Its application is opened where that is wanted and it is not open."""
    file = Path(path).expanduser().absolute()

    def work() -> Outcome:
        try:
            review = Review(file)
        except UNREADABLE as wrong:
            return _refusing(file, wrong)
        return partial(_with_application, review=review, outside=outside, aside=aside, adopt=adopt, opens=opens)

    return Done(model, orders=(aside.order(work),), is_answered_later=True)


def _refusing(file: Path, wrong: Exception) -> Outcome:
    no = No(f"{file.name} cannot be looked at: {complaint(file, wrong).removeprefix(f'{file}: ')}")
    return lambda _: no


# -- its application


def _with_application(
    model: Model, review: Review, outside: Surroundings, aside: Aside, adopt: Adopt, *, opens: bool
) -> Done:
    """Find it; then it is compiled."""
    model, opened, note = _opened(model, review.run.prepare.plan, outside, opens=opens)
    syntax = model.syntax or _NO_SYNTAX

    def work() -> Outcome:
        try:
            found = subject_of(review, opened, note, outside.site, syntax)
        except UNREADABLE as wrong:
            review.close()
            return _refusing(review.path, wrong)
        return lambda model: adopt(model, found)

    return Done(model, orders=(aside.order(work),), is_answered_later=True)


def _opened(
    model: Model, plan: Plan, outside: Surroundings, *, opens: bool
) -> tuple[Model, OpenApplication | None, str]:
    """The open application whose run it was, opened where it is not; or why there is none."""
    one = open_one(model, plan)
    if one is not None or not opens:
        return model, one, ""
    place = _place(plan)
    done = applications.open_file(model, act.Open(place if Path(place).is_file() else plan.application), outside)
    if isinstance(done, No):
        return model, None, f"{plan.application} is not open: {done.reason}. Its actions are shown without icons"
    return done.model, done.model.applications[str(done.value)], ""


def open_one(model: Model, plan: Plan) -> OpenApplication | None:
    """The open application that was recorded; None: it is not open."""
    place = _place(plan)
    same = [one for one in model.applications.values() if place_of(one).file in (place, str(Path(place).absolute()))]
    if not same and not Path(place).is_file():  # recorded in another folder, or on another machine
        same = [one for one in model.applications.values() if one.opened and one.name == plan.application]
    return same[0] if same else None


def _place(plan: Plan) -> str:
    """What stood for the file of the application: where the first action that is in no other one stands."""
    own = (one.place for flow in plan.flows for one in flow.actions if not one.within)
    return next(own, plan.application)


def subject_of(review: Review, opened: OpenApplication | None, note: str, site: Site, syntax: Syntax) -> Subject:
    """A recording shown at the icons of an application as it is now."""
    present = None if opened is None else _present(opened, site, syntax)
    found = recast(review.run.prepare.plan, present)
    found = replace(found, notes=(*((note,) if note else ()), *found.notes))
    return subject(review, found, durations(review.run.prepare.targets, syntax))


def _present(opened: OpenApplication, site: Site, syntax: Syntax) -> Present:
    prepared = ready(opened, site, syntax)
    speech = Speech.of(place_of(opened), with_numbers_as_lines(opened.application), prepared.program, syntax)
    belonging = Belonging.of(opened.application, syntax)
    return Present(opened.id, opened.name, prepared.plan, belonging, speech)
