"""A recording is looked at without a page: its application is opened, and nothing of it is shown to anybody (X21)."""

from dataclasses import dataclass
from pathlib import Path
from typing import cast

from onika.desk.environment import initial_model
from onika.desk.environment.outcome.outcome import Done, No, Procedure, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.review.opening import open_recording
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.show.tree import Projector
from onika.store.site import Site
from onika.wire import act
from onika.wire.view import Tree
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class LoneReview:
    """A recorded run that is looked at, and the tree that a page would be shown."""

    subject: ReviewedRun
    tree: Tree


def read_alone(path: Path, site: Site) -> LoneReview | Reason:
    """Look at a recording, at the icons of its application where the site has it; or why it cannot be read."""
    model, _ = initial_model.opened(site, None, {})
    aside = BackgroundWorker(lambda _change: None)
    services = Services(site, lambda: 0.0, reading=aside)
    steps = open_recording(model, act.OpenRecording(str(path.absolute())), services)
    done = steps if isinstance(steps, Done | No) else _carried_out(steps)
    if isinstance(done, No):
        return done.reason
    session = done.model.review_session
    if session is None:
        raise RuntimeError(f"expected a recording that is looked at, found none of {path}")
    return LoneReview(session.subject, Projector().project(done.model))


def _carried_out(steps: Procedure) -> Done | No:
    """What comes of an act whose work is done at once."""
    try:
        waits = next(steps)
        while True:
            news = waits.work() if isinstance(waits, Work) else None
            waits = steps.send((waits.model, news))
    except StopIteration as end:
        return cast(Done | No, end.value)
