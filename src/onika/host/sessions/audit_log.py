"""The audit log says to the audit trail who asked what from where, what came of it, and who holds what (X12).

It looks at what sessions ask and at what is told, so that there is no command without a line. Looking is no command,
and neither is letting virtual time pass. Of the pushes of a pad those are told that take it, press its button, let go,
or are refused. No token ever comes here: the listener keeps them.
"""

from collections.abc import Callable
from typing import Any, Protocol

from onika.host.sessions.permission import brings_code, changes_nothing
from onika.host.sessions.request_server import SessionRequest
from onika.link.sessions import Introduction
from onika.wire import event, holding, live, request, steer
from onika.wire.plan import Code, Plan, PlannedTask
from onika.words.reason import NOTHING, Reason

_PASSING = (steer.Onward, live.Advance)
_MOST = 12
"""Pieces of one field that are named."""


class AuditWriter(Protocol):
    """Where lines are written."""

    @property
    def trouble(self) -> Reason:
        """Why that does not succeed; empty: it does."""
        ...

    def note(self, what: str, weighs: bool = False, **about: object) -> None:
        """Write a line."""
        ...


class AuditLog:
    """Writes to a book; `complain` is told once when that no longer succeeds."""

    def __init__(self, audit_writer: AuditWriter, complain: Callable[[Reason], None] = lambda _text: None) -> None:
        self._audit_writer = audit_writer
        self._complain = complain
        self._trouble = NOTHING
        self._pushed: dict[str, tuple[str, bool, bool, str]] = {}
        """By session: what its last push was, as far as it is worth a line."""

    def answered(self, call: SessionRequest, response: request.Response) -> None:
        """A request was answered."""
        asked = call.asked
        is_look = changes_nothing(asked) and not isinstance(asked, request.Stop | holding.OnlyWatch)
        if isinstance(asked, _PASSING) or (is_look and not brings_code(asked)):
            return
        if isinstance(asked, live.Push):
            self._pushes(call, asked, response)
            return
        self._note(
            type(asked).__name__,
            isinstance(asked, request.Stop | live.Reset) or brings_code(asked),
            who=call.session,
            role=call.role.word,
            address=call.address,
            on=getattr(asked, "subsystem", ""),
            about=_words(asked),
            code=[code.digest for code in _code(asked)],
            result=_result(response),
        )

    def _pushes(self, call: SessionRequest, push: live.Push, response: request.Response) -> None:
        """Pushes come thirty times a second: a line for who takes a pad and lets go, not for where it is pushed."""
        last, present = self._pushed.get(call.session), (push.subsystem, push.is_held, push.button, _result(response))
        self._pushed[call.session] = present
        at_rest = (push.subsystem, False, False, present[3])
        if present == (last or at_rest):
            return
        words = [word for word, is_so in (("held", push.is_held), ("button", push.button)) if is_so]
        self._note(
            "Push",
            who=call.session,
            role=call.role.word,
            address=call.address,
            on=push.subsystem,
            about=" ".join(words) or "let go",
            result=present[3],
        )

    def garbage(self, session: str, text: str) -> None:
        """Something came that is no request."""
        self._note("garbage", who=session, result=text)

    def came(self, new: Introduction, why_not: Reason) -> None:
        """Somebody has connected, or was turned away."""
        if new.channel.asks:
            caller = new.caller
            result = f"refused: {why_not}" if why_not else "connected"
            self._note("connect", who=caller.user, role=caller.role.word, result=result, address=caller.address)

    def lost(self, session: str) -> None:
        """A session is gone."""
        self._pushed.pop(session, None)
        self._note("gone", who=session)

    def told(self, message: event.Event) -> None:
        """Something was told: changes of holder, ends of what was accepted, stops, ends of runs."""
        match message:
            case event.Held():
                self._note(
                    "held", True, on=message.subsystem, who=message.holder or "nobody", result=str(message.cause)
                )
            case event.Offered():
                self._note(
                    "offered",
                    on=message.subsystem,
                    who=message.holder,
                    about=f"to {message.to}",
                    result=str(message.outcome),
                )
            case event.Stopped():
                self._note("stopped" if message.is_stopped else "may move again", True, result=str(message.cause))
            case event.Edited():
                self._note(
                    "edited", on=message.subsystem, about=str(message.number), result=str(message.cause) or "done"
                )
            case event.Result():
                how = "completed" if message.completed else f"aborted: {message.cause}"
                self._note("run over", about=f"{message.done} of {message.of} actions", result=how)
            case event.Lost():
                self._note("lost", who=message.name, result=str(message.cause))

    def _note(self, what: str, weighs: bool = False, **about: object) -> None:
        self._audit_writer.note(what, weighs, **about)
        trouble = self._audit_writer.trouble
        if trouble and not self._trouble:
            self._trouble = trouble
            self._complain(trouble)
        self._trouble = trouble


def _code(message: request.Request) -> tuple[Code, ...]:
    code = getattr(message, "code", ())
    if isinstance(message, request.Prepare):
        code = message.plan.code
    return (code,) if isinstance(code, Code) else tuple(code)


def _words(message: request.Request) -> str:
    """What a request says, in short."""
    names = [name for name in message.__struct_fields__ if name not in ("subsystem", "code")]
    pieces = [(name, _piece(getattr(message, name))) for name in names]
    return " ".join(f"{name}={text}" for name, text in pieces if text)


def _piece(value: Any) -> str:
    match value:
        case bool():
            return "yes" if value else ""
        case str() | int() | float() | Reason():
            return str(value)
        case live.Turn():
            return f"{value.task}({value.arguments})"
        case PlannedTask():
            return value.name
        case Plan():
            return value.application
        case tuple():
            pieces = [_piece(one) for one in value[:_MOST]]
            return ",".join(piece for piece in pieces if piece) + (
                f" and {len(value) - _MOST} more" if value[_MOST:] else ""
            )
    return ""


def _result(response: request.Response) -> str:
    match response:
        case request.Refused():
            return f"refused: {response.reason}"
        case live.Accepted():
            return f"accepted as {response.number}"
        case request.Prepared():
            if response.faults:
                return f"{len(response.faults)} faults"
            return "no faults"
    return "done"
