"""The listener as the program sees it: a process that listens on the network, and what it says.

It hands the program one end of a socket pair for each connection that it has let in (`host.sessions.listener_main`).
"""

import select
import socket
import subprocess
from time import monotonic, monotonic_ns

from msgspec import Struct, msgpack

from onika.host.processes.child_process import ChildProcess, start
from onika.host.processes.process_socket import ProcessSocket
from onika.host.sessions.admission import from_near
from onika.host.sessions.listen_options import ListenerSettings
from onika.link.caller import Caller, Role
from onika.link.channel import Channel
from onika.link.sessions import Introduction
from onika.words.reason import NOTHING, Reason

_START_S = 20.0
_END_S = 0.5
AWAKE_NS = 50_000_000
"""How often it says that it listens."""


class ListenerReady(Struct, frozen=True, tag=True):
    """It listens; on which port."""

    port: int


class ListenFailed(Struct, frozen=True, tag=True):
    """It cannot listen."""

    reason: Reason


class ConnectionArrived(Struct, frozen=True, tag=True):
    """Somebody is let in; his end of the connection comes with it."""

    channel: str
    client: str
    epoch: str
    user: str
    role: int
    address: str


class ListenerAwake(Struct, frozen=True, tag=True):
    """It listens, and has passed on what came until now; said again and again while somebody is inside."""


encode = msgpack.Encoder().encode
_decode = msgpack.Decoder(ListenerReady | ListenFailed | ConnectionArrived | ListenerAwake).decode


class ListenerProcess:
    """The listener as the program sees it."""

    def __init__(self, listening: ListenerSettings) -> None:
        self._listening = listening
        self._post, theirs = ProcessSocket.pair()
        self._process: ChildProcess = start("onika.host.sessions.listener_main", theirs)
        self._post.send(encode(listening))
        self._awake_ns = 0
        self.address = ""
        """Where it listens, once it does."""

    @property
    def post(self) -> ProcessSocket:
        """Readable when somebody has come, or at its end."""
        return self._post

    def open(self) -> None:
        """Wait until it listens. Raises OSError with the reason why it cannot."""
        until = monotonic() + _START_S
        while (left := until - monotonic()) > 0:
            select.select([self._post], [], [], left)
            if self.look():
                return
        raise OSError(Reason.of("host.porter_not_started"))

    def look(self) -> bool:
        """Whether it listens by now; never waits. Raises OSError with the reason why it cannot."""
        came = self._post.receive()
        match _decode(came[0]) if came else None:
            case ListenerReady(port):
                self.address = self._listening.address(port)
                return True
            case ListenFailed(reason):
                raise OSError(reason)
        if self._post.is_closed:
            raise OSError(Reason.of("host.porter_not_started"))
        return False

    def arrivals(self) -> list[tuple[Introduction, socket.socket]]:
        """Who has come since the last call."""
        came = []
        while (packet := self._post.receive()) is not None:
            body, descriptors = packet
            arrived = _decode(body)
            if isinstance(arrived, ListenerAwake):
                self._awake_ns = monotonic_ns()
            elif isinstance(arrived, ConnectionArrived) and descriptors:
                caller = Caller(arrived.user, Role(arrived.role), arrived.address, from_near(arrived.address))
                new = Introduction(Channel(arrived.channel), arrived.client, arrived.epoch, caller)
                came.append((new, socket.socket(fileno=descriptors[0])))
        return came

    def deaf_ns(self) -> int:
        """For how long it has passed nothing on, though something may have come: it was not its turn on the machine."""
        if self._awake_ns:
            return max(0, monotonic_ns() - self._awake_ns - 2 * AWAKE_NS)
        return 0

    def ending(self) -> Reason:
        """How it ended; empty while it lives."""
        if not self._post.is_closed:
            return NOTHING
        code = self._process.poll()
        if code is None:
            return NOTHING  # it is just ending; how, is known in a moment
        if code < 0:
            return Reason.of("host.porter_killed", signal=-code)
        return Reason.of("host.porter_ended", code=code)

    def leave(self) -> None:
        """Let it end: it takes nobody in any more, and passes on what was said last."""
        self._post.close()

    @property
    def is_gone(self) -> bool:
        """Whether its process has ended."""
        return self._process.poll() is not None

    def close(self) -> None:
        """End it."""
        self._post.close()
        try:
            self._process.wait(_END_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
