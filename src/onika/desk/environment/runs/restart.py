"""Starting the runtime of this environment anew: all that lives there ends, and the workcell is as it was."""

from collections.abc import Iterator
from dataclasses import replace

from onika.desk.environment.outcome.outcome import Ask, Done, InterimModel, No, Procedure, RequiredRuntime
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile import run_reducer
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.run_state import flow_progress
from onika.desk.environment.runs import flow_placement
from onika.desk.environment.runs.obstacles import left
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.desk.run.runtime_conversation import in_short
from onika.wire import act, live, page
from onika.wire.runtime_standing import Standing
from onika.wire.view import Remedy
from onika.words.reason import Reason

_CAUSE = Reason.of("run.started_anew")


def start_anew(model: Model, command: act.StartAnew, _outside: Services) -> Procedure:
    """End the runtime that was started here, and start another; what was connected is connected no more."""
    if model.runtime.address:
        return No(Reason.of("run.runtime_not_ours", address=model.runtime.address))
    ends = tuple(_ends(model))
    if ends and not command.confirmed:
        sure = Remedy(Reason.of("run.start_anew"), act.StartAnew(confirmed=True))
        return No(Reason.of("run.runtime_ends", names=ends), (sure,))
    after = _at_its_end(model)
    model, response = yield Ask(after, live.Survey(), RequiredRuntime(is_anew=True), says=tuple(_says(model)))
    if not isinstance(response, Standing):
        why = refusal(response)
        yield InterimModel(flow_placement.lost(model, why))
        return No(Reason.of("run.no_runtime", why=in_short(why)))
    note = page.Say("info", Reason.of("run.new_runtime"))
    return Done(replace(model, runtime=runtime_view(model.runtime, response)), says=(note,))


def _homes(model: Model) -> dict[str, SubsystemFacts]:
    """What is known of the subsystems of the connected documents, by document."""
    return {
        document.id: document.live
        for document in model.documents_here.values()
        if document.live is not None and document.live.state == "live"
    }


def _living(model: Model) -> list[Document]:
    """The connected documents of which tasks live."""
    return [model.documents[doc] for doc, subsystem_facts in _homes(model).items() if subsystem_facts.tasks]


def _ends(model: Model) -> Iterator[str]:
    """The names of what ends with the runtime."""
    yield from (run.view.name for run in model.going_here)
    yield from (document.name for document in _living(model))


def _at_its_end(model: Model) -> Model:
    """The model when nothing lives any more and another runtime starts."""
    after = left(model, [subsystem_facts.subsystem for subsystem_facts in _homes(model).values()])
    for run in after.going_here:
        if run.parts:
            after = run_reducer.part_lost(after, run, _CAUSE).model
        else:
            after = after.with_run(flow_progress.lost(run, _CAUSE))
    return replace(after, runtime=flow_placement.starting(model.runtime))


def _says(model: Model) -> Iterator[page.Say]:
    """What of this model ends with the runtime, one line for each."""
    for document in _living(model):
        yield page.Say("info", Reason.of("run.disconnected_why", name=document.name, why=_CAUSE), document.id)
    for run in model.going_here:
        yield page.Say("error", Reason.of("run.aborted_why", name=run.view.name, why=_CAUSE))
