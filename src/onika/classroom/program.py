"""A class as a program: its front, its seats and its board, until Ctrl-C (requirement X25)."""

import asyncio
import fcntl
import os
import ssl
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from onika.classroom.forks import Forks
from onika.classroom.front import ClassFront
from onika.classroom.grading import Grading
from onika.classroom.room import ClassRoom
from onika.classroom.seat_program import SeatSettings
from onika.files.state.state_directory import make_own
from onika.link.address import bracketed
from onika.web.app import STATIC
from onika.web.server import bound, serve
from onika.words.reason import Reason

BOARD = STATIC / "board"
"""The board as it was built, beside the page."""
LOOPBACK = ("127.0.0.1", "localhost")


@dataclass(frozen=True, slots=True)
class ClassOptions:
    """What a class is to be.

    seat        what every seat is; its folder is that of all seats
    grading     what is expected of hand-ins
    host        where it listens; over TLS where there is a context
    port        of the front; those of the seats follow it over TLS, else any that are free are taken
    memory      bytes that a seat may take
    """

    folder: Path
    seats: int
    seat: SeatSettings
    grading: Grading
    host: str
    port: int
    memory: int
    context: ssl.SSLContext | None = None


class ClassProgram:
    """A class; raises OSError where another program has its folder, or its port is taken, ValueError for its file."""

    def __init__(self, options: ClassOptions) -> None:
        make_own(options.folder)
        self._lock = os.open(options.folder / ".lock", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(self._lock)
            raise OSError(Reason.of("class.open_already", folder=str(options.folder))) from None
        self._options = options
        self._listening = bound(options.port, options.host)
        first = options.port + 1 if options.context is not None else 0
        forks = Forks(options.seat, options.host, first)
        forks.warm()
        grader = forks.grader(options.grading, options.folder / "grading")
        self.room = ClassRoom(options.folder, options.seats, forks.seat, grader, options.memory)

    def run(self, tell: Callable[[str, str, str], None]) -> None:
        """Until Ctrl-C; `tell` is told the address of the class, its code, and each address that opens the board."""
        try:
            asyncio.run(self._run(tell))
        finally:
            os.close(self._lock)

    async def _run(self, tell: Callable[[str, str, str], None]) -> None:
        options = self._options
        is_secure = options.context is not None
        port = self._listening.getsockname()[1]
        address = f"{'https' if is_secure else 'http'}://{bracketed(options.seat.names[0])}:{port}/"

        def on_key(key: str) -> None:
            tell(address, self.room.roster.code, f"{address}board?key={key}")

        front = ClassFront(self.room, options.seat.names, port, BOARD, is_secure=is_secure, on_key=on_key)
        beside = (self.room.keep(),)
        try:
            await serve(front.application(), self._listening, beside, lambda: on_key(front.login.key), options.context)
        finally:
            self._listening.close()
            await self.room.close()
