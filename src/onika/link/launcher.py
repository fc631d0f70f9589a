"""The launcher: a runtime as a process under a guard of its own, on a link of its own (A15)."""

import ctypes
import os
import signal
import socket
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from onika.link.carrier import SocketCarrier
from onika.link.output_tail import OutputTail
from onika.link.runtime_process import RuntimeProcess
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


def launch(
    arguments: Sequence[str] = (),
    command: Sequence[str] = RUNTIME,
    frame_limit: int = FRAME_LIMIT,
    *,
    has_modules: bool = False,
) -> RuntimeProcess:
    """Start a runtime: the command, `--link-fd N --parent PID`, the arguments. Raises OSError when it cannot start.

    It inherits its end of the link under the number N and nothing else; its input is empty. One that executes
    modules has a group of its own: it does not get the signals of the terminal, and modules cannot end this program
    with their group. It has memory for its last words, too, under `--last-words N`.
    """
    memory = Segment.create("last-words", last_words.SIZE) if has_modules else None
    ours, theirs = socket.socketpair()
    lifeline, guard_lifeline = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    number = theirs.fileno()
    words = [*command, "--link-fd", str(number), "--parent", guard.OWN_PID, *arguments]
    passed = [number] if memory is None else [number, memory.fd]
    words += [] if memory is None else ["--last-words", str(memory.fd)]
    order = "\0".join(("own group" if has_modules else "", " ".join(map(str, passed)), *words))
    output, child_output = os.pipe()
    try:
        lifeline.send(order.encode("utf-8", "surrogateescape"))
        process = subprocess.Popen(  # noqa: S603  the command is ours or the caller's
            [sys.executable, "-I", "-S", _GUARD, "runtime", str(guard_lifeline.fileno())],
            stdin=subprocess.DEVNULL,
            stdout=child_output,
            stderr=child_output,
            pass_fds=(*passed, guard_lifeline.fileno()),
            env=UNDRAWN | os.environ | ONE_THREAD,
        )
    except OSError:
        ours.close()
        lifeline.close()
        os.close(output)
        raise
    finally:
        theirs.close()
        guard_lifeline.close()
        os.close(child_output)
    return RuntimeProcess(process, lifeline, SocketCarrier(ours, frame_limit), OutputTail(output), memory)


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
