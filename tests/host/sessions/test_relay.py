import asyncio
import contextlib
import socket

import pytest
from websockets.client import ClientProtocol
from websockets.frames import Frame
from websockets.uri import parse_uri

from onika.host.sessions.admission import Admission
from onika.host.sessions.relay import ConnectionRefused, Relay
from onika.host.sessions.users import User, Users
from onika.link import refusal_header
from onika.link.caller import Role
from onika.link.channel import Channel
from onika.link.token import digest
from onika.wire.frame import FrameReader, frame
from onika.wire.packet import Beat, Bye, Hello, decode, encode
from onika.words.reason import Reason, in_language

ANN = User("ann", Role.OWNER, digest("anns"))
HELLO = encode(Hello(2, "me", "", 0))


class Visitor:
    """Somebody outside, and the relay that serves him."""

    def __init__(self):
        self.admission = Admission(Users((ANN,)), ("localhost",), is_private=False)
        self.protocol = ClientProtocol(parse_uri("ws://localhost/signal"))

    async def __aenter__(self):
        ours, theirs = socket.socketpair()
        self.reader, self.writer = await asyncio.open_unix_connection(sock=ours)
        self.relay = Relay(*await asyncio.open_unix_connection(sock=theirs), "127.0.0.1")
        return self

    async def __aexit__(self, *_):
        await self.relay.end()
        self.writer.close()
        await asyncio.sleep(0)

    def ask(self, token="anns", languages=()):
        request = self.protocol.connect()
        request.headers["Authorization"] = f"Bearer {token}"
        for language in languages:
            request.headers["Accept-Language"] = language
        self.protocol.send_request(request)
        self.flush()

    def say(self, payload):
        self.protocol.send_binary(payload)
        self.flush()

    def flush(self):
        for data in self.protocol.data_to_send():
            if data:
                self.writer.write(data)

    async def hear(self):
        """The messages that came next."""
        while True:
            self.protocol.receive_data(await self.reader.read(65536))
            frames = [bytes(part.data) for part in self.protocol.events_received() if isinstance(part, Frame)]
            if frames:
                return frames

    async def greet(self):
        return await self.relay.greet(self.admission, 1)

    async def shake(self):
        """The handshake with the relay."""
        greeting = asyncio.create_task(self.greet())
        self.ask()
        while self.protocol.state.name == "CONNECTING":
            self.protocol.receive_data(await self.reader.read(65536))
        self.protocol.events_received()
        return greeting


def in_loop(story):
    async def bounded():
        async with asyncio.timeout(10.0), Visitor() as visitor:
            await story(visitor)

    asyncio.run(bounded())


def test_whom_the_token_and_the_hello_introduce_is_let_in():
    async def story(visitor):
        greeting = await visitor.shake()
        visitor.say(HELLO)
        answer, hello, payloads = await greeting
        assert (answer.user, answer.channel) == (ANN, Channel.SIGNAL)
        assert (hello.client, payloads) == ("me", [HELLO])

    in_loop(story)


def test_a_wrong_token_is_answered_and_ends_it():
    async def story(visitor):
        visitor.ask("wrong")
        with pytest.raises(ConnectionRefused, match="401"):
            await visitor.greet()
        assert (await visitor.reader.read(65536)).startswith(b"HTTP/1.1 401 ")

    in_loop(story)


def answer_in(data):
    """Status, headers and body of an HTTP answer."""
    head, _, body = data.decode().partition("\r\n\r\n")
    status, *lines = head.split("\r\n")
    return status, dict(line.split(": ", 1) for line in lines), body


@pytest.mark.parametrize(("languages", "language"), [((), "en"), (("es",), "es"), (("fr", "es;q=0.4"), "es")])
def test_a_refusal_is_said_in_the_language_that_was_asked_for_and_names_its_key(languages, language):  # R-G03
    async def story(visitor):
        visitor.ask("wrong", languages)
        with pytest.raises(ConnectionRefused):
            await visitor.greet()
        status, headers, body = answer_in(await visitor.reader.read(65536))
        wrong = Reason.of("host.wrong_token")
        assert status == "HTTP/1.1 401 Unauthorized"
        assert headers["Content-Language"] == language
        assert refusal_header.read(headers[refusal_header.HEADER]) == wrong
        assert body == f"{in_language(wrong, language)}\n"
        assert int(headers["Content-Length"]) == len(body.encode())

    in_loop(story)


