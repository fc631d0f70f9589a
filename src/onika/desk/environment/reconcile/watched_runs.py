"""Documents that look into a running application: watched by everybody, changed by its steps alone (C15, C18)."""

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import WatchedRun
from onika.desk.environment.state.model import Model
from onika.wire import act
from onika.wire.runtime_standing import Standing
from onika.wire.view import HoldView, Remedy
from onika.words.reason import Reason


def application_in(standing: Standing, subsystem: str) -> str:
    """What runs in a subsystem; empty: it is held by hand, or is not there."""
    return next((home.application for home in standing.subsystems if home.name == subsystem), "")


def is_on(model: Model, watched: WatchedRun | None) -> bool:
    """Whether what is watched still runs."""
    if watched is None:
        return False
    subsystem = model.runtime_at(watched.station).inside.get(watched.subsystem)
    return subsystem is not None and subsystem.application == watched.application


def homes(model: Model) -> dict[str, str]:
    """The subsystems that documents look into, by the documents' ids."""
    return {
        doc: document.watched.subsystem
        for doc, document in model.documents_here.items()
        if document.watched is not None and is_on(model, document.watched)
    }


def changed(before: Model, after: Model) -> No | None:
    """Why a change of a document is not made: what it shows belongs to a run. Its looks may change."""
    for doc, document in after.documents.items():
        former = before.documents.get(doc)
        if former is None or former.watched is None or former.content is document.content:
            continue
        if is_on(before, former.watched) and not document.means(former.content):
            return refusal(before, former, former.watched)
    return None


def refusal(model: Model, document: Document, watched: WatchedRun) -> No:
    """That the tasks of a run are not changed by hand, who holds it, and what can be done."""
    holder = model.runtime_at(watched.station).holds.get(watched.subsystem, HoldView()).holder
    what = {"name": document.name, "subsystem": watched.subsystem, "application": watched.application}
    apart = Remedy(Reason.of("desk.look_no_more"), act.Disconnect(document.id))
    if holder:
        return No(Reason.of("desk.belongs_to_run", **what, holder=holder), (apart,))
    take_over = Remedy(Reason.of("run.take_over"), act.Take(subsystem=watched.subsystem, station=watched.station))
    return No(Reason.of("desk.belongs_to_nobody", **what), (apart, take_over))
