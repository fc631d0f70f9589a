"""The fork server: a process that has loaded what all processes of a runtime need; each of them begins as its copy.

To load Python, NumPy and this package takes several times as long as all else that such a process does at its start.
The server is copied off the runtime before that has read any secret or has a second thread. Whoever it begins becomes
the runtime's own child, which is looked after, waited for and ended as any other.
"""

import contextlib
import ctypes
import fcntl
import gc
import importlib
import os
import select
import signal
import socket
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from time import monotonic
from typing import NoReturn

from msgspec import Struct, msgpack

from onika.host.processes.forked_process import ForkedProcess
from onika.host.processes.preloaded_libraries import preload
from onika.host.processes.process_title import entitle
from onika.link.child.launcher import ONE_THREAD, UNDRAWN, die_with_parent
from onika.process.guard import is_stopped

PATIENCE_S = 20.0
"""So long a copy may take: the server may just be loading a big library from a slow disk."""

_LOOK_S = 0.05
_ADOPT_ORPHANS = 36  # PR_SET_CHILD_SUBREAPER of prctl(2)
_LARGEST = 1 << 16
_MOST_DESCRIPTORS = 16
_STANDARD = 3
"""The descriptors below are input and outputs."""


class Preload(Struct, frozen=True, tag=True):
    """Load the big libraries: whoever is begun later has them."""


class BeginProcess(Struct, frozen=True, tag=True):
    """Begin this module with these words; the descriptors that come along get these numbers in the new process."""

    module: str
    words: tuple[str, ...]
    numbers: tuple[int, ...]
    own_group: bool


class ProcessBegun(Struct, frozen=True, tag=True):
    """The id of the process that was begun."""

    pid: int


_encode = msgpack.Encoder().encode
_decode_order = msgpack.Decoder(Preload | BeginProcess).decode
_decode_answer = msgpack.Decoder(ProcessBegun).decode


class ForkServer:
    """The runtime's end of the server, which has loaded all that this process has."""

    def __init__(self) -> None:
        """Copy this process, which has no second thread. Raises OSError where there is no room for another."""
        self._control, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        runtime = os.getpid()
        pid = os.fork()
        if not pid:
            _end_with(lambda: _serve(theirs, runtime))
        theirs.close()
        self._process = ForkedProcess(pid)

    def preload(self) -> None:
        """Have it load the big libraries, while nobody waits."""
        with contextlib.suppress(OSError):  # it is gone: the next one who begins a process finds out
            self._control.send(_encode(Preload()))

    def begin(self, order: BeginProcess, descriptors: Sequence[int]) -> ForkedProcess | None:
        """Begin a process; None where the server does not do it: then it has been ended."""
        with _adopting():
            try:
                socket.send_fds(self._control, [_encode(order)], list(descriptors))
            except OSError:
                self.close()
                return None
            if not self._is_heard():
                self.close()  # whom it has begun before it was ended is found below
            answer = self._answer()
        if answer is None:
            self.close()
            return None
        return ForkedProcess(answer.pid)

    def close(self) -> None:
        """End it; whom it has begun goes on."""
        self._process.kill()
        self._process.wait()

    def _is_heard(self) -> bool:
        """Whether it answers, or has ended, before patience does; one that the system holds gets none."""
        until = monotonic() + PATIENCE_S
        while not select.select([self._control], [], [], _LOOK_S)[0]:
            if monotonic() > until or is_stopped(self._process.pid):
                return False
        return True

    def _answer(self) -> ProcessBegun | None:
        try:
            body = self._control.recv(_LARGEST, socket.MSG_DONTWAIT)
        except OSError:
            return None
        return _decode_answer(body) if body else None


@contextlib.contextmanager
def _adopting() -> Iterator[None]:
    """Whose parent ends meanwhile becomes a child of this process."""
    library = ctypes.CDLL(None)
    library.prctl(_ADOPT_ORPHANS, 1, 0, 0, 0)
    try:
        yield
    finally:
        library.prctl(_ADOPT_ORPHANS, 0, 0, 0, 0)


# In the server


def _serve(control: socket.socket, runtime: int) -> None:
    die_with_parent(runtime)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.environ.update(UNDRAWN | os.environ | ONE_THREAD)
    entitle(__name__)
    os.closerange(_STANDARD, control.fileno())  # what the runtime has open ends with the runtime
    os.closerange(control.fileno() + 1, os.sysconf("SC_OPEN_MAX"))
    gc.freeze()  # else each collection would make copies of pages that all could share
    while True:
        body, descriptors, _, _ = socket.recv_fds(control, _LARGEST, _MOST_DESCRIPTORS)
        if not body:
            return
        order = _decode_order(body)
        if isinstance(order, Preload):
            preload()
            gc.freeze()
        else:
            control.send(_encode(ProcessBegun(_begin(order, descriptors, runtime))))


def _begin(order: BeginProcess, descriptors: Sequence[int], runtime: int) -> int:
    """Copy the server by way of a process that ends at once, so that the runtime becomes the parent of the copy."""
    told, tells = os.pipe()
    goes_on, go_on = os.pipe()
    between = os.fork()
    if not between:
        pid = os.fork()
        if pid:
            os.write(tells, str(pid).encode())
            os._exit(0)
        os.close(go_on)
        os.read(goes_on, 1)  # until its parent is the runtime
        _end_with(lambda: _become(order, descriptors))
    os.waitpid(between, 0)
    for descriptor in (*descriptors, tells, goes_on, go_on):
        os.close(descriptor)
    pid = int(os.read(told, 20))
    os.close(told)
    return pid


# In the process that was begun


def _become(order: BeginProcess, descriptors: Sequence[int]) -> None:
    entitle(" ".join((order.module, *order.words)))
    if order.own_group:
        os.setsid()
    _place(descriptors, order.numbers)
    module = importlib.import_module(order.module)
    if "numpy.random" in sys.modules:
        sys.modules["numpy.random"].seed()  # else its old interface would draw the same numbers in each copy
    gc.unfreeze()
    module.main(list(order.words))


def _place(descriptors: Sequence[int], numbers: Sequence[int]) -> None:
    """Give the descriptors these numbers, and close all others; the input is empty."""
    above = max((_STANDARD, *numbers)) + 1
    moved = [fcntl.fcntl(descriptor, fcntl.F_DUPFD_CLOEXEC, above) for descriptor in descriptors]
    empty = os.open(os.devnull, os.O_RDONLY)
    os.dup2(empty, 0)
    for descriptor, number in zip(moved, numbers, strict=True):
        os.dup2(descriptor, number, inheritable=False)
    first = _STANDARD
    for number in (*sorted(numbers), os.sysconf("SC_OPEN_MAX")):
        os.closerange(first, number)
        first = number + 1


def _end_with(work: Callable[[], None]) -> NoReturn:
    """Do it, and end this copy with the code that Python would end with; nothing of the copied program goes on."""
    code = 1
    try:
        work()
        code = 0
    except SystemExit as ended:
        code = ended.code if isinstance(ended.code, int) else int(bool(ended.code))
    except BaseException:
        traceback.print_exc()
    finally:
        with contextlib.suppress(OSError):
            sys.stdout.flush()
            sys.stderr.flush()
        os._exit(code)
