"""Why an application does not run, as one refusal: everything at once, with what could be done first (E01, X01)."""

from collections.abc import Sequence

from onika.desk.environment.outcome.fault_view import Troubles
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.preparation import fault_of
from onika.wire import request
from onika.wire.view import FaultView, Remedy

_TOLD = 8
"""Faults that are told in a refusal; all of them stand in the list beside the application."""
_OFFERED = 6


def refused(opened: OpenApplication, fault_views: Sequence[FaultView]) -> No | None:
    """Why it cannot run: all that speaks against it."""
    faults = [fault_view for fault_view in fault_views if fault_view.level == "fault"]
    if not faults:
        return None
    return No(f"{opened.name} cannot run: {_listed(faults)}", _offered(faults))


def refused_by_runtime(troubles: Troubles, response: request.Response) -> No:
    """Why the runtime will not: its modules, argument lines and targets are looked at there."""
    if not isinstance(response, request.Prepared):
        return No(f"{troubles.application.name} cannot run: {refusal(response)}")
    faults = list(troubles.told(map(fault_of, response.faults)))
    return No(f"{troubles.application.name} cannot run: {_listed(faults)}", _offered(faults))


def _listed(faults: Sequence[FaultView]) -> str:
    """What is told in a line; all of it stands at the icons and in the list beside them."""
    texts = [str(fault.text) for fault in faults[:_TOLD]]
    more = f"; and {len(faults) - _TOLD} more" if len(faults) > _TOLD else ""
    return texts[0] if len(faults) == 1 else f"{len(faults)} things: {'; '.join(texts)}{more}"


def _offered(faults: Sequence[FaultView]) -> tuple[Remedy, ...]:
    """The first remedy of each, then where it stands."""
    first = [fault.remedies[0] for fault in faults if fault.remedies]
    return tuple(dict.fromkeys(first))[:_OFFERED]
