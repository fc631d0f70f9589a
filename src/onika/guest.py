"""The front door of guests: a program of another framework carries out actions of a flow (requirement A20).

class Expert(GuestProgram):
    name = "expert"

    @action
    def which(self, errand: Errand) -> ActionResult:
        return ActionResult(flow=2)

Expert().serve()

Nothing but Python's own library is needed here. A guest in another language speaks the same lines (docs/partners.md).
"""

import contextlib
import errno
import json
import os
import signal
import socket
import struct
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, TypeVar

LONGEST = 1 << 16
"""Bytes of one line, in either direction."""
_MOMENT_S = 3.0
"""How long an address may still be taken by a guest that ends."""
_ENDING_S = 0.8
"""How long an action has when the program is asked to end: after a second it is killed."""
_WORDS = 200
"""Characters of an error, or of what is said, that are told."""


class GuestError(Exception):
    """An action cannot be carried out; its text is what the flow stops with."""


@dataclass(frozen=True, slots=True)
class ActionResult:
    """How an action ended well.

    flow    which branch the flow takes, from 0
    loop    whether a loop that ends here goes round again
    values  of outputs of the task that asked, by their names: numbers, lists of numbers, or texts
    says    what users shall read, as a warning of that task; up to 200 characters
    """

    flow: int = 0
    loop: bool = False
    values: Mapping[str, Any] = field(default_factory=dict)
    says: str = ""


@dataclass(frozen=True, slots=True)
class Errand:
    """An action that a flow asks for, as long as it is under way.

    action  its name
    task    who asks, SUBSYSTEM/TASK
    target  the data of its target, by their names; empty where it has none
    values  what the inputs of the task that asks hold, by their names
    """

    action: str
    task: str
    target: Mapping[str, Any]
    values: Mapping[str, Any]
    _stopped: threading.Event = field(default_factory=threading.Event, repr=False)

    @property
    def is_stopped(self) -> bool:
        """Whether nobody waits for it any more: the run was stopped, or its runtime is gone. Then end it."""
        return self._stopped.is_set()

    def wait(self, seconds: float) -> bool:
        """Wait so long, in seconds, or until it is stopped; gives whether it is."""
        return self._stopped.wait(seconds)

    def stop(self) -> None:
        """Let whoever carries it out know that it is stopped."""
        self._stopped.set()


Deed = TypeVar("Deed", bound=Callable[..., ActionResult | int | None])


def action(deed: Deed) -> Deed:
    """Marks a method of a guest as an action, by its name; it takes an `Errand`.

    It gives an `ActionResult`, a number, which is the flow to take, or nothing: flow 0. It raises `GuestError` where
    the action cannot be carried out. It may take as long as it needs, and looks at `errand.is_stopped` meanwhile.
    """
    deed.is_guest_action = True  # type: ignore[attr-defined]
    return deed


class GuestProgram:
    """Subclass this, name it, and mark its actions.

    Several flows may ask at the same time: each action under way has a thread of its own.
    """

    name = ""

    @property
    def actions(self) -> dict[str, Callable[[Errand], ActionResult | int | None]]:
        """What it can carry out, by name."""
        names = [name for name in dir(type(self)) if hasattr(getattr(type(self), name), "is_guest_action")]
        return {name: getattr(self, name) for name in names}

    def serve(self, at: str = "") -> None:
        """Listen at `unix:PATH`, `unix:@NAME` or `tcp:HOST:PORT` for ever.

        Without an address it listens where ONIKA_PARTNER says, else standard input and output are the conversation.
        Raises OSError where it cannot listen there, ValueError where that is no address.

        When the program is asked to end (SIGTERM), or its input ends, actions under way are stopped, and have a moment.
        """
        address = at or os.environ.get("ONIKA_PARTNER", "")
        connections: list[_Connection] = []
        _leave_when_asked()
        try:
            if address:
                self._listen(address, connections)
            else:
                connections.append(_Connection(self, sys.stdin.buffer, sys.stdout.buffer))
                connections[0].converse()
        finally:
            _end_all(connections)

    def _listen(self, address: str, connections: "list[_Connection]") -> None:
        with _listening(address) as server:
            while True:
                line, _ = server.accept()
                threading.Thread(target=self._meet, args=(line, connections), daemon=True).start()

    def _meet(self, line: socket.socket, connections: "list[_Connection]") -> None:
        if not _is_own(line):
            line.close()
            return
        with line, line.makefile("rb") as questions, line.makefile("wb") as answers, contextlib.suppress(OSError):
            connections.append(connection := _Connection(self, questions, answers))
            connection.converse()
            if not connection.is_busy:
                connections.remove(connection)


