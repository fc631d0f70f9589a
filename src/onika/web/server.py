"""The server of the page: the web application on a port, in one loop with the environment."""

import asyncio
import socket
import ssl
from collections.abc import Callable, Coroutine, Iterable, Sequence
from typing import Any

import uvicorn
from starlette.applications import Starlette

from onika.web.connection_limit import limited_protocol
from onika.web.tls_door import TlsDoor

_BIGGEST = 8 * 1024 * 1024


def bound(port: int, host: str = "127.0.0.1") -> socket.socket:
    """A socket there, else on the loopback; port 0 takes any that is free. Raises OSError where the port is taken."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    listening = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)  # named: so asyncio delays no answer
    listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind((host, port))
    except OSError:
        listening.close()
        raise
    return listening


def addresses(listening: socket.socket) -> tuple[str, ...]:
    """What a browser may call this machine by."""
    port = listening.getsockname()[1]
    return tuple(f"{name}:{port}" for name in ("127.0.0.1", "localhost"))


async def serve(
    app: Starlette,
    listening: socket.socket,
    beside: Iterable[Coroutine[Any, Any, object]],
    on_ready: Callable[[], None],
    context: ssl.SSLContext | None = None,
) -> None:
    """Serve until Ctrl-C, or until one of what runs `beside` ends; raises what it raised. With `context` over TLS.

    At the end all that runs beside is cancelled, and has ended when this returns: what it has begun it may finish.
    """
    config = uvicorn.Config(
        app,
        log_level="warning",
        access_log=False,
        lifespan="off",
        http=limited_protocol(),
        ws="websockets-sansio",
        ws_max_size=_BIGGEST,
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=1,
        proxy_headers=False,  # nobody says for another from where he comes
        server_header=False,
    )
    server = uvicorn.Server(config)
    others = [asyncio.ensure_future(coroutine) for coroutine in beside]
    serving = asyncio.ensure_future(server.serve(sockets=[] if context else [listening]))
    while not server.started and not serving.done():
        await asyncio.sleep(0.005)
    if context is not None:
        others.append(asyncio.ensure_future(TlsDoor(listening, context, _protocols(server)).keep()))
    on_ready()
    try:
        await asyncio.wait((serving, *others), return_when=asyncio.FIRST_COMPLETED)
        server.should_exit = True
        await serving
    finally:
        await _cancelled(others)
    _raise_first(others)


async def until_first_ends(coroutines: Iterable[Coroutine[Any, Any, object]]) -> None:
    """Run all until one of them ends; the others are cancelled then, and have ended when this returns.

    Raises what one of them raised.
    """
    tasks = [asyncio.ensure_future(coroutine) for coroutine in coroutines]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        await _cancelled(tasks)
    _raise_first(tasks)


async def _cancelled(tasks: Sequence["asyncio.Task[object]"]) -> None:
    for task in tasks:
        task.cancel()
    await asyncio.wait(tasks)


def _raise_first(tasks: Iterable["asyncio.Task[object]"]) -> None:
    """Raise what the first of these tasks, which have all ended, has raised; nothing where none has."""
    for task in tasks:
        if not task.cancelled():
            task.result()


def _protocols(server: uvicorn.Server) -> Callable[[], asyncio.Protocol]:
    """What makes the protocol of a connection that has come in through another door than the server's own."""
    protocol: Callable[..., asyncio.Protocol] = server.config.http_protocol_class
    state = server.lifespan.state
    return lambda: protocol(config=server.config, server_state=server.server_state, app_state=state)
