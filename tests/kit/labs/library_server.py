"""A server of a library on this machine, honest or not; it counts what it is asked and over how many connections.

with LibraryServer(folder) as server:
    server.answers["library"] = flood
    … server.address …
"""

import base64
import re
import socket
from collections.abc import Callable, Iterator
from hashlib import sha256
from pathlib import Path
from threading import Event, Lock, Thread
from typing import Self

Answer = Callable[[socket.socket], object]
"""Answers one question over its connection, in its own way."""


class LibraryServer:
    """Gives the files of a folder; `answers` stand before them, by paths."""

    def __init__(self, folder: Path, password: str = "", delay_s: float = 0.0, *, knows_pieces: bool = False) -> None:
        self.folder = folder
        self.knows_pieces = knows_pieces
        self.pieces: list[tuple[int, int]] = []
        """From where to where pieces of files were asked for."""
        self.answers: dict[str, Answer] = {}
        self.takes: Callable[[bytes], bytes] | None = None
        """What is answered to whatever somebody sends; None: nothing is taken."""
        self.asked: list[str] = []
        self.connections = 0
        self.stop = Event()
        self.password = password
        self._delay_s = delay_s
        self._lock = Lock()
        self._socket = socket.create_server(("127.0.0.1", 0), backlog=64)
        self._open: list[socket.socket] = []

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self._socket.getsockname()[1]}"

    def __enter__(self) -> Self:
        Thread(target=self._accept, daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self.stop.set()
        self._socket.close()
        for connection in self._open:
            connection.close()

    def _accept(self) -> None:
        while True:
            try:
                connection, _ = self._socket.accept()
            except OSError:
                return
            self.connections += 1
            self._open.append(connection)
            Thread(target=self._serve, args=(connection,), daemon=True).start()

    def _serve(self, connection: socket.socket) -> None:
        with connection:
            try:
                for head, body in _questions(connection):
                    if head.startswith("POST ") and self.takes is not None:
                        connection.sendall(answer(self.takes(body), kind="application/json"))
                    else:
                        self._answer(connection, head)
            except OSError:
                return

    def _answer(self, connection: socket.socket, head: str) -> None:
        path = head.split(" ", 2)[1].lstrip("/")
        with self._lock:
            self.asked.append(path)
        self.stop.wait(self._delay_s)
        if path in self.answers:
            self.answers[path](connection)
            return
        if self.password and f"\r\nAuthorization: {self._wanted()}\r\n" not in head:
            connection.sendall(b"HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\n\r\n")
            return
        file = self.folder / path
        span = re.search(r"\r\nRange: bytes=([0-9]+)-([0-9]+)\r\n", head)
        if span is not None and self.knows_pieces and file.is_file():
            connection.sendall(self._piece(file.read_bytes(), int(span[1]), int(span[2]) + 1))
        elif file.is_file():
            connection.sendall(answer(file.read_bytes()))
        else:
            connection.sendall(b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n")

    def _piece(self, content: bytes, begin: int, end: int) -> bytes:
        with self._lock:
            self.pieces.append((begin, end))
        return piece(content, begin, end)

    def _wanted(self) -> str:
        return "Basic " + base64.b64encode(self.password.encode()).decode()


def answer(content: bytes, *, length: int | None = None, kind: str = "text/plain") -> bytes:
    """A whole answer; `length` is what it says of itself where that is a lie."""
    size = len(content) if length is None else length
    return f"HTTP/1.1 200 OK\r\nContent-Type: {kind}\r\nContent-Length: {size}\r\n\r\n".encode() + content


def piece(content: bytes, begin: int, end: int, *, size: int | None = None) -> bytes:
    """A piece of a file as an answer; `size` is what it says of the whole where that is a lie."""
    part, mark = content[begin:end], sha256(content).hexdigest()
    whole = len(content) if size is None else size
    head = f"HTTP/1.1 206 Partial Content\r\nContent-Length: {len(part)}\r\nETag: {mark}\r\n"
    return f"{head}Content-Range: bytes {begin}-{begin + len(part) - 1}/{whole}\r\n\r\n".encode() + part


def moved(location: str) -> Answer:
    """Send whoever asks somewhere else."""
    return lambda connection: connection.sendall(
        f"HTTP/1.1 302 Found\r\nContent-Length: 0\r\nLocation: {location}\r\n\r\n".encode()
    )


def flood(connection: socket.socket) -> None:
    """An answer that does not end."""
    connection.sendall(b"HTTP/1.1 200 OK\r\n\r\n")
    while True:
        connection.sendall(b"x" * 65536)


def drip(stop: Event, every_s: float) -> Answer:
    """A byte now and then."""

    def drop(connection: socket.socket) -> None:
        connection.sendall(b"HTTP/1.1 200 OK\r\nContent-Length: 100000\r\n\r\n")
        while not stop.wait(every_s):
            connection.sendall(b"x")

    return drop


def slow_head(stop: Event, every_s: float) -> Answer:
    """A head that does not end, a byte now and then."""

    def drop(connection: socket.socket) -> None:
        connection.sendall(b"HTTP/1.1 200 OK\r\nX-A: ")
        while not stop.wait(every_s):
            connection.sendall(b"x")

    return drop


def _questions(connection: socket.socket) -> Iterator[tuple[str, bytes]]:
    """The heads of questions and what is sent with them, one after the other."""
    left = b""
    while True:
        while b"\r\n\r\n" not in left:
            part = connection.recv(65536)
            if not part:
                return
            left += part
        head, _, left = left.partition(b"\r\n\r\n")
        length = re.search(rb"\r\nContent-Length: ([0-9]+)", head)
        size = int(length[1]) if length else 0
        while len(left) < size:
            left += connection.recv(65536)
        body, left = left[:size], left[size:]
        yield head.decode("latin-1") + "\r\n", body
