"""Starting a process of the runtime: a Python file of this package on one end of a post, ended with its parent."""

import os
import socket
import subprocess
import sys

from onika.link.launcher import ONE_THREAD, UNDRAWN


def start(
    module: str,
    end: socket.socket,
    arguments: tuple[str, ...] = (),
    descriptors: tuple[int, ...] = (),
    *,
    own_group: bool = False,
) -> "subprocess.Popen[bytes]":
    """Start `python -m module --fd N --parent PID arguments`; `end` is closed here, the descriptors are inherited.

    A process that executes modules has a group of its own: one that ends its group ends nobody else.
    """
    words = [sys.executable, "-m", module, "--fd", str(end.fileno()), "--parent", str(os.getpid()), *arguments]
    environment = UNDRAWN | os.environ | ONE_THREAD
    process = subprocess.Popen(  # noqa: S603 - our own code, no shell
        words,
        stdin=subprocess.DEVNULL,
        pass_fds=(end.fileno(), *descriptors),
        env=environment,
        start_new_session=own_group,
    )
    end.close()
    return process
