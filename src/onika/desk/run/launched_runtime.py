"""A runtime that is launched as a child process, and ends with who launched it."""

import os
import signal
from collections.abc import Sequence
from contextlib import suppress
from time import monotonic_ns, sleep
from types import TracebackType

from onika.desk.run.runtime_conversation import PATIENCE_S, RuntimeConversation, why_lost
from onika.link.child.launcher import RuntimeStart, launch
from onika.link.child.runtime_process import RuntimeProcess
from onika.link.connection import Connection
from onika.link.link_terms import CHILD
from onika.link.lost import LinkLost, LossCause
from onika.process.standing_clock import StandingClock
from onika.record.black_box_folder import black_box_folder, black_box_of, is_being_written
from onika.ring.last_words import LastWords
from onika.wire import request
from onika.words.reason import NOTHING, Reason

_STOP_PATIENCE_S = 1.5
"""How long a runtime that was launched here may leave Stop or Abort without an answer before it is ended."""
_START_GRACE_S = 0.5
"""How long a runtime that is not wanted any more while it starts has to end by itself: nothing has moved yet."""
_BLACK_BOX_NS = 1_000_000_000
"""How long to wait for the black box of a runtime that has died."""
_WRITTEN_NS = 1_500_000_000
"""And how long where it is being written then."""
_LOOK_S = 0.02


class LaunchedRuntime(RuntimeConversation):
    """A runtime that is launched here; ends with the `with` block, and so do all its processes."""

    def __init__(
        self,
        rtpus: Sequence[str],
        is_virtual: bool,
        with_fifo: bool = True,
        options: Sequence[str] = (),
        has_black_box: bool = True,
        start: RuntimeStart | None = None,
    ) -> None:
        """
        start   one that comes up already, with modules where time is virtual; it waits for its arguments
        """
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
        self._child: RuntimeProcess = (
            launch([*words, *options], has_modules=is_virtual) if start is None else start.process([*words, *options])
        )
        self._may_rest = is_virtual
        self._clock = StandingClock(monotonic_ns)
        super().__init__(Connection(self._child.carrier, self._clock, CHILD))
        self._stop_patience_s = _STOP_PATIENCE_S

    def ask(self, message: request.Request) -> request.Response:
        """Ask and wait for the response; a runtime that does not answer Stop or Abort soon is frozen, and is ended."""
        try:
            return super().ask(message)
        except TimeoutError:
            if not isinstance(message, request.Stop | request.Abort):
                raise
            why = _unanswered(self._child)
            self._child.kill()
            raise LinkLost(LossCause.SILENT, why) from None

    def __enter__(self) -> "LaunchedRuntime":
        try:
            self._connection.open(PATIENCE_S)
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

    def rest(self) -> bool:
        """Have the system hold a simulator in which nothing happens: it costs nothing, and keeps all that it has.

        Whether it rests. A robot's runtime never does: its heartbeats would stop.
        """
        if self._may_rest and self._child.alive():
            os.kill(self._child.pid, signal.SIGSTOP)
            self._clock.stand()
            return True
        return False

    def wake(self) -> None:
        """It goes on where it was: its time has stood, and neither end takes the rest for silence."""
        self._clock.go_on(CHILD.beat_ns)
        self._news += self._connection.poll()  # a heartbeat lies there for it when it wakes
        with suppress(ProcessLookupError):
            os.kill(self._child.pid, signal.SIGCONT)

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
        folder, process, begin = black_box_folder(os.environ), self._child.pid, monotonic_ns()
        while (path := black_box_of(folder, process)) is None:
            waited_ns = monotonic_ns() - begin
            if waited_ns > (_WRITTEN_NS if is_being_written(folder, process) else _BLACK_BOX_NS):
                return ""
            sleep(_LOOK_S)
        return str(path)

    def _explained(self, lost: LinkLost | TimeoutError) -> LinkLost:
        cause = lost.cause if isinstance(lost, LinkLost) else LossCause.SILENT
        code = self._child.wait(0.5)
        how = NOTHING if code is None else _ended(code, self._child.last_words)
        output = self._child.tail().strip()[-2000:]
        printed = Reason.of("link.printed_last", output=output) if output else NOTHING
        black_box = "" if code == 0 else self.black_box()
        kept = Reason.of("link.black_box", path=black_box) if black_box else NOTHING
        gone = Reason.of("link.runtime_gone", why=why_lost(lost), how=how, kept=kept, printed=printed)
        return LinkLost(cause, gone)


def _ended(code: int, last_words: LastWords | None) -> Reason:
    """How it ended, as it said itself where it could, else with the task whose code ran."""
    if last_words is not None and last_words.reason:
        return Reason.of("link.gave_up", why=last_words.reason)
    task = "" if last_words is None else last_words.task
    during = Reason.of("link.in_call", task=task) if task else NOTHING
    if code < 0:
        return Reason.of("link.killed_by_signal", signal=-code, during=during)
    return Reason.of("link.ended_with_code", code=code, during=during)


def _unanswered(child: RuntimeProcess) -> Reason:
    """Why it does not answer: the system holds it, wherever it was just then, or a call does not return."""
    task = "" if child.last_words is None or child.is_stopped else child.last_words.task
    if task:
        return Reason.of("link.caught_in_call", seconds=_STOP_PATIENCE_S, task=task)
    return Reason.of("link.frozen", seconds=_STOP_PATIENCE_S)
