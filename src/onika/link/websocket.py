"""A carrier over a WebSocket, on the environment's side: a payload is one binary message, over TLS where requested."""

import socket
import ssl
from collections import deque

from websockets.client import ClientProtocol
from websockets.protocol import State

from onika.link import lost
from onika.link.carrier import BUFFER_LIMIT
from onika.link.heartbeat import HeartbeatSender
from onika.link.websocket_messages import WebSocketMessages
from onika.words.reason import Reason, reason_of
from onika.words.system_error import system_reason

_CHUNK = 64 * 1024
_TURN = 1024 * 1024
_WOULD_WAIT = (BlockingIOError, InterruptedError, ssl.SSLWantReadError, ssl.SSLWantWriteError)


class WebSocketCarrier:
    """Owns a connected socket whose WebSocket is open; never waits."""

    def __init__(
        self,
        connected: socket.socket,
        protocol: ClientProtocol,
        buffer_limit: int = BUFFER_LIMIT,
        heartbeat_sender: HeartbeatSender | None = None,
    ) -> None:
        self._socket = connected
        self._heartbeat_sender = heartbeat_sender
        self._protocol = protocol
        self._buffer_limit = buffer_limit
        self._messages = WebSocketMessages()
        self._held: deque[bytes] = deque()
        self._waiting = bytearray()
        self._end: lost.LinkLost | None = None
        connected.setblocking(False)
        self._sort()  # what came behind the handshake

    @property
    def pending(self) -> int:
        """Bytes that wait to be sent."""
        return len(self._waiting)

    @property
    def held(self) -> int:
        """Payloads, or bytes of them, that lie here where no descriptor wakes anybody."""
        hidden = self._socket.pending() if isinstance(self._socket, ssl.SSLSocket) and self._socket.fileno() >= 0 else 0
        return len(self._held) + hidden

    def fileno(self) -> int:
        """The socket's file descriptor, -1 after `close`."""
        return self._socket.fileno()

    def send(self, payload: bytes) -> None:
        """Send now what goes and keep the rest; raises LinkLost when too much waits."""
        if self._protocol.state is not State.OPEN:
            return  # reading tells why
        self._protocol.send_binary(payload)
        self.flush()
        if len(self._waiting) > self._buffer_limit:
            raise lost.behind(Reason.of("link.waits_to_be_sent", count=len(self._waiting)))

    def flush(self) -> None:
        """Send what waits, as far as it goes now."""
        for data in self._protocol.data_to_send():
            self._waiting += data
        try:
            while self._waiting:
                # the same bytes have to come again after a pause, so none are taken away before they are sent
                sent = self._socket.send(bytes(self._waiting[:_CHUNK]))
                del self._waiting[:sent]
        except _WOULD_WAIT:
            return
        except OSError:
            self._waiting.clear()

    def served(self) -> None:
        """Whoever serves this connection is alive, which is said beside it."""
        if self._heartbeat_sender is not None:
            self._heartbeat_sender.served()

    def receive(self) -> list[bytes]:
        """What has come; raises LinkLost at the end of the connection, after all that came before it."""
        if self._end is None:
            self._read()
        if self._end is not None and not self._held:
            raise self._end
        payloads = list(self._held)
        self._held.clear()
        return payloads

    def close(self) -> None:
        """Let the connection go, with all that waits."""
        self._waiting.clear()
        self._held.clear()
        self._end = self._end or lost.here()
        if self._heartbeat_sender is not None:
            self._heartbeat_sender.close()
            self._heartbeat_sender = None
        self._socket.close()

    def _read(self) -> None:
        taken = 0
        try:
            while taken < _TURN and self._end is None:
                data = self._socket.recv(_CHUNK)
                taken += len(data)
                if data:
                    self._protocol.receive_data(data)
                else:
                    self._protocol.receive_eof()
                self._sort()
                if not data:
                    self._end = self._end or _closed(self._protocol)
        except _WOULD_WAIT:
            pass
        except OSError as fault:
            self._end = lost.closed(system_reason(fault))
        self.flush()

    def _sort(self) -> None:
        try:
            self._held += self._messages.feed(self._protocol.events_received())
        except ValueError as fault:
            self._end = lost.garbage(reason_of(fault))
        if self._protocol.parser_exc is not None and self._end is None and self._protocol.state is not State.OPEN:
            self._end = _ended(self._protocol)


def _ended(protocol: ClientProtocol) -> lost.LinkLost:
    """Why the protocol let the connection go by itself."""
    if protocol.close_rcvd is not None or protocol.close_sent is None:
        return _closed(protocol)
    why = Reason.plain(protocol.close_sent.reason) or Reason.of("link.broken_websocket")
    return lost.garbage(why)


def _closed(protocol: ClientProtocol) -> lost.LinkLost:
    return lost.closed(Reason.plain(protocol.close_reason or ""))
