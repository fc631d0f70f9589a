"""What a caller may ask of a runtime, by his role and by where he calls from (law 23, law 27)."""

from collections.abc import Iterable

from onika.link.caller import PARENT, Caller, Role
from onika.wire import booking, holding, live, request, steer
from onika.wire.foresight import WhatIf
from onika.wire.samples import Sample
from onika.words.reason import NOTHING, Reason

_LOOKING = (
    request.Stop,
    request.Snapshot,
    live.Survey,
    live.Read,
    live.Status,
    live.Check,
    live.Attend,
    live.Scene,
    live.ListWorlds,
    steer.Who,
    WhatIf,
    Sample,
    holding.Sessions,
    holding.OnlyWatch,
    booking.Bookings,
)
"""What everybody may: to look, and to stop."""


OUTSIDE = ("PARTNER", "STARTS")
"""LOCAL lines that name a program to be started or talked with: as good as code, whatever module reads them."""


def refusal(caller: Caller, message: request.Request, accepts_code: bool) -> Reason:
    """Why this may not be asked by this caller; empty: it may.

    accepts_code    whether code from other machines is taken
    """
    if isinstance(message, request.Begin):
        repeated = (refusal(caller, request.decode_request(recorded.body), accepts_code) for recorded in message.repeat)
        denied = next(filter(None, repeated), None)  # what is repeated is asked in his name
        if denied:
            return denied
    least = _least(message)
    if caller.role < least:
        if least is Role.PROGRAMMER:
            return Reason.of("host.role_for_code", least=least.word, user=caller.user, role=caller.role.word)
        what = type(message).__name__
        return Reason.of("host.role_wanted_an", least=least.word, what=what, user=caller.user, role=caller.role.word)
    if brings_code(message) and not caller.is_near and not accepts_code:
        return Reason.of("host.code_from_afar", address=caller.address)
    if _writes_recording(message) and caller != PARENT:
        return Reason.of("host.recording_of_launcher", user=caller.user)
    return NOTHING


def _writes_recording(message: request.Request) -> bool:
    """Whether a file is to be written at a place that the caller names."""
    return isinstance(message, live.Record) or (isinstance(message, request.Begin) and bool(message.record))


def changes_nothing(message: request.Request) -> bool:
    """Whether who only watches may ask it: it looks, or stops."""
    return isinstance(message, (*_LOOKING, live.Get, live.Describe, live.Solve, request.Inspect))


def brings_code(message: request.Request) -> bool:
    """Whether module code comes with it."""
    match message:
        case request.Prepare():
            return bool(message.plan.code)
        case request.Inspect():
            return bool(message.code) or bool(message.worlds)
        case live.Describe():
            return bool(message.code)
        case live.Solve():
            return True
        case live.Change():
            brings = bool(message.code) or bool(message.worlds)
            return brings or any(_leads_outside(task.local) for task in message.spawn)
        case live.Swap():
            return True
        case live.Reinit():
            return _leads_outside(message.local or ())
    return False


def _leads_outside(local: Iterable[tuple[str, tuple[str, ...]]]) -> bool:
    return any(key in OUTSIDE for key, _ in local)


def _least(message: request.Request) -> Role:
    if isinstance(message, _LOOKING):
        return Role.VIEWER
    if brings_code(message):
        return Role.PROGRAMMER
    if isinstance(message, request.Quit | holding.Listen | holding.StopListening):
        return Role.OWNER
    return Role.OPERATOR
