"""Begins sandboxes: a process for each task whose module is of others, before its unit is told of the task (R-X16)."""

import os
import socket
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from onika.host.processes.child_process import ChildProcess, preload_forks, start
from onika.host.sandbox.sandbox_process import LARGEST
from onika.process import confinement, system_calls
from onika.ring.segment import Segment
from onika.runtime.command import Spawn
from onika.runtime.sandbox.sandbox_messages import DEVICE_AT, Load, device_sizes, encode
from onika.store.remote.checkout_path import checked_out_folder
from onika.words.reason import Reason, reason_of
from onika.words.shape import Shape

_MODULE = "onika.host.sandbox.sandbox_process"
_LINE = 64
_LEAST = 1 << 20
"""Bytes that are there in any case; untouched ones cost nothing."""


@dataclass(frozen=True, slots=True)
class BegunSandbox:
    """What the unit needs of a sandbox: a socket, memory, a descriptor of the process."""

    post: socket.socket
    memory: Segment
    process: int

    @property
    def descriptors(self) -> tuple[int, int, int]:
        """To be sent to the unit."""
        return self.post.fileno(), self.memory.fd, self.process

    def close(self) -> None:
        """The unit has what it needs."""
        self.post.close()
        self.memory.close()
        os.close(self.process)


class Sandboxes:
    """The processes that were begun, to be waited for when they have ended."""

    def __init__(self, with_fifo: bool = False) -> None:
        self._with_fifo = with_fifo
        self._processes: list[tuple[str, ChildProcess]] = []

    def begin(self, spawn: Spawn, unit: str = "") -> BegunSandbox:
        """Begin one that loads the module of this task; nothing waits for it. Raises ValueError with the reason."""
        self.bury()
        if not (confinement.level() and system_calls.can_be_left_out()):
            raise ValueError(Reason.of("host.no_sandbox"))
        if not self._processes:
            preload_forks()
        with ExitStack() as opened:
            try:
                memory = Segment.create("sandbox", _size(spawn))
                opened.callback(memory.close)
                ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
                opened.callback(ours.close)
                opened.callback(theirs.close)
                process = start(_MODULE, theirs, self._words(spawn, memory), (memory.fd,), own_group=True)
                self._processes.append((unit, process))
                ours.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 2 * LARGEST)
                ours.send(encode(Load(spawn)))
                begun = BegunSandbox(ours, memory, os.pidfd_open(process.pid))
            except OSError as refused:
                raise ValueError(reason_of(refused)) from None
            opened.pop_all()
        return begun

    def _words(self, spawn: Spawn, memory: Segment) -> tuple[str, ...]:
        """It may read what its library has brought along, as a trained net."""
        folder = checked_out_folder(Path(spawn.path))
        reads = () if folder is None else ("--reads", str(folder))
        return ("--memory-fd", str(memory.fd), *reads, *(("--fifo",) if self._with_fifo else ()))

    def bury(self) -> None:
        """Wait for those that have ended, so that nothing is left of them."""
        self._processes = [(unit, process) for unit, process in self._processes if process.poll() is None]

    def end_of(self, unit: str) -> None:
        """This unit is gone: so are its sandboxes."""
        for owner, process in self._processes:
            if owner == unit:
                process.kill()

    def close(self) -> None:
        """End all of them."""
        for _, process in self._processes:
            process.kill()
            process.wait()
        self._processes.clear()


def _size(spawn: Spawn) -> int:
    """Bytes of the memory that a task shares with its sandbox."""
    device = sum(device_sizes(spawn.device))
    ports = sum(Shape.parse(port.shape).size + _LINE for port in spawn.ports)
    return max(4 * (DEVICE_AT + device + _LINE + ports), _LEAST)  # shapes may grow while it lives
