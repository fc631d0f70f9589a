"""One seat as its class sees it: its process, what it tells, and its end (requirement X25).

A seat that is silent for long, or takes more memory than it may, is ended; whoever comes to it starts it anew, and
what was not saved is there again.
"""

import asyncio
import socket
from collections.abc import Awaitable, Callable
from contextlib import suppress
from time import monotonic
from typing import Protocol

from onika.classroom import messages
from onika.classroom.footprint import Footprint
from onika.words.reason import NOTHING, Reason

READY_S = 90.0
"""So long a seat may take to open: twenty may start at once on two processors."""
SILENT_S = 15.0
"""After so long without a word it is said to be silent."""
HUNG_S = 60.0
"""And after so long it is ended."""


class SeatProcess(Protocol):
    """The process of a seat."""

    @property
    def pid(self) -> int | None:
        """Its number."""
        ...

    def kill(self) -> None:
        """End it now."""
        ...

    def join(self, timeout: float | None = None) -> None:
        """Wait for its end."""
        ...


Begins = Callable[[], tuple[SeatProcess, socket.socket, int]]
"""Starts the process of a seat: it, the way to it, and the port of its page. May take long; raises OSError."""
Hears = Callable[[messages.News], Awaitable[None]]


class AttendedSeat:
    """A seat; `hears` is told what it says beside how its learner gets on."""

    def __init__(self, begins: Begins, hears: Hears, clock: Callable[[], float] = monotonic) -> None:
        self._begins = begins
        self._hears = hears
        self._clock = clock
        self._process: SeatProcess | None = None
        self._writer: asyncio.StreamWriter | None = None
        self._reading: asyncio.Task[None] | None = None
        self._starting = asyncio.Lock()
        self._opened = asyncio.Event()
        self._heard_s = 0.0
        self.port = 0
        self.standing = messages.SeatStanding()
        self.footprint = Footprint()
        self.ended = NOTHING
        """Why it was ended last, if it did not end by itself."""
        self.began_anew = NOTHING
        """Why the process before this one ended."""

    @property
    def pid(self) -> int | None:
        """Its process; None: there is none."""
        return None if self._process is None else self._process.pid

    @property
    def state(self) -> str:
        """`off`, `starting`, `there`, or `silent`."""
        if self._process is None:
            return "off"
        if not self._opened.is_set():
            return "starting"
        return "silent" if self._clock() - self._heard_s > SILENT_S else "there"

    @property
    def silent_s(self) -> float:
        """How long nothing was heard of it."""
        return 0.0 if self._process is None else self._clock() - self._heard_s

    async def ready(self) -> bool:
        """Have it there; whether it is."""
        async with self._starting:
            if self._process is None:
                await self._begin()
        with suppress(TimeoutError):
            await asyncio.wait_for(self._opened.wait(), READY_S)
        return self._process is not None and self._opened.is_set()

    def send(self, order: messages.SeatOrder) -> None:
        """Order something; a seat that is not there is told when it begins what it has to know."""
        if self._writer is not None and not self._writer.is_closing():
            self._writer.write(messages.line(order))

    async def leave(self, patience_s: float, reason: Reason = NOTHING) -> None:
        """Let it end in order, or end it after so long."""
        self.send(messages.LeaveClass())
        reading = self._reading
        if reading is not None:
            await asyncio.wait((reading,), timeout=patience_s)
        await self.end(reason)
        self.ended = reason

    async def end(self, reason: Reason) -> None:
        """End it now; all that it has started ends with it."""
        process, self._process = self._process, None
        if process is None:
            return
        self.ended = reason
        process.kill()
        await asyncio.to_thread(process.join, 5.0)
        if self._writer is not None:
            self._writer.close()
        self._opened.clear()
        self.footprint = Footprint()

    # Inner

    async def _begin(self) -> None:
        self.began_anew, self.ended = self.ended, NOTHING
        self._opened.clear()
        self.standing, self._heard_s = messages.SeatStanding(), self._clock()
        process, channel, self.port = await asyncio.to_thread(self._begins)
        self._process = process
        reader, self._writer = await asyncio.open_connection(sock=channel, limit=messages.LONGEST)
        self._reading = asyncio.create_task(self._read(reader, process))

    async def _read(self, reader: asyncio.StreamReader, process: SeatProcess) -> None:
        """Until it is gone, or says what it never says."""
        why = Reason.of("class.seat_ended")
        try:
            while line := await reader.readline():
                self._heard_s = self._clock()
                await self._take(messages.news(line))
        except (OSError, ValueError):
            why = Reason.of("class.seat_spoilt")
        if self._process is process:
            await self.end(why)

    async def _take(self, news: messages.News) -> None:
        match news:
            case messages.Opened():
                self._opened.set()
            case messages.SeatStanding():
                self.standing = news
            case _:
                await self._hears(news)
