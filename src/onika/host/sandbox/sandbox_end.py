"""The end of a sandbox that the unit has: it asks, and waits for answers no longer than they may take (R-X16)."""

import contextlib
import os
import select
import signal
import socket
import weakref

from onika.host.sandbox.sandbox_process import LARGEST
from onika.ring.segment import Segment
from onika.runtime.error import LawBroken
from onika.words.reason import Reason

_MILLISECONDS = 1000


class SandboxEnd:
    """The socket of a sandbox, the memory that is shared with it, and a descriptor of its process."""

    def __init__(self, post: socket.socket, memory: Segment, process: int) -> None:
        self._post = post
        self._memory = memory
        post.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 2 * LARGEST)
        self._poll = select.poll()
        self._poll.register(post, select.POLLIN)
        self._end = weakref.finalize(self, _end, post, process)

    @classmethod
    def of_descriptors(cls, post: int, memory: int, process: int) -> "SandboxEnd":
        """As they came from the runtime."""
        return cls(socket.socket(fileno=post), Segment.attach(memory), process)

    @property
    def memory(self) -> memoryview:
        """What it shares with its task."""
        return self._memory.view

    @property
    def is_heard(self) -> bool:
        """Whether it has something to say: an answer, or its end."""
        return not self._end.alive or bool(self._poll.poll(0))

    def ask(self, message: bytes, patience_s: float) -> bytes:
        """Send it a message, and wait for its answer; raises LawBroken as `answer` does."""
        if self._end.alive:
            with contextlib.suppress(OSError):  # it has ended: so says the answer
                self._post.send(message)
        return self.answer(patience_s)

    def answer(self, patience_s: float) -> bytes:
        """Its answer; raises LawBroken where none comes within the time, or it has ended: then it is gone."""
        if not self._end.alive:
            raise LawBroken(Reason.of("host.sandbox_gone"))
        if not self._poll.poll(patience_s * _MILLISECONDS):
            self.close()
            raise LawBroken(Reason.of("host.sandbox_silent", seconds=patience_s))
        try:
            answer = self._post.recv(LARGEST)
        except OSError:
            answer = b""
        if not answer:
            self.close()
            raise LawBroken(Reason.of("host.sandbox_gone"))
        return answer

    def close(self) -> None:
        """End it."""
        self._end()


def _end(post: socket.socket, process: int) -> None:
    post.close()
    with contextlib.suppress(OSError):  # it has ended by itself
        signal.pidfd_send_signal(process, signal.SIGKILL)
    os.close(process)
