"""Opens a WebSocket to a runtime: it waits, within limits, and names the cause where it fails."""

import socket
import ssl
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from time import monotonic

from websockets.client import ClientProtocol
from websockets.exceptions import InvalidStatus
from websockets.http11 import Response
from websockets.protocol import State
from websockets.uri import parse_uri

from onika.link import refusal_header
from onika.link.address import Address, bracketed
from onika.link.channel import Channel
from onika.link.heartbeat import HEADER, HeartbeatKey, HeartbeatSender
from onika.link.lost import LinkLost, LossCause
from onika.link.trust import trusting, untrusted
from onika.link.websocket import WebSocketCarrier
from onika.link.websocket_messages import SILENT
from onika.wire.frame import FRAME_LIMIT
from onika.words.reason import Reason
from onika.words.system_error import system_reason

CONNECT_S = 1.5
"""How long a machine may take to answer at all."""
OPEN_S = 5.0
"""How long the whole opening may take."""

_REFUSED = {
    401: (LossCause.TOKEN, Reason.of("link.wrong_token")),
    403: (LossCause.FORBIDDEN, Reason.of("link.not_allowed")),
    429: (LossCause.FORBIDDEN, Reason.of("link.many_wrong_tokens")),
}


@dataclass(frozen=True, slots=True)
class WebSocketOpening:
    """Where to, with which token, and whose certificates are trusted beside the system's (None: only those)."""

    address: Address
    token: str
    authority: Path | None = None
    tunnel: Path | None = None
    """A socket of this machine that leads there, where there is no other way; no datagrams go along it."""

    def __call__(self, channel: Channel) -> WebSocketCarrier:
        """Open a connection for a channel; raises LinkLost."""
        until = monotonic() + OPEN_S
        try:
            connected = self._connected()
        except TimeoutError:
            raise LinkLost(
                LossCause.TIMEOUT, Reason.of("link.no_answer", address=str(self.address), seconds=CONNECT_S)
            ) from None
        except OSError as fault:
            nobody = Reason.of("link.nobody", address=str(self.address), why=system_reason(fault))
            raise LinkLost(LossCause.UNREACHABLE, nobody) from None
        try:
            return self._open(connected, channel, until)
        except BaseException:
            connected.close()
            raise

    def _connected(self) -> socket.socket:
        if self.tunnel is None:
            connected = socket.create_connection((self.address.host, self.address.port), CONNECT_S)
            connected.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            return connected
        connected = socket.socket(socket.AF_UNIX)
        try:
            connected.settimeout(CONNECT_S)
            connected.connect(str(self.tunnel))
        except OSError:
            connected.close()
            raise
        return connected

    def _open(self, connected: socket.socket, channel: Channel, until: float) -> WebSocketCarrier:
        connected.settimeout(OPEN_S)
        protocol = ClientProtocol(parse_uri(f"{self.address}/{channel.value}"), max_size=FRAME_LIMIT, logger=SILENT)
        request = protocol.connect()
        request.headers["Authorization"] = f"Bearer {self.token}"
        protocol.send_request(request)
        try:
            private = self._secure(connected)
            self._shake(private, protocol, until)
        except ssl.SSLCertVerificationError as fault:
            place = f"{bracketed(self.address.host)}:{self.address.port}"
            raise untrusted(fault, str(self.address), place) from None
        except TimeoutError:
            slow = Reason.of("link.not_opened", address=str(self.address), seconds=OPEN_S)
            raise LinkLost(LossCause.TIMEOUT, slow) from None
        except ssl.SSLError as fault:
            why = Reason.plain(str(fault.reason))
            not_private = Reason.of("link.not_private", address=str(self.address), why=why)
            raise LinkLost(LossCause.CERTIFICATE, not_private) from None
        except OSError as fault:
            ended = Reason.of("link.opening_ended", address=str(self.address), why=system_reason(fault))
            raise LinkLost(LossCause.UNREACHABLE, ended) from None
        heartbeat_sender = None if self.tunnel is not None else _heartbeat_sender(private, protocol)
        return WebSocketCarrier(private, protocol, heartbeat_sender=heartbeat_sender)

    def _secure(self, connected: socket.socket) -> socket.socket:
        if not self.address.is_private:
            return connected
        return trusting(self.authority, self.address.host).wrap_socket(connected, server_hostname=self.address.host)

    def _shake(self, connected: socket.socket, protocol: ClientProtocol, until: float) -> None:
        connected.sendall(b"".join(protocol.data_to_send()))
        while protocol.state is State.CONNECTING and protocol.handshake_exc is None:
            connected.settimeout(max(0.001, until - monotonic()))
            data = connected.recv(4096)
            protocol.receive_data(data) if data else protocol.receive_eof()
        fault = protocol.handshake_exc
        if isinstance(fault, InvalidStatus):
            status = fault.response.status_code
            cause, words = _REFUSED.get(status, (LossCause.REFUSED, Reason.of("link.no_link_there")))
            why = _reason_in(fault.response) or words
            raise LinkLost(cause, Reason.of("link.refused", address=str(self.address), status=status, why=why))
        if fault is not None:
            no_websocket = Reason.of("link.no_websocket", address=str(self.address), why=Reason.plain(str(fault)))
            raise LinkLost(LossCause.GARBAGE, no_websocket)


def _reason_in(refusal: Response) -> Reason:
    """Why a request was refused: as a runtime says it to programs, else the text that came with it."""
    reason = refusal_header.read(",".join(refusal.headers.get_all(refusal_header.HEADER)))
    if reason is not None:
        return reason
    return Reason.plain(bytes(refusal.body or b"").decode("utf-8", "replace").strip()[:500])


def _heartbeat_sender(connected: socket.socket, protocol: ClientProtocol) -> HeartbeatSender | None:
    """What beats beside the connection, where the runtime has told how."""
    answers = [event for event in protocol.events if isinstance(event, Response)]
    heartbeat_key = HeartbeatKey.parse(answers[0].headers.get(HEADER, "")) if answers else None
    if heartbeat_key is None:
        return None
    return HeartbeatSender(heartbeat_key, connected.getpeername()[0], connected.family)


Open = Callable[[Channel], WebSocketCarrier]
"""What opens a connection: a `WebSocketOpening`, or a test's."""
