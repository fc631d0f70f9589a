"""The socket between two processes of the runtime: datagrams with file descriptors; sending never waits (law 30)."""

import array
import errno
import socket
from collections import deque
from collections.abc import Iterable

_LARGEST = 1 << 20
_BUFFER = 1 << 22
_ROOM = socket.CMSG_LEN(4 * array.array("i").itemsize)
"""Of the control part: four descriptors."""


class ProcessSocket:
    """One end of a pair. What cannot be sent at once waits in a queue of its own, in order."""

    def __init__(self, end: socket.socket) -> None:
        self._socket = end
        self._outbox: deque[tuple[bytes, tuple[int, ...]]] = deque()
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
        if not (self._outbox or descriptors or self.is_closed):
            try:
                self._socket.send(body)
                return
            except OSError:
                pass  # `flush` finds out why
        self._outbox.append((body, descriptors))
        self.unsent += len(body)
        self.flush()

    def flush(self) -> None:
        """Send what waits, as far as there is room; raises ValueError for what the system is too small to send."""
        while self._outbox and not self.is_closed:
            body, descriptors = self._outbox[0]
            try:
                if descriptors:
                    socket.send_fds(self._socket, [body], descriptors)
                else:
                    self._socket.send(body)
            except BlockingIOError:
                return
            except OSError as wrong:
                self._drop_first()
                if wrong.errno == errno.EMSGSIZE:
                    raise ValueError(f"a datagram of {len(body)} bytes is too large for this system") from None
                self.is_closed = True
                return
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
        return bytes(self._view[:size]), _descriptors(words)

    def _drop_first(self) -> None:
        body, _ = self._outbox.popleft()
        self.unsent -= len(body)

    def close(self) -> None:
        """Let go."""
        self.is_closed = True
        self._socket.close()


def _descriptors(words: Iterable[tuple[int, int, bytes]]) -> list[int]:
    """The file descriptors of a control part."""
    descriptors = array.array("i")
    for level, kind, data in words:
        if level == socket.SOL_SOCKET and kind == socket.SCM_RIGHTS:
            descriptors.frombytes(data[: len(data) - len(data) % descriptors.itemsize])
    return list(descriptors)
