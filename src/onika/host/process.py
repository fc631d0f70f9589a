"""Starting a process of the runtime: a Python file of this package on one end of a post, ended with its parent."""

import os
import socket
import subprocess
import sys

_ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""Linear algebra in one thread: the same sums in the same order every time (law 14)."""


def start(
    module: str, end: socket.socket, arguments: tuple[str, ...] = (), descriptors: tuple[int, ...] = ()
) -> "subprocess.Popen[bytes]":
    """Start `python -m module --fd N --parent PID arguments`; `end` is closed here, the descriptors are inherited."""
    words = [sys.executable, "-m", module, "--fd", str(end.fileno()), "--parent", str(os.getpid()), *arguments]
    environment = os.environ | dict.fromkeys(_ONE_THREAD, "1")
    process = subprocess.Popen(  # noqa: S603 - our own code, no shell
        words, stdin=subprocess.DEVNULL, pass_fds=(end.fileno(), *descriptors), env=environment
    )
    end.close()
    return process
