"""The recording that is looked at becomes a file that plays by itself, for the browser to save (requirement X21)."""

from functools import partial

from onika.desk.environment.outcome.outcome import Done, No, Procedure, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.review.opening import NOT_HERE
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.shared.sharing import MOST_BYTES, shared_file
from onika.desk.environment.show.tree import Projector
from onika.desk.environment.state.model import Model
from onika.store.mesh_folder import MeshFolder
from onika.wire import act
from onika.wire.view import SharedFileView
from onika.words.reason import Reason


def share(model: Model, _asked: act.ShareRecording, outside: Services) -> Procedure:
    """Make the file; the value is a `view.SharedFileView`."""
    if outside.reading is None or outside.player is None:
        return NOT_HERE
    if model.review_session is None:
        return No(Reason.of("run.none_looked_at"))
    subject = model.review_session.subject
    model, made = yield Work(model, outside.reading, partial(_made, model, subject, outside))
    if isinstance(made, Reason):
        return No(made)
    return Done(model, value=made)


def _made(model: Model, subject: ReviewedRun, outside: Services) -> SharedFileView | Reason:
    if outside.player is None:
        return Reason.of("desk.page_not_built")
    folder = MeshFolder(outside.state) if outside.state is not None else None
    tree = Projector().project(model)
    shared = shared_file(subject, tree, outside.site, outside.player, MOST_BYTES, folder)
    if isinstance(shared, Reason):
        return shared
    seconds = shared.period_s if shared.is_coarse else 0.0
    return SharedFileView(f"{subject.path.stem}.html", shared.text, seconds)
