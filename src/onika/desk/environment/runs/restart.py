"""Starting the runtime of this environment anew: all that lives there ends, and the workcell is as it was."""

from collections.abc import Sequence
from dataclasses import replace

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure, Reach, Shown
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.watches import is_going
from onika.desk.environment.run_state import flow_progress
from onika.desk.environment.runs import flow_placement
from onika.desk.environment.runs.obstacles import left
from onika.desk.environment.state.model import Model
from onika.desk.run.runtime import in_short
from onika.wire import act, live, page
from onika.wire.view import Remedy

_CAUSE = "the runtime was started anew"


def start_anew(model: Model, command: act.StartAnew, _outside: Surroundings) -> Procedure:
    """End the runtime that was started here, and start another; what was connected is connected no more."""
    if model.runtime.address:
        return No(f"the runtime at {model.runtime.address} was started by somebody else, who alone can start it anew")
    connected = [
        document for document in model.documents.values() if document.live is not None and document.live.state == "live"
    ]
    living = [document for document in connected if document.live is not None and document.live.tasks]
    ends = [*([model.run.view.name] if is_going(model) and model.run else []), *(document.name for document in living)]
    if ends and not command.confirmed:
        return No(_told(ends), (Remedy("Start anew", act.StartAnew(confirmed=True)),))
    after = left(model, [document.live.subsystem for document in connected if document.live is not None])
    says = [page.Say("info", f"{document.name} is no longer connected: {_CAUSE}", document.id) for document in living]
    if after.run is not None and not after.run.is_over:
        after = replace(after, run=flow_progress.lost(after.run, _CAUSE))
        says.append(page.Say("error", f"{model.run.view.name if model.run else ''} was aborted: {_CAUSE}"))
    after = replace(after, runtime=flow_placement.starting(model.runtime))
    model, response = yield Ask(after, live.Survey(), Reach(is_anew=True), says=tuple(says))
    if not isinstance(response, live.Standing):
        why = refusal(response)
        yield Shown(flow_placement.lost(model, why))
        return No(f"no runtime: {in_short(why)}")
    note = page.Say("info", "a new runtime is there; its workcell is as it was at the beginning")
    return Done(replace(model, runtime=runtime_view(model.runtime, response)), says=(note,))


def _told(ends: Sequence[str]) -> str:
    return (
        f"the runtime ends, and {', '.join(ends)} with it; "
        "then another one starts, and its workcell is as it was at the beginning"
    )
