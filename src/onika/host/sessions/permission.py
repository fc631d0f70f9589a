"""What a caller may ask of a runtime, by his role and by where he calls from (law 23, law 27)."""

from collections.abc import Iterable

from onika.link.caller import PARENT, Caller, Role
from onika.wire import holding, live, request, steer

_LOOKING = (
    request.Stop,
    request.Snapshot,
    live.Survey,
    live.Read,
    live.Status,
    live.Check,
    live.Attend,
    live.Scene,
    steer.Who,
    holding.Sessions,
    holding.OnlyWatch,
)
"""What everybody may: to look, and to stop."""


OUTSIDE = ("PARTNER", "STARTS")
"""LOCAL lines that name a program to be started or talked with: as good as code, whatever module reads them."""


def refusal(caller: Caller, asked: request.Request, accepts_code: bool) -> str:
    """Why this may not be asked by this caller; empty: it may.

    accepts_code    whether code from other machines is taken
    """
    least = _least(asked)
    if caller.role < least:
        what = type(asked).__name__
        return f"expected {_article(least)} {least.word} for {what}, found {caller.user}, who is {caller.role.word}"
    if brings_code(asked) and not caller.is_near and not accepts_code:
        return f"code from another machine ({caller.address}) is not accepted; start the runtime with --accept-code"
    if isinstance(asked, request.Begin) and asked.record and caller != PARENT:
        return f"a recording is written for the program that launched the runtime; {caller.user} called from elsewhere"
    return ""


def changes_nothing(asked: request.Request) -> bool:
    """Whether who only watches may ask it: it looks, or stops."""
    return isinstance(asked, (*_LOOKING, live.Get, live.Describe, request.Inspect))


def brings_code(asked: request.Request) -> bool:
    """Whether module code comes with it."""
    match asked:
        case request.Prepare():
            return bool(asked.plan.code)
        case request.Inspect() | live.Describe():
            return bool(asked.code)
        case live.Change():
            return bool(asked.code) or any(_leads_outside(task.local) for task in asked.spawn)
        case live.Swap():
            return True
        case live.Reinit():
            return _leads_outside(asked.local or ())
    return False


def _leads_outside(local: Iterable[tuple[str, tuple[str, ...]]]) -> bool:
    return any(key in OUTSIDE for key, _ in local)


def _least(asked: request.Request) -> Role:
    if isinstance(asked, _LOOKING):
        return Role.VIEWER
    if brings_code(asked):
        return Role.PROGRAMMER
    return Role.OWNER if isinstance(asked, request.Quit) else Role.OPERATOR


def _article(role: Role) -> str:
    return "an" if role in (Role.OPERATOR, Role.OWNER) else "a"
