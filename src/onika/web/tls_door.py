"""The door of a page that is served to others: accepts connections, and lets them in when they speak TLS."""

import asyncio
import contextlib
import socket
import ssl
from collections.abc import Callable
from time import monotonic_ns

from onika.web.handshake_limit import HandshakeLimit

HANDSHAKE_S = 10.0
"""How long a handshake may take, over a bad line too."""
_GOODBYE_S = 2.0
_BACKLOG = 256
_REST_S = 0.05
"""A rest where the system has no descriptor left."""

ProtocolMaker = Callable[[], asyncio.Protocol]


class TlsDoor:
    """A door at a socket; `make` makes the protocol of each connection that came in."""

    def __init__(self, listening: socket.socket, context: ssl.SSLContext, make: ProtocolMaker) -> None:
        self._listening = listening
        self._context = context
        self._make = make
        self._limit = HandshakeLimit()
        self._under_way: dict[int, asyncio.Task[None]] = {}
        listening.setblocking(False)
        listening.listen(_BACKLOG)  # at once: whoever is told that it is open finds it so

    async def keep(self) -> None:
        """Let people in until it is cancelled."""
        loop = asyncio.get_running_loop()
        try:
            while True:
                try:
                    connection, address = await loop.sock_accept(self._listening)
                except OSError:
                    await asyncio.sleep(_REST_S)
                    continue
                self._begin(connection, address[0])
        finally:
            for task in self._under_way.values():
                task.cancel()

    def _begin(self, connection: socket.socket, address: str) -> None:
        began = self._limit.begin(address, monotonic_ns())
        if began is None:
            connection.close()
            return
        number, evicted = began
        if evicted is not None and evicted in self._under_way:
            self._under_way[evicted].cancel()
        task = asyncio.create_task(self._let_in(connection))
        self._under_way[number] = task
        task.add_done_callback(lambda _task: self._end(number))

    def _end(self, number: int) -> None:
        self._under_way.pop(number, None)
        self._limit.end(number)

    async def _let_in(self, connection: socket.socket) -> None:
        """Shake hands; whoever does not is cut."""
        with contextlib.suppress(OSError):
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        with contextlib.suppress(OSError, asyncio.CancelledError):  # errors of TLS and time-outs are such, too
            await asyncio.get_running_loop().connect_accepted_socket(
                self._make,
                connection,
                ssl=self._context,
                ssl_handshake_timeout=HANDSHAKE_S,
                ssl_shutdown_timeout=_GOODBYE_S,
            )
