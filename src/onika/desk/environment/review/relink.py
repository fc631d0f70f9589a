"""An application that is opened, or read again, while its recorded run is looked at: it is shown at its icons (X05)."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.review.opening import open_one, subject_of
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.run_state.review_session import ReviewSession
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.record.reader import UNREADABLE
from onika.wire import act
from onika.words.reason import NOTHING

Handler = Callable[[Model, Any, Services], Done | No]


def relinked(carry_out: Handler) -> Handler:
    """What an act does that opens an application or reads its file again; then its recorded runs follow."""

    def handler(model: Model, command: Any, outside: Services) -> Done | No:
        done = carry_out(model, command, outside)
        review_session = done.model.review_session if isinstance(done, Done) else None
        if isinstance(done, No) or review_session is None:
            return done
        is_read_again = isinstance(command, act.Reload)
        for subject in _both(review_session):
            _follow(subject, done.model, outside, is_read_again=is_read_again)
        return done

    return handler


def _both(review_session: ReviewSession) -> tuple[ReviewedRun, ...]:
    if review_session.other:
        return (review_session.subject, review_session.other)
    return (review_session.subject,)


def _follow(subject: ReviewedRun, model: Model, outside: Services, *, is_read_again: bool) -> None:
    """Have a recorded run shown at the icons of its application, if that is open and it is not shown there already."""
    opened = open_one(model, subject.review.run.prepare.plan)
    aside, syntax, site = outside.reading, model.syntax, outside.site
    if aside is None or opened is None or (opened.id == subject.view.doc and not is_read_again):
        return

    def work() -> None:
        if subject.away.is_set() or syntax is None:
            return
        try:
            recorded = subject_of(subject.review, opened, NOTHING, site, syntax)
        except UNREADABLE:
            return  # who looks at it next is told
        recorded = replace(recorded, samples=subject.samples, away=subject.away)
        aside.tell(lambda model: Done(_shown(model, subject, recorded, opened)))

    aside.do(work)


def _shown(model: Model, former: ReviewedRun, relinked: ReviewedRun, opened: OpenApplication) -> Model:
    """With one recorded run as it is shown now, unless something has come between."""
    review_session = model.review_session
    if review_session is None or opened.id not in model.applications:
        return model
    if review_session.subject is former:
        return replace(model, review_session=replace(review_session, subject=relinked))
    if review_session.other is former:
        return replace(model, review_session=replace(review_session, other=relinked))
    return model