def test_who_opens_no_websocket_is_told_so_and_what_it_would_take():
    async def story(visitor):
        visitor.writer.write(b"GET / HTTP/1.1\r\nHost: localhost\r\nAccept-Language: es\r\n\r\n")
        with pytest.raises(ConnectionRefused, match="426"):
            await visitor.greet()
        _, headers, body = answer_in(await visitor.reader.read(65536))
        assert headers["Upgrade"] == "websocket"
        assert body == f"{in_language(Reason.of('host.no_handshake'), 'es')}\n"

    in_loop(story)


GARBAGE = [b"\x00\x01\n\n", b"GET / HTTP/1.1\r\n\r\n", b"x" * 20_000, b"POST / HTTP/1.1\r\n\r\n"]


@pytest.mark.parametrize("data", GARBAGE)
def test_garbage_is_unwelcome(data):
    async def story(visitor):
        visitor.writer.write(data)
        visitor.writer.write_eof()
        with pytest.raises(ConnectionRefused):
            await visitor.greet()

    in_loop(story)


def test_one_who_does_not_begin_with_hello_is_told():
    async def story(visitor):
        greeting = await visitor.shake()
        visitor.say(encode(Beat(1, 1)))
        with pytest.raises(ConnectionRefused, match="no hello"):
            await greeting
        assert decode((await visitor.hear())[0]) == Bye("garbage", Reason.of("link.hello_first"))

    in_loop(story)


def test_whole_frames_go_both_ways_until_one_side_ends_it():
    async def story(visitor):
        greeting = await visitor.shake()
        visitor.say(HELLO)
        _, _, payloads = await greeting
        outer, inner = socket.socketpair()
        carrying = asyncio.create_task(visitor.relay.carry(payloads, outer))
        reader, writer = await asyncio.open_unix_connection(sock=inner)
        visitor.say(b"x" * 300_000)
        frames, came = FrameReader(), []
        while len(came) < 2:
            came += frames.feed(await reader.read(65536))
        assert came == [HELLO, b"x" * 300_000]
        writer.write(frame(b"down") + frame(b"again"))
        frames = []
        while len(frames) < 2:
            frames += await visitor.hear()
        assert frames == [b"down", b"again"]
        writer.close()
        await carrying

    in_loop(story)


def test_who_floods_leaves_everybody_his_turn():  # network.md F14
    async def story(visitor):
        greeting = await visitor.shake()
        visitor.say(HELLO)
        _, _, payloads = await greeting
        outer, inner = socket.socketpair()
        inner.setblocking(False)
        for _ in range(3000):
            visitor.protocol.send_binary(bytes(20))
        visitor.flush()
        carrying = asyncio.create_task(visitor.relay.carry(payloads, outer))
        frames, came, most = FrameReader(), 0, 0
        while came < 3001:
            await asyncio.sleep(0)
            with contextlib.suppress(BlockingIOError):
                count = len(list(frames.feed(inner.recv(1 << 20))))
                came, most = came + count, max(most, count)
        carrying.cancel()
        await asyncio.gather(carrying, return_exceptions=True)
        inner.close()
        assert most < 700  # of the 8 kB that are looked at in one turn, and what a turn of the test may miss

    in_loop(story)


def test_what_is_to_be_newest_does_not_wait_in_the_system():  # R-F08
    async def measured():
        listener = socket.create_server(("127.0.0.1", 0))
        near = socket.create_connection(listener.getsockname())
        far, _ = listener.accept()
        reader, writer = await asyncio.open_connection(sock=far)
        Relay(reader, writer, "127.0.0.1").favour_newest()
        unsent = far.getsockopt(socket.IPPROTO_TCP, 25)
        writer.close()
        near.close()
        listener.close()
        return unsent, writer.transport.get_write_buffer_limits()[1]

    assert asyncio.run(measured()) == (16 * 1024, 16 * 1024)
