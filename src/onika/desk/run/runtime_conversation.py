"""A client's conversation with a runtime: requests, responses, events and readings, however it is reached."""

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from time import monotonic_ns
from typing import Protocol

from onika.link.connection import Connection, RequestTooLong
from onika.link.link_events import (
    EpochChanged,
    LinkNotice,
    LinkStateChanged,
    ReadingReceived,
    ReplyReceived,
    RequestFailed,
    SignalReceived,
)
from onika.link.lost import LinkLost, LossCause, closed
from onika.link.state import LinkState
from onika.wire import event, live, request
from onika.wire.foresight import WhatIf
from onika.words.reason import NOTHING, Reason, reason_of

PATIENCE_S = 60.0
"""How long a response may take."""
_AWAY_NS = 10 * 1_000_000_000
"""How long a link to another machine may be cut before it is given up."""
_AGAIN = (
    request.Prepare,
    request.Inspect,
    request.Stop,
    request.Abort,
    request.Snapshot,
    live.Survey,
    live.Read,
    live.Check,
    live.Describe,
    live.Solve,
    live.Attend,
    live.Scene,
    live.Get,
    WhatIf,
)
"""What may be asked again after a cut: it moves nothing, or ends motion."""


@dataclass(frozen=True, slots=True)
class NumberedResponse:
    """The response to a request that nobody waited for, by its number."""

    number: int
    response: request.Response


class RunRuntime(Protocol):
    """What carries out a run: one runtime, or several that were joined."""

    @property
    def pid(self) -> int | None:
        """The process id of the runtime program, None where it was not launched from here."""
        ...

    def ask(self, message: request.Request) -> request.Response:
        """Ask and wait for the response; raises LinkLost or TimeoutError."""
        ...

    def events(self, timeout_s: float) -> Iterator[event.Event]:
        """What has happened since the last call; raises LinkLost at the end."""
        ...

    def printed(self) -> str:
        """What its processes printed last, as far as that can be known here."""
        ...

    def black_box(self) -> str:
        """The file in which the last seconds of a run stand whose runtime has died; empty: none is known here."""
        ...


