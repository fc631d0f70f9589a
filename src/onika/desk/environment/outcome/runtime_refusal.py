"""Why a runtime does not do something, in words."""

from pathlib import Path

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.state.model import Model
from onika.wire import request


def refusal(response: request.Response) -> str:
    """Why a runtime does not do something, in words."""
    match response:
        case request.Refused():
            return str(response.reason)
        case request.Prepared():
            return "; ".join(_sentence(one) for one in response.faults) or "; ".join(map(str, response.notes))
    return f"expected the runtime to do it, found {type(response).__name__}"


def simply_done(model: Model, wish: request.Request) -> Procedure:
    """Ask a runtime for something that is done, or refused with the reason."""
    model, response = yield Ask(model, wish)
    return Done(model) if isinstance(response, request.Done) else No(refusal(response))


def _sentence(fault: request.FaultText) -> str:
    where = Path(fault.file).name + (f":{fault.line}" if fault.line else "")
    return f"{where}: {fault.reason}"
