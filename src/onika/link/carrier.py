"""A carrier: one connection that brings payloads, whole and in order, and never makes anybody wait."""

import math
import select
import socket
from collections import deque
from collections.abc import Sequence
from time import monotonic
from typing import Protocol, runtime_checkable

from onika.link import lost
from onika.wire.frame import FRAME_LIMIT, FrameReader, frame
from onika.words.reason import Reason, reason_of
from onika.words.system_error import system_reason

BUFFER_LIMIT = 16 * 1024 * 1024
"""Bytes that may wait for a slow reader before the connection is cut."""

_CHUNK = 256 * 1024
_PAYLOADS = 1 << 20
_LOOK_S = 0.1
"""How long a wait lasts at most before it is seen whether there was a signal."""
_TURN = 2 * 1024 * 1024
"""Bytes read in one call at most, so that a fast sender starves nobody."""


class PayloadSource(Protocol):
    """What can be waited for."""

    @property
    def pending(self) -> int:
        """Bytes that wait to be sent."""

    def fileno(self) -> int:
        """The file descriptor to wait for, -1 when there is none."""


class Carrier(PayloadSource, Protocol):
    """What the link needs of a connection. One carrier is one connection; a new connection is a new carrier."""

    @property
    def held(self) -> int:
        """Payloads that came and are left for the next `receive`, for which no descriptor wakes anybody."""

    def send(self, payload: bytes) -> None:
        """Send now what goes and keep the rest; raises LinkLost when too much waits."""

    def flush(self) -> None:
        """Send what waits, as far as it goes now."""

    def receive(self) -> list[bytes]:
        """What has come; raises LinkLost at the end of the connection, after all that came before it."""

    def close(self) -> None:
        """Let the connection go, with all that waits."""


@runtime_checkable
class HeartbeatCarrier(Protocol):
    """A connection beside which it is said that its end is alive."""

    def served(self) -> None:
        """Whoever serves it has come by."""


class SocketCarrier:
    """A carrier over a connected stream socket (socket pair, Unix, TCP), which it owns from now on.

    turn, turn_bytes    what one `receive` gives and reads at most; a flood waits in the system's own buffers meanwhile
    """

    def __init__(
        self,
        connected: socket.socket,
        frame_limit: int = FRAME_LIMIT,
        buffer_limit: int = BUFFER_LIMIT,
        turn: int = _PAYLOADS,
        turn_bytes: int = _TURN,
    ) -> None:
        self._socket = connected
        self._socket.setblocking(False)
        if connected.family in (socket.AF_INET, socket.AF_INET6):
            connected.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._reader = FrameReader(frame_limit)
        self._frame_limit = frame_limit
        self._buffer_limit = buffer_limit
        self._turn = turn
        self._turn_bytes = turn_bytes
        self._held: deque[bytes] = deque()
        self._waiting = bytearray()
        self._end: lost.LinkLost | None = None

    @property
    def pending(self) -> int:
        """Bytes that wait to be sent."""
        return len(self._waiting)

    @property
    def held(self) -> int:
        """Payloads that came and are left for the next `receive`."""
        return len(self._held)

    def fileno(self) -> int:
        """The socket's file descriptor, -1 after `close`."""
        return self._socket.fileno()

    def send(self, payload: bytes) -> None:
        """Send now what goes and keep the rest; raises LinkLost when too much waits."""
        self._waiting += frame(payload, self._frame_limit)
        self.flush()
        if len(self._waiting) > self._buffer_limit:
            raise lost.behind(Reason.of("link.waits_to_be_sent", count=len(self._waiting)))

    def flush(self) -> None:
        """Send what waits, as far as it goes now."""
        try:
            while self._waiting:
                with memoryview(self._waiting) as waiting:
                    sent = self._socket.send(waiting[:_CHUNK])
                del self._waiting[:sent]
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            # reading tells why, after what the other side said last
            self._waiting.clear()

    def receive(self) -> list[bytes]:
        """What has come; raises LinkLost at the end of the connection, after all that came before it."""
        if self._end is None:
            self._read()
        if self._end is not None and not self._held:
            raise self._end
        return [self._held.popleft() for _ in range(min(self._turn, len(self._held)))]

    def _read(self) -> None:
        try:
            taken = 0
            while taken < self._turn_bytes and len(self._held) < self._turn and self._end is None:
                data = self._socket.recv(min(_CHUNK, self._turn_bytes))
                taken += len(data)
                self._held += self._reader.feed(data)
                if not data:
                    is_whole = self._reader.is_between_frames
                    self._end = lost.closed() if is_whole else lost.closed(Reason.of("link.in_a_message"))
        except (BlockingIOError, InterruptedError):
            pass
        except ValueError as fault:
            self._end = lost.garbage(reason_of(fault))
        except OSError as fault:
            self._end = lost.closed(system_reason(fault))

    def close(self) -> None:
        """Let the connection go, with all that waits."""
        self._waiting.clear()
        self._held.clear()
        self._end = self._end or lost.here()
        self._socket.close()


