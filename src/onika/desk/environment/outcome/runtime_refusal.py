"""Why a runtime does not do something, in words."""

from pathlib import Path

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.state.model import Model
from onika.wire import request
from onika.words.reason import Reason


def refusal(response: request.Response) -> Reason:
    """Why a runtime does not do something."""
    match response:
        case request.Refused():
            return response.reason
        case request.Prepared():
            return Reason.of("run.together", parts=tuple(map(_sentence, response.faults)) or response.notes)
    return Reason.of("run.runtime_answer", answer=type(response).__name__)


def simply_done(model: Model, wish: request.Request) -> Procedure:
    """Ask a runtime for something that is done, or refused with the reason."""
    model, response = yield Ask(model, wish)
    if isinstance(response, request.Done):
        return Done(model)
    return No(refusal(response))


def _sentence(fault: request.FaultText) -> Reason:
    where = Path(fault.file).name + (f":{fault.line}" if fault.line else "")
    return Reason.of("run.what_why", what=where, why=fault.reason)
