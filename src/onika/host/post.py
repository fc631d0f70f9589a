"""The post between the runtime's processes: datagrams with file descriptors; sending never waits (law 30)."""

import errno
import socket
from collections import deque

_LARGEST = 1 << 20
_BUFFER = 1 << 22


class Post:
    """One end of a pair. What cannot be sent at once waits in a queue of its own, in order."""

    def __init__(self, end: socket.socket) -> None:
        self._socket = end
        self._outbox: deque[tuple[bytes, tuple[int, ...]]] = deque()
        self.is_closed = False
        end.setblocking(False)
        for option in (socket.SO_SNDBUF, socket.SO_RCVBUF):
            end.setsockopt(socket.SOL_SOCKET, option, _BUFFER)

    @classmethod
    def pair(cls) -> tuple["Post", socket.socket]:
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

    def send(self, body: bytes, descriptors: tuple[int, ...] = ()) -> None:
        """Send one datagram, now or as soon as there is room; nothing happens once the other end is gone."""
        self._outbox.append((body, descriptors))
        self.flush()

    def flush(self) -> None:
        """Send what waits, as far as there is room; raises ValueError for what the system is too small to send."""
        while self._outbox and not self.is_closed:
            body, descriptors = self._outbox[0]
            try:
                socket.send_fds(self._socket, [body], descriptors)
            except BlockingIOError:
                return
            except OSError as wrong:
                self._outbox.popleft()
                if wrong.errno == errno.EMSGSIZE:
                    raise ValueError(f"a datagram of {len(body)} bytes is too large for this system") from None
                self.is_closed = True
                return
            self._outbox.popleft()

    def receive(self) -> tuple[bytes, list[int]] | None:
        """The next datagram and its descriptors, or None; `is_closed` when the other end is gone."""
        try:
            body, descriptors, _, _ = socket.recv_fds(self._socket, _LARGEST, 4)
        except BlockingIOError:
            return None
        except OSError:
            self.is_closed = True
            return None
        if not body:
            self.is_closed = True
            return None
        return body, descriptors

    def close(self) -> None:
        """Let go."""
        self.is_closed = True
        self._socket.close()
