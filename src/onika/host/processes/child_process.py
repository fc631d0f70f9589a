"""Starting a process of the runtime: a Python file of this package on one end of a post, ended with its parent."""

import os
import socket
import subprocess
import sys
from typing import Protocol

from onika.host.processes.fork_server import BeginProcess, ForkServer
from onika.link.child.launcher import ONE_THREAD, UNDRAWN


class ChildProcess(Protocol):
    """A process that this one has started, as `subprocess.Popen` shows it."""

    @property
    def pid(self) -> int:
        """Its process id."""
        ...

    @property
    def returncode(self) -> int | None:
        """Its exit code, negative for a signal; None as long as nobody has seen it end."""
        ...

    def poll(self) -> int | None:
        """Its exit code; None while it lives."""
        ...

    def wait(self, timeout: float | None = None) -> int:
        """Its exit code, when it has ended; raises subprocess.TimeoutExpired."""
        ...

    def kill(self) -> None:
        """End it now."""
        ...


_fork_servers: list[ForkServer] = []  # one or none


def serve_forks() -> ForkServer | None:
    """From now on processes begin as copies of what is loaded by now; None where there is no room for the server."""
    try:
        fork_server = ForkServer()
    except OSError:
        return None
    _fork_servers.append(fork_server)
    return fork_server


def preload_forks() -> None:
    """Have the fork server load the big libraries once, for all that are begun later; nothing waits for it."""
    if _fork_servers:
        _fork_servers[0].preload()


def start(
    module: str,
    end: socket.socket,
    arguments: tuple[str, ...] = (),
    descriptors: tuple[int, ...] = (),
    *,
    own_group: bool = False,
) -> ChildProcess:
    """Start `python -m module arguments --fd N --parent PID`; `end` is closed here, the descriptors are inherited.

    A process that executes modules has a group of its own: one that ends its group ends nobody else.
    """
    words = (*arguments, "--fd", str(end.fileno()), "--parent", str(os.getpid()))
    passed = (end.fileno(), *descriptors)
    forked = _forked(BeginProcess(module, words, passed, own_group))
    process = forked or subprocess.Popen(  # noqa: S603 - our own code, no shell
        [sys.executable, "-m", module, *words],
        stdin=subprocess.DEVNULL,
        pass_fds=passed,
        env=UNDRAWN | os.environ | ONE_THREAD,
        start_new_session=own_group,
    )
    end.close()
    return process


def _forked(order: BeginProcess) -> ChildProcess | None:
    """The process as a copy; None where nobody makes copies, or does no more: then each is started by itself."""
    forked = _fork_servers[0].begin(order, order.numbers) if _fork_servers else None
    if forked is None:
        _fork_servers.clear()
    return forked
