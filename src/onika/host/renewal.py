"""The renewal of a runtime in virtual time: it becomes as it was when it was started, on the same links (X23)."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from onika.host.sessions.request_server import SessionRequest
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.wire import holding, live
from onika.words.reason import NOTHING, Reason


@dataclass(slots=True)
class Renewal:
    """What was asked, and what was asked after it, which the renewed program carries out."""

    call: SessionRequest
    asked: live.Renew
    later: Sequence[SessionRequest] = ()


def refusal(
    session: str,
    subsystems: Subsystems,
    sessions: Collection[holding.SessionStanding],
    *,
    is_virtual: bool,
    is_waiting: bool,
) -> Reason:
    """Why a runtime is not renewed now; NOTHING: it is.

    sessions    those that are connected
    is_waiting  whether a request waits until the code of a module has been looked at
    """
    if not is_virtual:
        return Reason.of("host.renew_wall")
    if subsystems.runs:
        return Reason.of("host.renew_runs", application=subsystems.runs[0].application)
    if subsystems.live:
        return Reason.of("host.renew_lives", subsystem=min(subsystems.live))
    others = tuple(sorted(other.name for other in sessions if other.name != session))
    if others:
        return Reason.of("host.renew_others", sessions=others)
    return Reason.of("host.renew_waits") if is_waiting else NOTHING
