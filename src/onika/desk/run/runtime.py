"""A client's view of a runtime: a child process that it launches, or one elsewhere that it reaches over the link."""

import os
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import monotonic_ns, sleep
from types import TracebackType

from onika.link.address import Address
from onika.link.connection import Connection
from onika.link.connector import ThreadConnector
from onika.link.launcher import RuntimeProcess, launch
from onika.link.link_events import (
    EpochChanged,
    LinkNotice,
    LinkStateChanged,
    ReadingReceived,
    ReplyReceived,
    RequestFailed,
    SignalReceived,
)
from onika.link.link_terms import CHILD, REMOTE
from onika.link.lost import LinkLost, LossCause
from onika.link.state import LinkState
from onika.link.token import read_token, token_path
from onika.link.websocket_opening import WebSocketOpening
from onika.record.black_box_folder import black_box_folder, black_box_of
from onika.ring.last_words import LastWords
from onika.wire import event, live, request
from onika.wire.foresight import WhatIf
from onika.words.reason import NOTHING, Reason

_PATIENCE_S = 60.0
_STOP_PATIENCE_S = 1.5
"""How long a runtime that was launched here may leave Stop or Abort without an answer before it is ended."""
_START_GRACE_S = 0.5
"""How long a runtime that is not wanted any more while it starts has to end by itself: nothing has moved yet."""
_BLACK_BOX_NS = 1_000_000_000
"""How long to wait for the black box of a runtime that has died."""
_LOOK_S = 0.02
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


class RuntimeConversation:
    """Questions, events and readings of one runtime, however it is reached."""

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._stop_patience_s = _PATIENCE_S
        self._news: deque[LinkNotice] = deque()
        self._readings: dict[str, bytes] = {}
        self._epoch = ""
        self._away_since = 0
        self._has_begun = False
        """Whether a run was asked for."""

    @property
    def pid(self) -> int | None:
        """The process id of the runtime program, None where it was not launched from here."""
        return None

    @property
    def is_linked(self) -> bool:
        """Whether the runtime is heard at present."""
        return self._connection.state in (LinkState.LINKED, LinkState.SUSPECT)

    def ask(self, message: request.Request) -> request.Response:
        """Ask and wait for the response; raises LinkLost with what the runtime printed last, or TimeoutError."""
        once = not isinstance(message, _AGAIN)
        urgent = isinstance(message, request.Stop | request.Abort)
        self._has_begun |= isinstance(message, request.Begin)
        try:
            patience_s = self._stop_patience_s if urgent else _PATIENCE_S
            body = self._connection.request(request.encode(message), patience_s, once=once, urgent=urgent or once)
        except LinkLost as lost:
            raise self._explained(lost) from None
        response: request.Response = request.decode_response(body)
        return response

    def send(self, message: request.Request) -> int:
        """Ask without waiting, what ends motion before all that waits; `told` has the reply under this number."""
        once = not isinstance(message, _AGAIN)
        urgent = isinstance(message, request.Stop | request.Abort)
        self._has_begun |= isinstance(message, request.Begin)
        return self._connection.ask(request.encode(message), _PATIENCE_S, once=once, urgent=urgent or once)

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
        gone = Reason.of("link.runtime_gone", why=_why(lost), how=NOTHING, kept=NOTHING, printed=NOTHING)
        return LinkLost(cause, gone)

    def _judge_absence(self) -> None:
        now = monotonic_ns()
        if self.is_linked:
            self._away_since = 0
            return
        self._away_since = self._away_since or now
        if now - self._away_since >= _AWAY_NS:
            why = self._connection.lost or LinkLost(LossCause.SILENT, Reason.of("link.it_does_not_answer"))
            raise self._explained(why)

    def _new_epoch(self, epoch: str) -> None:
        former, self._epoch = self._epoch, epoch
        if former:
            raise LinkLost(LossCause.CLOSED, Reason.of("link.started_anew"))


