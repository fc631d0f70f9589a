"""Recording a configuration that lives by hand: begun and ended by an act, as long as it lives (requirement X05)."""

from onika.desk.environment.file.recordings_folder import recording_path
from onika.desk.environment.outcome.on_file import on_document
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.runs.recording import unwritable
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.wire import act, live, request
from onika.wire.view import Remedy
from onika.words.reason import Reason


@on_document
def record(model: Model, document: Document, command: act.RecordByHand, outside: Services) -> No | Procedure:
    """The value is the path of the file; that it has begun or ended is told by the runtime."""
    facts = document.live
    if facts is None or facts.state != "live":
        connect = Remedy(Reason.of("desk.connect_it"), act.Connect(document.id))
        return No(Reason.of("desk.not_connected", name=document.name), (connect,))
    if not command.is_on:
        return _asked(model, document, live.Record(facts.subsystem), facts.recording)
    path = _path(model, document, facts, outside)
    if isinstance(path, No):
        return path
    return _asked(model, document, live.Record(facts.subsystem, path), path)


def _path(model: Model, document: Document, facts: SubsystemFacts, outside: Services) -> str | No:
    """The file of a recording that is to begin now; a no where none can be made."""
    if model.runtime.address:
        return _no(document, Reason.of("run.record_not_ours_by_hand", address=model.runtime.address))
    if facts.recording:
        end = Remedy(Reason.of("run.end_recording"), act.RecordByHand(document.id, is_on=False))
        return No(Reason.of("run.recorded_already", name=document.name, path=facts.recording), (end,))
    if not facts.tasks:
        return _no(document, Reason.of("run.nothing_lives", subsystem=facts.subsystem))
    if outside.state is None:
        return _no(document, Reason.of("run.record_no_folder"))
    path = recording_path(outside.state, document.name, outside.calendar())
    wrong = unwritable(path.parent)
    return _no(document, wrong) if wrong else str(path)


def _no(document: Document, why: Reason) -> No:
    return No(Reason.of("run.record_not_by_hand", name=document.name, why=why))


def _asked(model: Model, document: Document, wish: live.Record, path: str) -> Procedure:
    model, response = yield Ask(model, wish)
    if isinstance(response, request.Done):
        return Done(model, value=path)
    return _no(document, refusal(response)) if wish.path else No(refusal(response))