class _Connection:
    """One task that has called; what it asked last is under way until it is answered or the task hangs up."""

    def __init__(self, guest: GuestProgram, questions: BinaryIO, answers: BinaryIO) -> None:
        self._guest = guest
        self._questions = questions
        self._answers = answers
        self._errand: Errand | None = None
        self._work: threading.Thread | None = None

    @property
    def is_busy(self) -> bool:
        """Whether an action is still carried out, stopped or not."""
        return self._work is not None and self._work.is_alive()

    def stop(self) -> None:
        """Nobody waits any more for what is under way."""
        if self._errand is not None:
            self._errand.stop()

    def wait(self, seconds: float) -> None:
        """Wait for the action that is under way, but so long at most."""
        if self._work is not None:
            self._work.join(seconds)

    def converse(self) -> None:
        """Until the other side hangs up, or says what is no question: then what is under way is stopped."""
        try:
            while (question := _question(self._questions.readline(LONGEST + 1))) is not None:
                self._take(question)
        finally:
            self.stop()

    def _take(self, question: dict[str, Any]) -> None:
        number = question["id"]
        match question.get("ask"):
            case "hello":
                self._answer(number, {"guest": self._guest.name, "actions": sorted(self._guest.actions)})
            case "do":
                self._begin(number, question)
            case other:
                self._answer(number, {"error": f"expected to be asked do or hello, not {other}"})

    def _begin(self, number: int, question: dict[str, Any]) -> None:
        name, actions = str(question.get("action", "")), self._guest.actions
        if name not in actions:
            self._answer(number, {"error": f"expected an action of {', '.join(sorted(actions))}, found {name}"})
            return
        target, values = question.get("target"), question.get("values")
        self._errand = Errand(
            name,
            str(question.get("task", "")),
            target if isinstance(target, dict) else {},
            values if isinstance(values, dict) else {},
        )
        deed, errand = actions[name], self._errand
        self._work = threading.Thread(target=self._carry_out, args=(number, deed, errand), daemon=True)
        self._work.start()

    def _carry_out(self, number: int, deed: Callable[[Errand], ActionResult | int | None], errand: Errand) -> None:
        answer = _outcome_of(deed, errand)
        if not errand.is_stopped:
            with contextlib.suppress(OSError, ValueError):  # it has hung up in this moment
                self._answer(number, answer)

    def _answer(self, number: int, fields: dict[str, Any]) -> None:
        self._answers.write(json.dumps({"id": number, **fields}).encode() + b"\n")
        self._answers.flush()


def _leave_when_asked() -> None:
    """Have SIGTERM end the program in order, where nobody else has a use for it; only the main thread can say that."""
    if threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGTERM) is signal.SIG_DFL:
        signal.signal(signal.SIGTERM, lambda number, _frame: sys.exit(128 + number))


def _end_all(connections: list[_Connection]) -> None:
    """Stop what is under way, and give it a moment: what it holds, a robot perhaps, is to be left in order."""
    for connection in connections:
        connection.stop()
    until = time.monotonic() + _ENDING_S
    for connection in connections:
        connection.wait(max(0.0, until - time.monotonic()))


def _outcome_of(deed: Callable[[Errand], ActionResult | int | None], errand: Errand) -> dict[str, Any]:
    """The fields of the answer."""
    try:
        gives = deed(errand)
        outcome = gives if isinstance(gives, ActionResult) else ActionResult(flow=gives or 0)
        fields = {"flow": outcome.flow, "loop": outcome.loop, "values": dict(outcome.values)}
        fields |= {"says": outcome.says[:_WORDS]} if outcome.says else {}
        json.dumps(fields, allow_nan=False)
    except GuestError as wrong:
        return {"error": str(wrong)[:_WORDS]}
    except Exception as wrong:
        traceback.print_exc()
        return {"error": f"{type(wrong).__name__}: {wrong}"[:_WORDS]}
    return fields


def _question(line: bytes) -> dict[str, Any] | None:
    """What a line asks; None where it is no question."""
    try:
        question = json.loads(line) if line.endswith(b"\n") else None
    except (ValueError, RecursionError):
        return None
    return question if isinstance(question, dict) and type(question.get("id")) is int else None


@contextlib.contextmanager
def _listening(address: str) -> Iterator[socket.socket]:
    kind, _, place = address.partition(":")
    host, _, port = place.rpartition(":")
    if kind == "unix" and place.startswith("@"):
        with _bound(f"\0{place[1:]}") as server:
            yield server
    elif kind == "unix" and place:
        with _at_path(place) as server:
            yield server
    elif kind == "tcp" and host and port.isdecimal():
        with socket.create_server((host.strip("[]"), int(port))) as server:
            yield server
    else:
        raise ValueError(f"expected unix:PATH or tcp:HOST:PORT, found {address}")


@contextlib.contextmanager
def _at_path(place: str) -> Iterator[socket.socket]:
    """Listen at a path; what a guest that was killed has left there goes, and whoever is just ending has a moment."""
    until = time.monotonic() + _MOMENT_S
    while _is_answered(place):
        if time.monotonic() > until:
            raise OSError(f"somebody listens at {place} already")
        time.sleep(0.02)
    with _bound(place) as server:
        try:
            yield server
        finally:
            Path(place).unlink(missing_ok=True)


def _is_answered(place: str) -> bool:
    """Whether somebody listens at a path; a path at which nobody does any more is taken away."""
    with socket.socket(socket.AF_UNIX) as other:
        try:
            other.connect(place)
        except ConnectionRefusedError:
            Path(place).unlink(missing_ok=True)
            return False
        except FileNotFoundError:
            return False
    return True


def _bound(place: str) -> socket.socket:
    """Listen there; whoever is just ending there has a moment for it."""
    server, until = socket.socket(socket.AF_UNIX), time.monotonic() + _MOMENT_S
    while True:
        try:
            server.bind(place)
            server.listen()
        except OSError as wrong:
            if wrong.errno != errno.EADDRINUSE or time.monotonic() > until:
                server.close()
                raise
            time.sleep(0.02)
        else:
            return server


def _is_own(line: socket.socket) -> bool:
    """Whether who calls without a network is this user, or the system's; over TCP nobody can tell."""
    if line.family != socket.AF_UNIX:
        return True
    _, user, _ = struct.unpack("3i", line.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i")))
    return user in (0, os.getuid())
