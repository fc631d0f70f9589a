"""Why an application does not run, as one refusal: everything at once, with what could be done first (E01, X01)."""

from collections.abc import Sequence

from onika.desk.environment.outcome.fault_view import FaultViews
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.state.open_application import OpenApplication
from onika.wire import request
from onika.wire.view import FaultView, Remedy
from onika.words.reason import Reason

_TOLD = 8
"""Faults that are told in a refusal; all of them stand in the list beside the application."""
_OFFERED = 6


def refused(opened: OpenApplication, fault_views: Sequence[FaultView]) -> No | None:
    """Why it cannot run: all that speaks against it."""
    faults = [fault_view for fault_view in fault_views if fault_view.level == "fault"]
    if not faults:
        return None
    return No(Reason.of("run.cannot_run", name=opened.name, why=_listed(faults)), _offered(faults))


def refused_by_runtime(troubles: FaultViews, response: request.Response) -> No:
    """Why the runtime will not: its modules, argument lines and targets are looked at there."""
    name = troubles.application.name
    if not isinstance(response, request.Prepared):
        return No(Reason.of("run.cannot_run", name=name, why=refusal(response)))
    faults = list(troubles.told(text.fault for text in response.faults))
    return No(Reason.of("run.cannot_run", name=name, why=_listed(faults)), _offered(faults))


def _listed(faults: Sequence[FaultView]) -> Reason:
    """What is told in a line; all of it stands at the icons and in the list beside them."""
    if len(faults) == 1:
        return faults[0].text
    parts = tuple(fault.text for fault in faults[:_TOLD])
    if len(faults) > _TOLD:
        what = Reason.of("run.faults_more", parts=parts, count=len(faults) - _TOLD)
    else:
        what = Reason.of("run.together", parts=parts)
    return Reason.of("run.faults_several", count=len(faults), what=what)


def _offered(faults: Sequence[FaultView]) -> tuple[Remedy, ...]:
    """The first remedy of each, then where it stands."""
    first = [fault.remedies[0] for fault in faults if fault.remedies]
    return tuple(dict.fromkeys(first))[:_OFFERED]