class LaunchedRuntime(RuntimeConversation):
    """A runtime that is launched here; ends with the `with` block, and so do all its processes."""

    def __init__(
        self,
        rtpus: Sequence[str],
        is_virtual: bool,
        with_fifo: bool = True,
        options: Sequence[str] = (),
        has_black_box: bool = True,
    ) -> None:
        words = [word for name in rtpus for word in ("--rtpu", name)]
        if is_virtual:
            words.append("--virtual")
        if not with_fifo:
            words.append("--no-fifo")
        if not has_black_box:
            words.append("--no-black-box")
        self._has_black_box = has_black_box and not is_virtual
        """Whether there is one that outlives a runtime."""
        self._black_box: str | None = None
        self._child: RuntimeProcess = launch([*words, *options], has_modules=is_virtual)
        super().__init__(Connection(self._child.carrier, monotonic_ns, CHILD))
        self._stop_patience_s = _STOP_PATIENCE_S

    def ask(self, message: request.Request) -> request.Response:
        """Ask and wait for the response; a runtime that does not answer Stop or Abort soon is frozen, and is ended."""
        try:
            return super().ask(message)
        except TimeoutError:
            if not isinstance(message, request.Stop | request.Abort):
                raise
            self._child.kill()
            raise LinkLost(LossCause.SILENT, _frozen(self._child.last_words)) from None

    def __enter__(self) -> "LaunchedRuntime":
        try:
            self._connection.open(_PATIENCE_S)
        except (LinkLost, TimeoutError) as lost:
            self._child.close()
            raise self._explained(lost) from None
        except BaseException:
            self._child.close(_START_GRACE_S)
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._connection.close(timeout_s=0.2)
        self._child.close()

    @property
    def pid(self) -> int | None:
        """The process id of the runtime program."""
        return self._child.pid

    def end_at_once(self) -> None:
        """Kill it, from any thread: whoever waits for it finds that it is gone."""
        self._child.end_at_once()

    def printed(self) -> str:
        """What the runtime and its processes printed last."""
        return self._child.tail()

    def black_box(self) -> str:
        """The file in which the last seconds of its run stand, if it has died; it is written just now."""
        if self._black_box is None:
            self._black_box = self._find_black_box() if self._has_black_box and self._has_begun else ""
        return self._black_box

    def _find_black_box(self) -> str:
        """Wait for it: whoever is told that the runtime is gone is told in the same sentence where to look."""
        folder, until = black_box_folder(os.environ), monotonic_ns() + _BLACK_BOX_NS
        while monotonic_ns() < until:
            path = black_box_of(folder, self._child.pid)
            if path is not None:
                return str(path)
            sleep(_LOOK_S)
        return ""

    def _explained(self, lost: LinkLost | TimeoutError) -> LinkLost:
        cause = lost.cause if isinstance(lost, LinkLost) else LossCause.SILENT
        code = self._child.wait(0.5)
        how = NOTHING if code is None else _ended(code, self._child.last_words)
        output = self._child.tail().strip()[-2000:]
        printed = Reason.of("link.printed_last", output=output) if output else NOTHING
        black_box = "" if code == 0 else self.black_box()
        kept = Reason.of("link.black_box", path=black_box) if black_box else NOTHING
        gone = Reason.of("link.runtime_gone", why=_why(lost), how=how, kept=kept, printed=printed)
        return LinkLost(cause, gone)


class RemoteRuntime(RuntimeConversation):
    """A runtime that somebody else started; it lives on after the `with` block."""

    def __init__(self, opening: WebSocketOpening) -> None:
        self._opening = opening
        super().__init__(Connection(None, monotonic_ns, REMOTE, connector=ThreadConnector(opening)))

    def __enter__(self) -> "RemoteRuntime":
        try:
            self._connection.open(REMOTE.greeting_ns / 1e9)
        except (LinkLost, TimeoutError) as lost:
            self._connection.close(timeout_s=0.0)
            if isinstance(lost, LinkLost):
                raise
            late = Reason.of("link.late", address=str(self._opening.address), why=Reason.plain(str(lost)))
            raise LinkLost(LossCause.TIMEOUT, late) from None
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._connection.close(timeout_s=0.5)


def connect(url: str, token: str = "", ca: Path | None = None) -> RemoteRuntime:
    """A runtime at an address; raises ValueError for what is no address, LinkLost where no token is to be had.

    token   empty: that of ONIKA_TOKEN, or on this machine the one in the user's state directory
    ca      a file of certificates to trust beside the system's
    """
    address = Address.parse(url)
    return RemoteRuntime(WebSocketOpening(address, token or _token(address), ca))


def in_short(reason: Reason) -> Reason:
    """Why a runtime is gone, without what it printed last: that is for who looks closer."""
    if reason.key != "link.runtime_gone":
        return reason
    why, how, kept = (reason.args[name] for name in ("why", "how", "kept"))
    return Reason.of("link.runtime_gone", why=why, how=how, kept=kept, printed=NOTHING)


def _token(address: Address) -> str:
    from_environment = os.environ.get("ONIKA_TOKEN", "")
    if from_environment:
        return from_environment
    try:
        if address.is_near:
            return read_token(token_path())
        return _missing(address)
    except (OSError, ValueError):
        return _missing(address)


def _missing(address: Address) -> str:
    raise LinkLost(LossCause.TOKEN, Reason.of("link.token_needed", address=str(address)))


def _why(lost: LinkLost | TimeoutError) -> Reason:
    if isinstance(lost, LinkLost):
        return lost.reason
    return Reason.plain(str(lost))


def _ended(code: int, last_words: LastWords | None) -> Reason:
    """How it ended, as it said itself where it could, else with the task whose code ran."""
    if last_words is not None and last_words.reason:
        return Reason.of("link.gave_up", why=last_words.reason)
    task = "" if last_words is None else last_words.task
    during = Reason.of("link.in_call", task=task) if task else NOTHING
    if code < 0:
        return Reason.of("link.killed_by_signal", signal=-code, during=during)
    return Reason.of("link.ended_with_code", code=code, during=during)


def _frozen(last_words: LastWords | None) -> Reason:
    task = "" if last_words is None else last_words.task
    if task:
        return Reason.of("link.caught_in_call", seconds=_STOP_PATIENCE_S, task=task)
    return Reason.of("link.frozen", seconds=_STOP_PATIENCE_S)
