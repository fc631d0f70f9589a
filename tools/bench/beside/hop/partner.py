"""The process at the other end of a hop: the same file, started with the word `partner`; it ends with its parent."""

import os
import subprocess
import sys
from collections.abc import Callable

from onika.host.processes.realtime_scheduling import fine_timers, still_garbage
from onika.link.child.launcher import die_with_parent

_WORD = "partner"


def start(module: str, words: tuple[str, ...] = (), descriptors: tuple[int, ...] = ()) -> "subprocess.Popen[bytes]":
    """Start the partner; descriptors are inherited."""
    command = [sys.executable, "-m", module, _WORD, str(os.getpid()), *words]
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=sys.stderr, pass_fds=descriptors)


def either(contestant: Callable[[], None], partner: Callable[[list[str]], None]) -> None:
    """Be what this process was started as."""
    if sys.argv[1:2] != [_WORD]:
        contestant()
        return
    die_with_parent(int(sys.argv[2]))
    fine_timers()
    still_garbage()
    partner(sys.argv[3:])
