"""Writes down who came to the page from afar, who was turned away, and what each did there (requirements F10, X12).

Looking leaves no line. No password, token or text ever comes here.
"""

from collections.abc import Callable, Mapping
from typing import Protocol

from onika.web.access.act_rights import WATCHING
from onika.web.access.entrance import Visitor
from onika.wire import act
from onika.words.reason import NOTHING, Reason

_SHOWN = ("doc", "path", "name", "task", "tasks", "subsystem", "flow", "step", "station", "fault")
"""Fields of acts that a line shows."""
_QUIET = (WATCHING - {act.Stop}) | {act.Note}


class TrailWriter(Protocol):
    """Where lines are written."""

    @property
    def trouble(self) -> Reason:
        """Why that does not succeed; empty: it does."""
        ...

    def note(self, what: str, weighs: bool = False, **about: object) -> None:
        """Write a line."""
        ...


class PageTrail:
    """Writes to a trail; `complain` is told once when that no longer succeeds."""

    def __init__(self, writer: TrailWriter, complain: Callable[[Reason], None] = lambda _reason: None) -> None:
        self._writer = writer
        self._complain = complain
        self._trouble = NOTHING
        self._held: dict[str, bool] = {}
        """Whether the pad was held at the last push, by who pushes."""

    def entered(self, visitor: Visitor) -> None:
        """Somebody has signed in."""
        self._note("SignIn", visitor, True, result="done")

    def turned_away(self, name: str, address: str, why: str) -> None:
        """Somebody was not let in; `name` is that of a user, else empty."""
        self._line("SignIn", True, who=name or "?", address=address, result=f"refused:{why}")

    def left(self, visitor: Visitor, why: str) -> None:
        """A session is over."""
        self._note("SignOut", visitor, True, result=why)

    def acted(self, visitor: Visitor, command: act.AnyAct, refusal: Reason) -> None:
        """An act has its answer; an empty `refusal`: it was done."""
        if type(command) in _QUIET or (isinstance(command, act.Push) and not self._is_other(visitor, command)):
            return
        result = f"refused:{refusal.key}" if refusal else "done"
        weighs = isinstance(command, act.Stop | act.Reset)
        self._note(type(command).__name__, visitor, weighs, about=_words(command), result=result)

    def denied(self, visitor: Visitor, command: act.AnyAct) -> None:
        """Somebody wanted what his role may not."""
        if not isinstance(command, act.Note | act.Push):
            self._note(type(command).__name__, visitor, about=_words(command), result="refused:role")

    def _is_other(self, visitor: Visitor, push: act.Push) -> bool:
        """Pushes come thirty times a second: a line for who takes a pad and lets go."""
        before = self._held.get(visitor.session, False)
        self._held[visitor.session] = push.is_held
        return push.is_held != before

    def _note(self, what: str, visitor: Visitor, weighs: bool = False, **about: object) -> None:
        self._line(what, weighs, who=visitor.user, role=visitor.role.word, address=visitor.address, **about)

    def _line(self, what: str, weighs: bool, **about: object) -> None:
        self._writer.note(what, weighs, **about)
        trouble = self._writer.trouble
        if trouble and not self._trouble:
            self._complain(trouble)
        self._trouble = trouble


def _words(command: act.AnyAct) -> str:
    """What it is about, in short."""
    fields: Mapping[str, object] = {name: getattr(command, name, "") for name in _SHOWN}
    return " ".join(f"{name}={_piece(value)}" for name, value in fields.items() if value or value == 0)


def _piece(value: object) -> str:
    return ",".join(map(str, value)) if isinstance(value, tuple) else str(value)
