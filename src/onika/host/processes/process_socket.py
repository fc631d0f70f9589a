"""The socket between two processes of the runtime: datagrams with file descriptors; sending never waits (law 30)."""

import array
import os
import socket
from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass

_LARGEST = 1 << 20
_BUFFER = 1 << 22
_LONGEST = 1 << 17
"""Bytes that every system sends as one datagram; more go beside it, in shared memory."""
_IN_MEMORY = b"\xc1"
"""In place of such a body, which is the last descriptor then; no message in msgpack begins so."""
_ROOM = socket.CMSG_LEN(5 * array.array("i").itemsize)
"""Of the control part: four descriptors, and that of a body."""


@dataclass(frozen=True, slots=True)
class _Waiting:
    """A datagram that could not be sent yet; `memory` holds a long body, of `size` bytes."""

    body: bytes
    descriptors: tuple[int, ...]
    size: int
    memory: int | None = None

    @property
    def everything(self) -> tuple[int, ...]:
        """All descriptors that travel with it."""
        return self.descriptors if self.memory is None else (*self.descriptors, self.memory)


class ProcessSocket:
    """One end of a pair. What cannot be sent at once waits in a queue of its own, in order."""

    def __init__(self, end: socket.socket) -> None:
        self._socket = end
        self._outbox: deque[_Waiting] = deque()
        self.unsent = 0
        """How many bytes wait to be sent, because the other end does not read."""
        self.is_closed = False
        self._buffer = bytearray(_LARGEST)  # one for all: to make it anew would cost more than to receive
        self._view = memoryview(self._buffer)
        end.setblocking(False)
        for option in (socket.SO_SNDBUF, socket.SO_RCVBUF):
            end.setsockopt(socket.SOL_SOCKET, option, _BUFFER)

    @classmethod
    def pair(cls) -> tuple["ProcessSocket", socket.socket]:
        """Our end, and the socket for the other process."""
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        return cls(ours), theirs

    def fileno(self) -> int:
        """To wait for in `select`."""
        return self._socket.fileno()

    @property
    def is_waiting(self) -> bool:
        """Whether something still waits to be sent."""
        return bool(self._outbox)

    @property
    def waiting(self) -> int:
        """How many datagrams wait."""
        return len(self._outbox)

    def send(self, body: bytes, descriptors: tuple[int, ...] = ()) -> None:
        """Send one datagram, now or as soon as there is room; nothing happens once the other end is gone."""
        if len(body) > _LONGEST:
            self._wait(_Waiting(_IN_MEMORY, descriptors, len(body), _memory_of(body)))
            return
        if not (self._outbox or descriptors or self.is_closed):
            try:
                self._socket.send(body)
                return
            except OSError:
                pass  # `flush` finds out why
        self._wait(_Waiting(body, descriptors, len(body)))

    def flush(self) -> None:
        """Send what waits, as far as there is room."""
        while self._outbox and not self.is_closed:
            first = self._outbox[0]
            try:
                if first.everything:
                    socket.send_fds(self._socket, [first.body], first.everything)
                else:
                    self._socket.send(first.body)
            except BlockingIOError:
                return
            except OSError:
                self.is_closed = True
            self._drop_first()

    def receive(self) -> tuple[bytes, list[int]] | None:
        """The next datagram and its descriptors, or None; `is_closed` when the other end is gone."""
        try:
            size, words, _, _ = self._socket.recvmsg_into((self._buffer,), _ROOM)
        except BlockingIOError:
            return None
        except OSError:
            self.is_closed = True
            return None
        if not size:
            self.is_closed = True
            return None
        body, descriptors = bytes(self._view[:size]), _descriptors(words)
        return (_read(descriptors.pop()), descriptors) if body == _IN_MEMORY and descriptors else (body, descriptors)

    def _wait(self, waiting: "_Waiting") -> None:
        self._outbox.append(waiting)
        self.unsent += waiting.size
        self.flush()

    def _drop_first(self) -> None:
        first = self._outbox.popleft()
        self.unsent -= first.size
        if first.memory is not None:
            os.close(first.memory)

    def close(self) -> None:
        """Let go."""
        self.is_closed = True
        while self._outbox:
            self._drop_first()
        self._socket.close()


def _memory_of(body: bytes) -> int:
    """Shared memory that holds it."""
    memory = os.memfd_create("datagram")
    with open(memory, "wb", closefd=False) as written:
        written.write(body)
    return memory


def _read(memory: int) -> bytes:
    with open(memory, "rb") as held:
        held.seek(0)  # both ends share where it was written last
        return held.read()


def _descriptors(words: Iterable[tuple[int, int, bytes]]) -> list[int]:
    """The file descriptors of a control part."""
    descriptors = array.array("i")
    for level, kind, data in words:
        if level == socket.SOL_SOCKET and kind == socket.SCM_RIGHTS:
            descriptors.frombytes(data[: len(data) - len(data) % descriptors.itemsize])
    return list(descriptors)
