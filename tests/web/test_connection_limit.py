import asyncio

import pytest
import uvicorn
from starlette.applications import Starlette
from starlette.responses import PlainTextResponse
from starlette.routing import Route, WebSocketRoute
from websockets.asyncio.client import connect

from onika.web.connection_limit import limited_protocol
from onika.web.server import bound

MOST = 8


async def answer(_request):
    return PlainTextResponse("here")


async def echo(web_socket):
    await web_socket.accept()
    while True:
        await web_socket.send_text(await web_socket.receive_text())


APP = Starlette(routes=[Route("/", answer), WebSocketRoute("/ws", echo)])


def served(body, limit_s=60.0):
    """What `body` gives, asked of a server at its port."""

    async def run():
        listening = bound(0)
        protocol = limited_protocol(MOST, limit_s)
        config = uvicorn.Config(APP, log_level="error", lifespan="off", http=protocol, ws="websockets-sansio")
        server = uvicorn.Server(config)
        serving = asyncio.ensure_future(server.serve(sockets=[listening]))
        while not server.started:
            await asyncio.sleep(0)
        try:
            return await body(listening.getsockname()[1])
        finally:
            server.should_exit = server.force_exit = True
            await serving

    return asyncio.run(run())


async def answer_at(port):
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    writer.write(b"GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n")
    whole = await reader.read()
    writer.close()
    return whole


@pytest.mark.parametrize("first_words", [b"", b"GET / HTTP/1.1\r\nHo"], ids=["silent", "dribbling"])
def test_a_crowd_that_shows_nothing_keeps_nobody_out(first_words):  # R-F01
    async def body(port):
        async with connect(f"ws://127.0.0.1:{port}/ws") as inside:
            crowd = [await asyncio.open_connection("127.0.0.1", port) for _ in range(10 * MOST)]
            for _, writer in crowd:
                writer.write(first_words)
            response = await answer_at(port)
            await inside.send("still here")
            word = await inside.recv()
            ends = [reader.read() for reader, _ in crowd[: 9 * MOST]]
            left = await asyncio.wait_for(asyncio.gather(*ends, return_exceptions=True), 20)
            for _, writer in crowd:
                writer.close()
            return response, word, left

    response, word, left = served(body)
    assert response.endswith(b"here")
    assert word == "still here"
    assert all(end == b"" or isinstance(end, ConnectionError) for end in left)


def test_who_asks_for_nothing_is_cut_after_a_while():  # R-F01
    async def body(port):
        reader, writer = await asyncio.open_connection("127.0.0.1", port)
        try:
            return await asyncio.wait_for(reader.read(), 20)
        except ConnectionError:
            return b""
        finally:
            writer.close()

    assert served(body, limit_s=0.05) == b""