class MemoryCarrier:
    """One end of a connection within a program; made in pairs by `memory_pair`."""

    def __init__(self, buffer_limit: int = BUFFER_LIMIT) -> None:
        self._buffer_limit = buffer_limit
        self._inbox: deque[bytes] = deque()
        self._inbox_bytes = 0
        self._peer: MemoryCarrier | None = None
        self._end: lost.LinkLost | None = None

    @property
    def pending(self) -> int:
        """None: what is sent lies in the other end's inbox at once."""
        return 0

    @property
    def held(self) -> int:
        """None: `receive` gives all."""
        return 0

    def fileno(self) -> int:
        """There is none."""
        return -1

    def send(self, payload: bytes) -> None:
        """Put the payload into the other end's inbox; raises LinkLost when that is full."""
        if self._peer is None:
            return
        self._peer._inbox.append(payload)
        self._peer._inbox_bytes += len(payload)
        if self._peer._inbox_bytes > self._buffer_limit:
            raise lost.behind(Reason.of("link.waits_to_be_received", count=self._peer._inbox_bytes))

    def flush(self) -> None:
        """Nothing ever waits here."""

    def receive(self) -> list[bytes]:
        """What has come; raises LinkLost when the connection is closed and nothing is left."""
        payloads = list(self._inbox)
        self._inbox.clear()
        self._inbox_bytes = 0
        if self._end is not None and not payloads:
            raise self._end
        return payloads

    def close(self) -> None:
        """Close both ends; the other one may still take what was sent."""
        peer, self._peer = self._peer, None
        self._inbox.clear()
        self._inbox_bytes = 0
        self._end = self._end or lost.here()
        if peer is not None:
            peer._peer = None
            peer._end = lost.closed()


def memory_pair(buffer_limit: int = BUFFER_LIMIT) -> tuple[MemoryCarrier, MemoryCarrier]:
    """Two ends of one connection."""
    here, there = MemoryCarrier(buffer_limit), MemoryCarrier(buffer_limit)
    here._peer, there._peer = there, here
    return here, there


def socket_pair(frame_limit: int = FRAME_LIMIT) -> tuple[SocketCarrier, SocketCarrier]:
    """Two ends of one connection through the kernel."""
    here, there = socket.socketpair()
    return SocketCarrier(here, frame_limit), SocketCarrier(there, frame_limit)


def wait_for(sources: Sequence[PayloadSource], timeout_s: float | None) -> None:
    """Wait until something came, what waits can be sent on, or the time is over (None: never).

    A Ctrl-C is seen soon: where the system gives it to another thread of the program, as it may after a freeze, it
    interrupts no wait of this one.
    """
    poller = select.poll()
    for source in sources:
        poller.register(source.fileno(), select.POLLIN | (select.POLLOUT if source.pending else 0))
    left_s = math.inf if timeout_s is None else timeout_s
    until = monotonic() + left_s
    while not poller.poll(1000 * min(max(left_s, 0.0), _LOOK_S)) and left_s > 0:
        left_s = until - monotonic()
