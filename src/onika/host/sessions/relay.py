"""A relay: one connection from outside; its HTTP and WebSocket end here, whole frames go on to the program."""

import asyncio
import contextlib
import socket
import sys
from time import monotonic_ns

from websockets.http11 import Request, Response
from websockets.protocol import Event, State
from websockets.server import ServerProtocol

from onika.host.sessions.admission import Admission, LetIn, TurnedAway
from onika.host.sessions.heartbeat_registry import HeartbeatRegistry
from onika.link import refusal_header
from onika.link.heartbeat import HEADER, HeartbeatKey
from onika.link.websocket_messages import SILENT, WebSocketMessages
from onika.wire.frame import FRAME_LIMIT, FrameReader, frame
from onika.wire.packet import Beat, Bye, Hello, decode, encode
from onika.words.accepted_language import accepted_language
from onika.words.reason import NOTHING, Reason, in_language

TAKING_S = 10.0
"""How long somebody may take nothing of what is sent to him."""
_CHUNK = 64 * 1024
_TURN = 8 * 1024
"""Bytes from outside that are looked at before it is somebody else's turn: some hundred of the smallest frames."""
_DEMANDS = ("Allow", "Upgrade")
"""Headers in which a refusal of the library says what it would take."""
_NOT_SENT, _CONGESTION = 25, 13
"""Options of a TCP connection of Linux: how many bytes may wait unsent, and what paces it."""
_UNSENT = 16 * 1024
_PACED = b"bbr"
"""It goes by what comes through, and not by what is lost: over an ocean losses say little."""
_MIN_RTT = 148
"""Where it stands in the `tcp_info` of Linux, in us."""


class ConnectionRefused(Exception):
    """There will be no link on this connection; he has been told, as far as he can be."""


