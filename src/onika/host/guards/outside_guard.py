"""The outside guard: in a forecast no code reaches outside its process; whoever tries is told why not (E16).

A forecast runs by itself, while somebody edits: it must leave no trace. A module that writes a file, starts a program
or opens a connection fails there, as it would where it has no permission. It is no fence against malice.
"""

import os
import sys
from collections.abc import Sequence
from typing import Any

from onika.words.reason import Reason

_NEVER = frozenset(
    (
        "os.chmod", "os.chown", "os.exec", "os.fork", "os.forkpty", "os.link", "os.mkdir", "os.posix_spawn",
        "os.remove", "os.rename", "os.rmdir", "os.spawn", "os.symlink", "os.system", "os.truncate", "os.utime",
        "socket.bind", "socket.connect", "socket.getaddrinfo", "socket.sendto",
    )
)  # fmt: skip
_OPEN, _POPEN = "open", "subprocess.Popen"
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
_MODULE = "-m"
_OWN = ("onika.host.", "onika.workcell.filmed.")  # those of the runtime, and what renders for its cameras


class OutsideRefused(PermissionError):
    """Something outside of a forecast is not to be touched."""


def stay_inside() -> None:
    """From now on, and to the end of this process, nothing outside is written, begun or called."""
    sys.dont_write_bytecode = True
    sys.addaudithook(_judge)


def _judge(what: str, given: Sequence[Any]) -> None:
    is_own = bool(given) and isinstance(given[0], int)  # what this process has open: memory that it shares
    if (what in _NEVER and not is_own) or (what == _OPEN and _writes(given)) or (what == _POPEN and not _is_own(given)):
        raise OutsideRefused(Reason.of("host.reaches_outside", what=what))


def _writes(given: Sequence[Any]) -> bool:
    path, _, flags = given
    is_file = isinstance(path, str | bytes | os.PathLike) and os.fspath(path) not in ("/dev/null", b"/dev/null")
    return is_file and bool(flags & _WRITING)


def _is_own(given: Sequence[Any]) -> bool:
    """Whether it is one of the processes of the runtime itself, which are begun again where a module has ended one."""
    program, words = given[0], list(map(str, given[1]))
    return program == sys.executable and words[1:2] == [_MODULE] and words[2].startswith(_OWN)
