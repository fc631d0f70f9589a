"""A runtime that was launched, as a process under its guard: its connection, its life and the last it printed."""

import os
import signal
import socket
import subprocess
from contextlib import suppress
from select import select
from types import TracebackType

from onika.link.carrier import SocketCarrier
from onika.link.child.output_tail import OutputTail
from onika.process import guard
from onika.ring.last_words import LastWords
from onika.ring.segment import Segment

_GUARD_S = 5.0
"""How long the guard may take to leave nothing of a runtime; it takes far less."""
_START_S = 60.0
"""And to begin: it is a Python of its own, and twenty may be begun at once on a machine with two processors."""


class RuntimeProcess:
    """A runtime that was launched: its connection, its life and the last it printed.

    Between it and this program is its guard, which leaves nothing of what the runtime or a module has started.
    """

    def __init__(
        self,
        guard_process: "subprocess.Popen[bytes]",
        lifeline: socket.socket,
        carrier: SocketCarrier,
        tail: OutputTail,
        memory: Segment | None = None,
    ) -> None:
        self.carrier = carrier
        self.last_words = None if memory is None else LastWords(memory.view)
        """Of one that executes modules: whose code runs, or ran when it ended, and why it ended itself."""
        self._guard = guard_process
        self._lifeline = lifeline
        self._tail = tail
        self._code: int | None = None
        self._pid = guard_process.pid  # until it says that of the runtime
        self._pid = self._started()

    @property
    def pid(self) -> int:
        """Its process id."""
        return self._pid

    def alive(self) -> bool:
        """Whether it runs."""
        return self._ended(0.0) is None

    @property
    def is_stopped(self) -> bool:
        """Whether the operating system holds it, so that it does nothing."""
        return guard.is_stopped(self._pid)

    def wait(self, timeout_s: float) -> int | None:
        """Its exit code, negative for the signal that ended it; None when it still runs after the time-out."""
        code = self._ended(timeout_s)
        if code is not None:
            self._tail.close()
        return code

    def tail(self) -> str:
        """What it printed last, on both outputs."""
        return self._tail.text()

    def terminate(self) -> None:
        """Ask it to end."""
        self._guard.terminate()

    def end_at_once(self) -> None:
        """End it now, whatever it does, from any thread; somebody else will see that it is gone."""
        guard.wake(self._guard.pid)
        with suppress(ProcessLookupError):
            os.kill(self._pid, signal.SIGKILL)

    def kill(self) -> int:
        """End it now, whatever it does; its exit code. Nothing of it is left."""
        if self._ended(0.0) is None:
            self.end_at_once()
        code = self._ended(_GUARD_S)
        self._leave_nothing()
        self._tail.close()
        return -signal.SIGKILL if code is None else code

    def close(self, grace_s: float = 2.0) -> int:
        """Close the connection, which ends a runtime by itself; kill it after the grace. Its exit code.

        One that is frozen would not see it: it is killed at once. A guard that is frozen is woken.
        """
        self.carrier.close()
        guard.wake(self._guard.pid)
        code = self._ended(0.0 if self.is_stopped else grace_s)
        if code is None:
            return self.kill()
        self._leave_nothing()
        self._tail.close()
        return code

    def __enter__(self) -> "RuntimeProcess":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    # Inner

    def _started(self) -> int:
        """The process id that the guard says; raises OSError when the runtime could not be started.

        A guard that is ended or frozen so early says nothing: the runtime counts as killed, and the link says so.
        """
        try:
            word, _, number = (self._words(_START_S) or "").partition(" ")
        except BaseException:
            self._guard.kill()  # not wanted any more, and perhaps frozen
            raise
        if word == "pid":
            return int(number)
        self._code = -signal.SIGKILL
        if word == "unstartable":
            self.close()
            raise OSError(int(number), os.strerror(int(number)))
        self._guard.kill()
        return self._guard.pid

    def _words(self, timeout_s: float) -> str | None:
        """What the guard says within this time: nothing at its end; None where it is silent."""
        if not select([self._lifeline], [], [], timeout_s)[0]:
            return None
        return self._lifeline.recv(100).decode()

    def _ended(self, timeout_s: float) -> int | None:
        """The exit code, as the guard says it; None while it says nothing for so long."""
        words = self._words(timeout_s) if self._code is None else None
        if words is not None:
            word, _, number = words.partition(" ")
            match word:
                case "exit":
                    self._code = int(number)
                case "signal":
                    self._code = -int(number)
                case _:  # the guard is gone, and the runtime with it: the kernel sees to that
                    self._code = -signal.SIGKILL
        return self._code

    def _leave_nothing(self) -> None:
        """Let the guard end whoever is left; one that cannot is ended itself."""
        self._lifeline.close()
        see_off(self._guard)


def see_off(guard_process: "subprocess.Popen[bytes]") -> None:
    """Wait until a guard whose lifeline is closed has ended all that was started; one that cannot is ended itself."""
    guard.wake(guard_process.pid)
    try:
        guard_process.wait(_GUARD_S)
    except subprocess.TimeoutExpired:
        guard_process.kill()
        guard_process.wait()