class Relay:
    """One connection, given as the streams of its outside."""

    def __init__(
        self,
        reader: asyncio.StreamReader,
        writer: asyncio.StreamWriter,
        address: str,
        heartbeats: HeartbeatRegistry | None = None,
    ) -> None:
        self._heartbeats = heartbeats or HeartbeatRegistry()
        self._heartbeat_key: HeartbeatKey | None = None
        self._inside: asyncio.StreamWriter | None = None
        self._reader = reader
        self._writer = writer
        self._address = address
        self._protocol = ServerProtocol(max_size=FRAME_LIMIT, logger=SILENT)
        self._messages = WebSocketMessages()

    async def greet(self, admission: Admission, number: int) -> tuple[LetIn, Hello, list[bytes]]:
        """Let in or turn away, then wait for the hello: who it is, and all payloads so far. Raises ConnectionRefused.

        From the moment his token is known to be right, nobody else's crowding in the door puts him out again.
        """
        answer = self._answer(await self._request(), admission)
        admission.leave(number)
        payloads: list[bytes] = []
        while not payloads:
            payloads = await self._receive()
        try:
            hello = decode(payloads[0])
        except ValueError:
            hello = Bye("garbage", NOTHING)
        if not isinstance(hello, Hello):
            self._protocol.send_binary(encode(Bye("garbage", Reason.of("link.hello_first"))))
            await self._send()
            raise ConnectionRefused("no hello")
        return answer, hello, payloads

    def favour_newest(self) -> None:
        """Let little wait on the way out: what cannot go yet is told anew, by what is newer, where it came from."""
        connected = self._writer.get_extra_info("socket")
        for option, value in ((_NOT_SENT, _UNSENT.to_bytes(4, sys.byteorder)), (_CONGESTION, _PACED)):
            with contextlib.suppress(OSError):  # not every system has it, or lets everybody choose it
                connected.setsockopt(socket.IPPROTO_TCP, option, value)
        self._writer.transport.set_write_buffer_limits(high=_UNSENT)

    async def carry(self, payloads: list[bytes], inside: socket.socket) -> None:
        """Copy whole frames both ways until one side ends it; each waits for the other, never for more than that."""
        reader, writer = await asyncio.open_unix_connection(sock=inside, limit=_CHUNK)
        inward = asyncio.create_task(self._inward(payloads, writer))
        outward = asyncio.create_task(self._outward(reader))
        try:
            await asyncio.wait((inward, outward), return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in (inward, outward):
                task.cancel()
            await asyncio.gather(inward, outward, return_exceptions=True)
            self._inside = None
            writer.close()

    async def end(self, reason: str = "") -> None:
        """Close, politely where the other side still listens."""
        self._heartbeats.close(self._heartbeat_key)
        with contextlib.suppress(OSError, TimeoutError):
            if self._protocol.state is State.OPEN:
                self._protocol.send_close(1000, reason)
                await self._send()
        self._writer.close()

    async def _request(self) -> Request:
        while True:
            for event in await self._events():
                if isinstance(event, Request):
                    return event
            if self._protocol.handshake_exc is not None:
                await self._send()
                raise ConnectionRefused("no HTTP")

    def _answer(self, request: Request, admission: Admission) -> LetIn:
        response = self._protocol.accept(request)
        answer = self._judge(request, response, admission)
        if isinstance(answer, TurnedAway):
            response = self._refusal(answer, request, response)
        elif answer.channel.asks:
            self._agree(response)
        self._protocol.send_response(response)
        for data in self._protocol.data_to_send():
            self._writer.write(data)
        if not isinstance(answer, LetIn):
            raise ConnectionRefused(f"status {response.status_code}")
        return answer

    def _judge(self, request: Request, response: Response, admission: Admission) -> LetIn | TurnedAway:
        if response.status_code != 101:  # 400, 405, 426: the library says what is wrong with it, in English
            return TurnedAway(response.status_code, Reason.of("host.no_handshake"))
        return admission.judge(request.path, request.headers.raw_items(), self._address, monotonic_ns())

    def _refusal(self, refusal: TurnedAway, request: Request, response: Response) -> Response:
        """The sentence in the language of whoever asked, and the reason in a header for programs."""
        language = accepted_language(",".join(request.headers.get_all("Accept-Language")))
        refused = self._protocol.reject(refusal.status, f"{in_language(refusal.reason, language)}\n")
        refused.headers["Content-Language"] = language
        refused.headers[refusal_header.HEADER] = refusal_header.written(refusal.reason)
        if response.status_code == refusal.status:
            demands = [name for name in _DEMANDS if name in response.headers]
            refused.headers.update({name: response.headers[name] for name in demands})
        return refused

    def _agree(self, response: Response) -> None:
        """Tell the other end, and nobody else, how it may beat beside this connection."""
        self._heartbeat_key = self._heartbeats.open(self._beat)
        if self._heartbeat_key is not None:
            response.headers[HEADER] = self._heartbeat_key.header()

    def _beat(self, count: int) -> None:
        """Hand a beat to the program, unless it has enough to read anyway."""
        writer = self._inside
        if writer is None or writer.transport.is_closing():
            return
        if writer.transport.get_write_buffer_size() < _CHUNK:
            connected = self._writer.get_extra_info("socket")
            writer.write(frame(encode(Beat(count, 0, round_trip_us(connected)))))

    async def _inward(self, payloads: list[bytes], writer: asyncio.StreamWriter) -> None:
        while True:
            writer.write(b"".join(map(frame, payloads)))
            self._inside = writer  # from now on: nothing may come before the hello
            await writer.drain()
            await asyncio.sleep(
                0
            )  # where more is there already, nothing else would wait: whoever floods holds up nobody
            payloads = await self._receive()

    async def _outward(self, reader: asyncio.StreamReader) -> None:
        frames = FrameReader()
        while data := await reader.read(_CHUNK):
            for payload in frames.feed(data):
                self._protocol.send_binary(payload)
            await self._send()

    async def _receive(self) -> list[bytes]:
        """The payloads that came next; raises ConnectionRefused at the end."""
        while True:
            try:
                payloads = self._messages.feed(await self._events())
            except ValueError as wrong:
                self._protocol.fail(1003, str(wrong))
                payloads = []
            await self._send()
            if payloads:
                return payloads
            if self._protocol.state is not State.OPEN:
                raise ConnectionRefused("closed")

    async def _events(self) -> list[Event]:
        data = await self._reader.read(_TURN)
        if data:
            self._protocol.receive_data(data)
        else:
            self._protocol.receive_eof()
        events = self._protocol.events_received()
        if not data and not events and self._protocol.state is State.CONNECTING:
            raise ConnectionRefused("gone")
        return events

    async def _send(self) -> None:
        """Send what waits; raises TimeoutError for somebody who takes nothing."""
        for data in self._protocol.data_to_send():
            if data:
                self._writer.write(data)
        async with asyncio.timeout(TAKING_S):
            await self._writer.drain()


def round_trip_us(connected: socket.socket) -> int:
    """The shortest round trip of a connection within the last minutes, as the system has measured it; 0: unknown."""
    info = connected.getsockopt(socket.IPPROTO_TCP, socket.TCP_INFO, 256)
    if len(info) >= _MIN_RTT + 4:
        return int.from_bytes(info[_MIN_RTT : _MIN_RTT + 4], sys.byteorder)
    return 0
