"""The launcher: a runtime as a child process of the environment, on a link of its own (A15)."""

import ctypes
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Sequence
from types import TracebackType

from onika.link.carrier import SocketCarrier
from onika.link.output_tail import OutputTail
from onika.wire.frame import FRAME_LIMIT

RUNTIME = (sys.executable, "-m", "onika.host")
"""The command that starts a runtime."""

ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
"""Linear algebra in one thread: the same sums in the same order every time (law 14)."""

_PR_SET_PDEATHSIG = 1


class RuntimeProcess:
    """A runtime that was launched: its connection, its life and the last it printed."""

    def __init__(self, process: "subprocess.Popen[bytes]", carrier: SocketCarrier, tail: OutputTail) -> None:
        self.carrier = carrier
        self._process = process
        self._tail = tail

    @property
    def pid(self) -> int:
        """Its process id."""
        return self._process.pid

    def alive(self) -> bool:
        """Whether it runs; one that has ended is no zombie after this call."""
        return self._process.poll() is None

    def wait(self, timeout_s: float) -> int | None:
        """Its exit code, negative for the signal that ended it; None when it still runs after the time-out."""
        try:
            code = self._process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            return None
        self._tail.close()
        return code

    def tail(self) -> str:
        """What it printed last, on both outputs."""
        return self._tail.text()

    def terminate(self) -> None:
        """Ask it to end."""
        self._process.terminate()

    def kill(self) -> int:
        """End it now, whatever it does; its exit code."""
        self._process.kill()
        code = self._process.wait()
        self._tail.close()
        return code

    def close(self, grace_s: float = 2.0) -> int:
        """Close the connection, which ends a runtime by itself; kill it after the grace. Its exit code."""
        self.carrier.close()
        code = self.wait(grace_s)
        return self.kill() if code is None else code

    def __enter__(self) -> "RuntimeProcess":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()


def launch(
    arguments: Sequence[str] = (), command: Sequence[str] = RUNTIME, frame_limit: int = FRAME_LIMIT
) -> RuntimeProcess:
    """Start a runtime: the command, `--link-fd N --parent PID`, the arguments. Raises OSError when it cannot start.

    The child inherits its end of the link under the number N and nothing else; its input is empty.
    """
    ours, theirs = socket.socketpair()
    words = [*command, "--link-fd", str(theirs.fileno()), "--parent", str(os.getpid()), *arguments]
    output, child_output = os.pipe()
    try:
        process = subprocess.Popen(  # noqa: S603  the command is ours or the caller's
            words,
            stdin=subprocess.DEVNULL,
            stdout=child_output,
            stderr=child_output,
            pass_fds=(theirs.fileno(),),
            env=os.environ | ONE_THREAD,
        )
    except OSError:
        ours.close()
        os.close(output)
        raise
    finally:
        theirs.close()
        os.close(child_output)
    return RuntimeProcess(process, SocketCarrier(ours, frame_limit), OutputTail(output))


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
