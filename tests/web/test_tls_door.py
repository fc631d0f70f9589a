"""The door over TLS: who shakes hands comes in, whoever does not keeps nobody out."""

import asyncio
import contextlib
import socket
import ssl

import pytest

from onika.web import tls_door
from onika.web.access.certificate import server_context
from onika.web.server import bound
from onika.web.tls_door import TlsDoor


class Echo(asyncio.Protocol):
    """Gives back what it is sent."""

    def connection_made(self, transport):
        self.transport = transport

    def data_received(self, data):
        self.transport.write(data)


def at_door(certificate, body):
    """What `body` gives, asked of a door at its port."""
    trusted = ssl.create_default_context(cafile=certificate[0])

    async def run():
        with bound(0) as listening:
            door = TlsDoor(listening, server_context(*certificate), Echo)
            keeping = asyncio.ensure_future(door.keep())
            await asyncio.sleep(0)
            try:
                return await asyncio.wait_for(body(listening.getsockname()[1], trusted), 30)
            finally:
                keeping.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await keeping

    return asyncio.run(run())


async def said(port, trusted):
    reader, writer = await asyncio.open_connection("localhost", port, ssl=trusted, family=socket.AF_INET)
    writer.write(b"here")
    word = await reader.readexactly(4)
    writer.close()
    return word


def test_who_speaks_tls_comes_in(certificate):  # R-F10
    assert at_door(certificate, said) == b"here"


@pytest.mark.parametrize("first", [b"", b"GET / HTTP/1.1\r\nHost: x\r\n\r\n", b"\x16\x03\x01\x02\x00\x01"])
def test_a_crowd_that_shakes_no_hands_keeps_nobody_out(certificate, first, monkeypatch):  # R-F10
    monkeypatch.setattr(tls_door, "HANDSHAKE_S", 0.2)

    async def body(port, trusted):
        crowd = [await asyncio.open_connection("127.0.0.1", port) for _ in range(30)]
        for _, writer in crowd:
            writer.write(first)
        word = await said(port, trusted)
        ends = await asyncio.gather(*(reader.read() for reader, _ in crowd), return_exceptions=True)
        for _, writer in crowd:
            writer.close()
        return word, ends

    word, ends = at_door(certificate, body)
    assert word == b"here"
    assert len(ends) == 30  # all were cut
