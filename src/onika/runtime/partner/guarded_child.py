"""A program that a task has started, under its guard process: it ends with its task, whatever ends that (F04)."""

import contextlib
import os
import signal
import socket
import sys
from collections.abc import Sequence
from pathlib import Path

from onika.process import guard
from onika.words.reason import NOTHING, Reason

_GUARD = str(Path(guard.__file__))
_DEFAULT = (signal.SIGINT, signal.SIGTERM, signal.SIGPIPE)
"""Signals that an RTPU ignores or treats in its own way, and a program of its own does not."""


class GuardedChild:
    """`conversation` is a socket that becomes the program's standard input and output; without one it has neither.

    To start takes about a millisecond, and the program's own start does not count in: nobody waits for it.
    """

    def __init__(self, command: Sequence[str], conversation: int | None = None, address: str = "") -> None:
        self.command = tuple(command)
        self.how_ended = NOTHING
        """How the program ended by itself, or why it could not be started; empty as long as it runs."""
        self._ours, theirs = socket.socketpair()
        self._ours.setblocking(False)
        self._spawn(theirs.fileno(), conversation, address)
        theirs.close()

    def fileno(self) -> int:
        """Can be read when the program has ended: then call `look`."""
        return self._ours.fileno()

    def look(self) -> None:
        """See whether it has ended."""
        if self.how_ended:
            return
        with contextlib.suppress(BlockingIOError):
            try:
                words = self._ours.recv(1000).decode("utf-8", "replace")
            except ConnectionError:
                words = ""
            self.how_ended = _how_ended(words)

    def close(self) -> None:
        """Let it end, without waiting for it."""
        self._ours.close()
        self._reap()

    def _spawn(self, lifeline: int, conversation: int | None, address: str) -> None:
        actions: list[tuple[int, ...] | tuple[int, int, str, int, int]]
        if conversation is None:
            actions = [(os.POSIX_SPAWN_OPEN, 0, os.devnull, os.O_RDONLY, 0), (os.POSIX_SPAWN_DUP2, 2, 1)]
        else:
            actions = [(os.POSIX_SPAWN_DUP2, conversation, 0), (os.POSIX_SPAWN_DUP2, conversation, 1)]
        actions.append((os.POSIX_SPAWN_DUP2, lifeline, guard.LIFELINE))
        words = [sys.executable, "-I", "-S", _GUARD, "listener" if address else "partner", *self.command]
        self._pid = os.posix_spawn(
            sys.executable,
            words,
            _surroundings(address),
            file_actions=actions,
            setsigdef=_DEFAULT,
            setsigmask=(),
            scheduler=(os.SCHED_OTHER, os.sched_param(0)),  # a display in real time would be one too many
        )

    def _reap(self) -> None:
        """The process that was started ends at once, its guard is another one; so there is nothing to wait for."""
        with contextlib.suppress(ChildProcessError):
            os.waitpid(self._pid, os.WNOHANG)


def _surroundings(address: str) -> dict[str, str]:
    """Its environment: programs beside the interpreter of the runtime come first, as `python3` with what it has."""
    path = os.pathsep.join((str(Path(sys.executable).parent), os.environ.get("PATH", os.defpath)))
    return os.environ | {"PATH": path} | ({"ONIKA_PARTNER": address} if address else {})


def _how_ended(words: str) -> Reason:
    """What the guard said, as a reason."""
    word, _, rest = words.partition(" ")
    match word:
        case "unstartable":
            return Reason.of("runtime.child_unstartable", why=Reason.plain(rest))
        case "signal":
            return Reason.of("runtime.child_signal", signal=int(rest))
        case "exit":
            return Reason.of("runtime.child_exit", code=int(rest))
    return Reason.of("runtime.child_with_keeper")
