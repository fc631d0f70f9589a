"""The listener as a process, so that TLS, HTTP, garbage and floods never touch the program.

It lets in whom admission lets in and hands the program one end of a socket pair for each connection.
"""

import argparse
import asyncio
import contextlib
import os
import select
import signal
import socket
import ssl
import sys
from functools import partial

from msgspec import msgpack

from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.process_socket import ProcessSocket
from onika.host.sessions.admission import Admission, LetIn
from onika.host.sessions.heartbeat_registry import HeartbeatRegistry
from onika.host.sessions.listen_options import ListenerSettings, context
from onika.host.sessions.listener_process import (
    AWAKE_NS,
    ConnectionArrived,
    ListenerAwake,
    ListenerReady,
    ListenFailed,
    encode,
)
from onika.host.sessions.relay import ConnectionRefused, Relay
from onika.host.sessions.users import Users
from onika.link.channel import Channel
from onika.link.child.launcher import die_with_parent
from onika.link.heartbeat import LENGTH
from onika.wire.packet import Hello
from onika.words.reason import Reason
from onika.words.system_error import system_reason

GREETING_S = 5.0
"""How long everything may take until the greeting is there: TLS, HTTP, WebSocket, hello."""
_AT_ONCE = 12
"""Connections that are taken before those in the door are heard; well below what the door holds of one address."""
_RELAYS = 256
"""Connections at most that are let in."""
_IDLE = 100
"""How often it is still said after the last one has gone: his silence is to be noticed."""
_BEATS = 64
"""Datagrams that are read at a time."""
_LAST_S = 0.5
_WAITING = 32 * 1024
"""Bytes of readings that wait on their way to the listener; what is not yet there can still be told anew."""

_AWAKE = encode(ListenerAwake())


