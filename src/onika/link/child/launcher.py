"""The launcher: a runtime as a process under a guard of its own, on a link of its own (A15)."""

import ctypes
import json
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType

from onika.link.carrier import SocketCarrier
from onika.link.child.output_tail import OutputTail
from onika.link.child.runtime_process import RuntimeProcess, see_off
from onika.process import guard
from onika.ring import last_words
from onika.ring.segment import Segment
from onika.wire.frame import FRAME_LIMIT

RUNTIME = (sys.executable, "-m", "onika.host")
"""The command that starts a runtime."""

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
"""Linear algebra in one thread: the same sums in the same order every time (law 14)."""

_PR_SET_PDEATHSIG = 1
_GUARD = str(Path(guard.__file__))

UNDRAWN = {"MUJOCO_GL": "disable"}
"""A runtime draws nothing: else each of its processes, when it loads MuJoCo, would start another to look for a screen.
Whoever has named a way to draw gets it all the same."""


class RuntimeStart:
    """A runtime that comes up: the command, `--link-fd N --parent PID`, the arguments. Raises OSError when it cannot.

    It inherits its end of the link under the number N and nothing else; its input is empty. One that executes
    modules has a group of its own: it does not get the signals of the terminal, and modules cannot end this program
    with their group. It has memory for its last words, too, under `--last-words N`.

    Whoever does not know all arguments yet lets them follow: `--options-fd N` is where it reads them, and it ends
    where none come. So it loads its libraries while this program finds out what it is for.
    """

    def __init__(
        self,
        arguments: Sequence[str] = (),
        command: Sequence[str] = RUNTIME,
        *,
        has_modules: bool = False,
        has_more: bool = False,
    ) -> None:
        self._memory = Segment.create("last-words", last_words.SIZE) if has_modules else None
        self._ours, theirs = socket.socketpair()
        self._lifeline, guard_lifeline = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._more: int | None = None
        more = None
        if has_more:
            more, self._more = os.pipe()
        self._is_taken = False
        inherited = {"--link-fd": theirs.fileno(), "--options-fd": more}
        if self._memory is not None:
            inherited["--last-words"] = self._memory.fd
        passed = {option: str(number) for option, number in inherited.items() if number is not None}
        words = [*command, *(word for pair in passed.items() for word in pair), "--parent", guard.OWN_PID, *arguments]
        order = "\0".join(("own group" if has_modules else "", " ".join(passed.values()), *words))
        self._output, child_output = os.pipe()
        try:
            self._lifeline.send(order.encode("utf-8", "surrogateescape"))
            self._guard = subprocess.Popen(  # noqa: S603  the command is ours or the caller's
                [sys.executable, "-I", "-S", _GUARD, "runtime", str(guard_lifeline.fileno())],
                stdin=subprocess.DEVNULL,
                stdout=child_output,
                stderr=child_output,
                pass_fds=(*map(int, passed.values()), guard_lifeline.fileno()),
                env=UNDRAWN | os.environ | ONE_THREAD,
            )
        except OSError:
            self._let_go()
            raise
        finally:
            theirs.close()
            guard_lifeline.close()
            os.close(child_output)
            if more is not None:
                os.close(more)

    def process(self, more: Sequence[str] = (), frame_limit: int = FRAME_LIMIT) -> RuntimeProcess:
        """The runtime, which is told the arguments that follow; once. Raises OSError when it could not be started."""
        if self._more is not None:
            with suppress(BrokenPipeError), os.fdopen(self._more, "w") as told:  # one that is gone says so itself
                json.dump([*more], told)
            self._more = None
        self._is_taken = True
        carrier = SocketCarrier(self._ours, frame_limit)
        return RuntimeProcess(self._guard, self._lifeline, carrier, OutputTail(self._output), self._memory)

    def close(self) -> None:
        """End one that nobody has taken."""
        if not self._is_taken:
            self._let_go()
            see_off(self._guard)

    def __enter__(self) -> "RuntimeStart":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _let_go(self) -> None:
        self._ours.close()
        self._lifeline.close()
        os.close(self._output)
        if self._more is not None:
            os.close(self._more)


def launch(
    arguments: Sequence[str] = (),
    command: Sequence[str] = RUNTIME,
    frame_limit: int = FRAME_LIMIT,
    *,
    has_modules: bool = False,
) -> RuntimeProcess:
    """Start a runtime, all of whose arguments are known, and wait until it is there; raises OSError."""
    return RuntimeStart(arguments, command, has_modules=has_modules).process((), frame_limit)


def inherit(descriptor: int, frame_limit: int = FRAME_LIMIT) -> SocketCarrier:
    """In the child: its end of the link, which its own children do not inherit."""
    connected = socket.socket(fileno=descriptor)
    connected.set_inheritable(False)
    return SocketCarrier(connected, frame_limit)


def die_with_parent(expected_ppid: int, signum: int = signal.SIGKILL) -> None:
    """In the child, first of all: be sent the signal when the parent is gone; end at once when it is gone already.

    Linux only; elsewhere the end of the link has to be enough. What counts is the thread of the parent that launched.
    """
    if sys.platform.startswith("linux"):
        library = ctypes.CDLL(None, use_errno=True)
        if library.prctl(_PR_SET_PDEATHSIG, int(signum), 0, 0, 0) != 0:
            code = ctypes.get_errno()
            raise OSError(code, os.strerror(code))
    if os.getppid() != expected_ppid:
        os._exit(1)
