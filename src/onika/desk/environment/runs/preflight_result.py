"""What a runtime has found when it looked at an application, kept beside it until it changes (X02)."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.outcome.fault_view import FaultViews
from onika.desk.environment.reconcile.world_kinds import with_kinds
from onika.desk.environment.runs.retarget_marks import marked
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import PreflightResult
from onika.files import rmod
from onika.wire.plan import Plan
from onika.wire.request import Prepared
from onika.wire.view import FaultView, Remedy, ShowStep
from onika.words.fault import Place
from onika.words.reason import Reason

_PLACED = ("host.note_at", "host.note_in")
_RESOLVED = ("host.resolved", "host.resolved_often")


def looked(model: Model, troubles: FaultViews, plan: Plan, prepared: Prepared) -> Model:
    """The model with what was found at the steps where it stands; `plan` has their numbers as lines."""
    model = with_kinds(model, prepared.worlds)
    opened = model.applications.get(troubles.doc)
    if opened is None:
        return model
    faults = (text.fault for text in prepared.faults)
    fault_views = (*troubles.told(faults, is_of_runtime=True), *_noted(troubles, prepared))
    result = PreflightResult(troubles.application, troubles.redirects, model.runtime.address, fault_views)
    return marked(model.with_application(replace(opened, looked=result)), troubles, plan, prepared)


def worth_noting(prepared: Prepared) -> Iterator[Reason]:
    """The notes of a run: targets that are re-resolved are counted, for each of them has a mark at its icon."""
    yield from (note for note in prepared.notes if not _is_of_resolved(note))
    targets = {(resolved.target, resolved.were, resolved.task, resolved.instead_of) for resolved in prepared.resolved}
    for (task, old), count in sorted(Counter(target[2:] for target in targets).items()):
        if count == 1:
            yield Reason.of("run.target_resolved", task=task, old=old)
        else:
            yield Reason.of("run.targets_resolved", count=count, task=task, old=old)


def _noted(troubles: FaultViews, prepared: Prepared) -> Iterator[FaultView]:
    """What is only worth knowing; targets that are re-resolved bear a mark of their own."""
    for note in prepared.notes:
        if _is_of_resolved(note):
            continue
        place = _place(note)
        step = troubles.step_of(place) if place is not None else 0
        show = (Remedy(Reason.of("run.show_it"), show=ShowStep(step)),) if step else ()
        yield FaultView(_without_place(note), "warning", step, show, is_of_runtime=True)


def _is_of_resolved(note: Reason) -> bool:
    """Whether it says what became of a joint target that another robot takes."""
    within = note.args.get("note") if isinstance(note, Reason) and note.key in _PLACED else None
    return isinstance(within, Reason) and within.key in _RESOLVED


def _place(note: Reason) -> Place | None:
    """Where it stands; None: nowhere."""
    if not isinstance(note, Reason) or note.key not in _PLACED:
        return None
    line = note.args.get("line", 0)
    return Place(str(note.args["file"]), line if isinstance(line, int) else 0)


def _without_place(note: Reason) -> Reason:
    """What it says, of a task with its name."""
    place = _place(note)
    if place is None:
        return note
    name, within = Path(place.file).name, note.args["note"]
    if name.endswith(rmod.ENDING):
        return Reason.of("run.what_why", what=name.removesuffix(rmod.ENDING), why=within)
    if isinstance(within, Reason):
        return within
    return Reason.plain(str(within))