class RuntimeConversation:
    """Questions, events and readings of one runtime, however it is reached."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._stop_patience_s = PATIENCE_S
        self._news: deque[LinkNotice] = deque()
        self._readings: dict[str, bytes] = {}
        self._epoch = ""
        self._away_since = 0
        self._is_told_gone = False
        self._has_begun = False
        """Whether a run was asked for, or a task turned ON by hand."""

    @property
    def pid(self) -> int | None:
        """The process id of the runtime program, None where it was not launched from here."""
        return None

    @property
    def is_linked(self) -> bool:
        """Whether the runtime is heard at present."""
        return self._connection.state in (LinkState.LINKED, LinkState.SUSPECT)

    @property
    def is_heard(self) -> bool:
        """Whether it was heard just now, and not for long silent."""
        return self._connection.state is LinkState.LINKED

    def ask(self, message: request.Request) -> request.Response:
        """Ask and wait for the response; raises LinkLost with what the runtime printed last, or TimeoutError."""
        once = not isinstance(message, _AGAIN)
        urgent = isinstance(message, request.Stop | request.Abort)
        self._has_begun |= _begins(message)
        try:
            patience_s = self._stop_patience_s if urgent else PATIENCE_S
            body = self._connection.request(request.encode(message), patience_s, once=once, urgent=urgent or once)
        except LinkLost as lost:
            raise self._explained(lost) from None
        except RequestTooLong as refused:
            return request.Refused(reason_of(refused))
        response: request.Response = request.decode_response(body)
        return response

    def send(self, message: request.Request) -> int:
        """Ask without waiting, what ends motion before all that waits; `told` has the reply under this number."""
        once = not isinstance(message, _AGAIN)
        urgent = isinstance(message, request.Stop | request.Abort)
        self._has_begun |= _begins(message)
        return self._connection.ask(request.encode(message), PATIENCE_S, once=once, urgent=urgent or once)

    def readers(self) -> list[int]:
        """The descriptors to wait for before `told`, in a loop of one's own."""
        return self._connection.readers()

    def writers(self) -> list[int]:
        """Those to wait for writing too."""
        return self._connection.writers()

    def due_s(self) -> float | None:
        """How long that loop may wait at most, in s; None: until something comes."""
        return self._connection.due_s()

    def events(self, timeout_s: float) -> Iterator[event.Event]:
        """The events since the last call, at least one within the time-out or none; raises LinkLost at the end."""
        for message in self.messages(timeout_s):
            if not isinstance(message, NumberedResponse):
                yield message

    def messages(self, timeout_s: float = 0.0) -> Iterator[event.Event | NumberedResponse]:
        """Events and replies to what was sent, as they came; raises LinkLost at the end."""
        if not self._news:
            self._news += self._connection.poll(timeout_s)
            self._judge_absence()
        while self._news:  # one by one: whoever stops listening hears the others next time
            notice = self._news.popleft()
            if isinstance(notice, SignalReceived):
                yield event.decode(notice.body)
            elif isinstance(notice, ReplyReceived):
                yield NumberedResponse(notice.number, request.decode_response(notice.body))
            elif isinstance(notice, RequestFailed):
                yield NumberedResponse(
                    notice.number, request.Refused(Reason.of("link.unanswered", fate=notice.fate.reason))
                )
            elif isinstance(notice, ReadingReceived):
                self._readings[notice.key] = notice.body
            elif isinstance(notice, EpochChanged):
                self._new_epoch(notice.epoch)
            elif isinstance(notice, LinkStateChanged) and notice.lost is not None and not self._connection.comes_back:
                self._is_told_gone = True
                raise self._explained(notice.lost)

    def readings(self) -> dict[str, bytes]:
        """The newest reading under each key since the last call; `events` takes them in."""
        taken, self._readings = self._readings, {}
        return taken

    def printed(self) -> str:
        """What the runtime and its processes printed last, as far as that can be known here."""
        return ""

    def black_box(self) -> str:
        """The file in which the last seconds of a run stand whose runtime has died; empty: none is known here."""
        return ""

    def _explained(self, lost: LinkLost | TimeoutError) -> LinkLost:
        cause = lost.cause if isinstance(lost, LinkLost) else LossCause.TIMEOUT
        gone = Reason.of("link.runtime_gone", why=why_lost(lost), how=NOTHING, kept=NOTHING, printed=NOTHING)
        return LinkLost(cause, gone)

    def _judge_absence(self) -> None:
        now = monotonic_ns()
        if self.is_linked:
            self._away_since = 0
            return
        self._away_since = self._away_since or now
        if self._connection.is_gone and not (self._news or self._is_told_gone):
            self._is_told_gone = True  # what was tried to come back has failed for good
            raise self._explained(self._connection.lost or closed())
        if now - self._away_since >= _AWAY_NS:
            why = self._connection.lost or LinkLost(LossCause.SILENT, Reason.of("link.it_does_not_answer"))
            raise self._explained(why)

    def _new_epoch(self, epoch: str) -> None:
        former, self._epoch = self._epoch, epoch
        if former:
            raise LinkLost(LossCause.CLOSED, Reason.of("link.started_anew"))


def _begins(message: request.Request) -> bool:
    """Whether something goes on after it whose last seconds are held."""
    match message:
        case request.Begin():
            return True
        case live.Change():
            return bool(message.on)
    return False


def black_box_in(reason: Reason) -> str:
    """The black box that a runtime has left, of which the reason of its loss tells; empty: none."""
    kept = reason.args.get("kept") if reason.key == "link.runtime_gone" else None
    return str(kept.args["path"]) if isinstance(kept, Reason) and "path" in kept.args else ""


def in_short(reason: Reason) -> Reason:
    """Why a runtime is gone, without what it printed last: that is for who looks closer."""
    if reason.key != "link.runtime_gone":
        return reason
    why, how, kept = (reason.args[name] for name in ("why", "how", "kept"))
    return Reason.of("link.runtime_gone", why=why, how=how, kept=kept, printed=NOTHING)


def why_lost(lost: LinkLost | TimeoutError) -> Reason:
    """Why a link is lost, in the words of whoever noticed."""
    return lost.reason if isinstance(lost, LinkLost) else reason_of(lost)