class Acceptor:
    """Who stands in the door, and who was let in."""

    def __init__(self, listening: ListenerSettings, post: ProcessSocket) -> None:
        self._listening = listening
        self._post = post
        is_private = bool(listening.certificate)
        self._admission = Admission(Users(listening.users), listening.names, is_private)
        self._context: ssl.SSLContext | None = context(listening.certificate, listening.key) if is_private else None
        self._tasks: dict[int, asyncio.Task[None]] = {}
        self._relays: set[asyncio.Task[None]] = set()
        self._inside = 0
        self._heartbeats = HeartbeatRegistry()

    async def serve(self, listener: socket.socket, beats: socket.socket | None) -> None:
        """Take connections until the program is gone; and their beats, where they can come as datagrams."""
        loop = asyncio.get_running_loop()
        if beats is not None:
            self._heartbeats.port = beats.getsockname()[1]
            loop.add_reader(beats.fileno(), self._take_beats, beats)
        loop.call_soon(self._say_awake, loop, _IDLE)
        gone = asyncio.Event()
        loop.add_reader(self._post.fileno(), self._look, gone)
        accepting = asyncio.create_task(self._accept(listener))
        await gone.wait()
        accepting.cancel()
        listener.close()
        if self._relays:  # their ends in the program are closed: what it said last is still on its way
            await asyncio.wait(self._relays, timeout=_LAST_S)
        os._exit(0)

    def _look(self, gone: asyncio.Event) -> None:
        self._post.receive()  # the program says nothing more: only its end can be heard
        if self._post.is_closed:
            gone.set()

    def _say_awake(self, loop: asyncio.AbstractEventLoop, idle: int) -> None:
        """What came before this turn of the loop is passed on by now."""
        idle = 0 if self._inside else idle + 1
        if idle <= _IDLE and not self._post.is_waiting:
            self._post.send(_AWAKE)
        loop.call_later(AWAKE_NS * 1e-9, self._say_awake, loop, idle)

    def _take_beats(self, beats: socket.socket) -> None:
        """Some at a time: whoever floods the port keeps nobody else waiting."""
        for _ in range(_BEATS):
            try:
                datagram = beats.recv(LENGTH + 1)
            except OSError:
                return
            self._heartbeats.take(datagram)

    async def _accept(self, listener: socket.socket) -> None:
        loop = asyncio.get_running_loop()
        taken = 0
        while True:
            try:
                connected, peer = await loop.sock_accept(listener)
            except OSError:  # too many open files: those in the door leave within seconds
                await asyncio.sleep(0.1)
                continue
            taken += 1
            if taken % _AT_ONCE == 0:  # a few at a time: who has said what he wants is heard before others crowd in
                await asyncio.sleep(0)
            number, evicted = self._admission.enter(peer[0])
            if evicted is not None and evicted in self._tasks:
                self._tasks[evicted].cancel()
            task = asyncio.create_task(self._receive(number, connected, peer[0]))
            self._tasks[number] = task
            self._relays.add(task)
            task.add_done_callback(partial(self._gone, number))

    def _gone(self, number: int, task: "asyncio.Task[None]") -> None:
        self._relays.discard(task)
        self._tasks.pop(number, None)
        self._admission.leave(number)

    async def _receive(self, number: int, connected: socket.socket, address: str) -> None:
        """One connection from its first byte to its last."""
        relay = None
        try:
            async with asyncio.timeout(GREETING_S):
                relay = await self._relay(connected, address)
                answer, hello, payloads = await relay.greet(self._admission, number)
            self._tasks.pop(number, None)
            await self._inwards(relay, answer, hello, payloads, address)
        except (ConnectionRefused, OSError, TimeoutError, asyncio.CancelledError):
            pass
        finally:
            if relay is None:
                connected.close()
            else:
                await relay.end()

    async def _relay(self, connected: socket.socket, address: str) -> Relay:
        connected.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        loop = asyncio.get_running_loop()
        reader = asyncio.StreamReader(limit=64 * 1024)
        protocol = asyncio.StreamReaderProtocol(reader)
        limit = GREETING_S if self._context is not None else None
        transport, _ = await loop.connect_accepted_socket(
            lambda: protocol, connected, ssl=self._context, ssl_handshake_timeout=limit
        )
        return Relay(reader, asyncio.StreamWriter(transport, protocol, reader, loop), address, self._heartbeats)

    async def _inwards(self, relay: Relay, answer: LetIn, hello: Hello, payloads: list[bytes], address: str) -> None:
        if self._inside >= _RELAYS:
            return
        self._inside += 1
        ours, theirs = socket.socketpair()
        if answer.channel is Channel.STREAM:
            relay.favour_newest()
            theirs.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, _WAITING)
        try:
            user = answer.user
            arrived = ConnectionArrived(
                answer.channel.value, hello.client, hello.epoch, user.name, int(user.role), address
            )
            self._post.send(encode(arrived), (theirs.fileno(),))
            while self._post.is_waiting:  # only what was really sent may be closed here
                await asyncio.sleep(0.01)
                self._post.flush()
            theirs.close()
            await relay.carry(payloads, ours)
        finally:
            ours.close()
            theirs.close()
            self._inside -= 1


def listen(host: str, port: int) -> socket.socket:
    """A listening socket; raises OSError."""
    family, kind, number, _, where = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
    listener = socket.socket(family, kind, number)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(where)
        listener.listen(512)
    except OSError:
        listener.close()
        raise
    listener.setblocking(False)
    return listener


def hear_beats(listener: socket.socket) -> socket.socket | None:
    """A socket for datagrams where connections are taken, under the same number if that is free; None: none is."""
    where = listener.getsockname()
    for port in (where[1], 0):
        beats = socket.socket(listener.family, socket.SOCK_DGRAM)
        try:
            beats.bind((where[0], port, *where[2:]))
        except OSError:
            beats.close()
            continue
        beats.setblocking(False)
        return beats
    return None


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--fd", type=int, required=True)
    parser.add_argument("--parent", type=int, required=True)
    given = parser.parse_args(words)
    die_with_parent(given.parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_output_pipes()
    os.nice(5)
    post = ProcessSocket(socket.socket(fileno=given.fd))
    select.select([post], [], [])
    came = post.receive()
    if came is None:
        return
    listening = msgpack.decode(came[0], type=ListenerSettings)
    try:
        listener = listen(listening.host, listening.port)
        beats = hear_beats(listener)
        acceptor = Acceptor(listening, post)
    except OSError as wrong:
        reason = Reason.of("host.cannot_listen", host=listening.host, port=listening.port, why=system_reason(wrong))
        post.send(encode(ListenFailed(reason)))
        return
    post.send(encode(ListenerReady(listener.getsockname()[1])))
    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(acceptor.serve(listener, beats))


if __name__ == "__main__":
    main(sys.argv[1:])
