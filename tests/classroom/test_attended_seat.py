import asyncio
import socket
import time

import pytest

from onika.classroom import messages
from onika.classroom.attended_seat import SILENT_S, AttendedSeat
from onika.words.reason import NOTHING, Reason


class Process:
    """A process that is none; `theirs` is its end of the way to the class."""

    def __init__(self):
        self.pid, self.is_killed = 4711, False
        self.ours, self.theirs = socket.socketpair()
        self.ours.setblocking(False)

    def kill(self):
        self.is_killed = True
        self.theirs.close()

    def join(self, timeout=None):
        assert self.is_killed

    def says(self, *news):
        self.theirs.sendall(b"".join(map(messages.line, news)))


class Story:
    """A seat, its processes one after the other, and what its class was told."""

    def __init__(self):
        self.processes, self.told, self.now_s = [], [], 0.0

        async def hears(news):
            self.told.append(news)

        self.seat = AttendedSeat(self._begins, hears, lambda: self.now_s)

    def _begins(self):
        process = Process()
        process.says(messages.Opened(), messages.SeatStanding(pages=1))
        self.processes.append(process)
        return process, process.ours, 9001

    async def until(self, holds):
        until_s = time.monotonic() + 30
        while not holds():
            assert time.monotonic() < until_s
            await asyncio.sleep(0.001)


def played(tell):
    story = Story()
    asyncio.run(asyncio.wait_for(tell(story), 60))


def test_a_seat_begins_when_somebody_comes_and_once_for_all_who_come_together():  # R-X25
    async def tell(story):
        assert story.seat.state == "off"
        assert await asyncio.gather(*(story.seat.ready() for _ in range(3))) == [True] * 3
        await story.until(lambda: story.seat.standing.pages == 1)
        assert (len(story.processes), story.seat.state, story.seat.port) == (1, "there", 9001)
        await story.seat.end(NOTHING)

    played(tell)


def test_a_seat_that_says_nothing_is_silent():  # R-X25
    async def tell(story):
        await story.seat.ready()
        await story.until(lambda: story.seat.standing.pages == 1)
        story.now_s += SILENT_S + 1
        assert (story.seat.state, story.seat.silent_s) == ("silent", SILENT_S + 1)
        await story.seat.end(NOTHING)

    played(tell)


@pytest.mark.parametrize(
    ("does", "why"),
    [
        (lambda process: process.theirs.close(), "class.seat_ended"),
        (lambda process: process.theirs.sendall(b"?\n"), "class.seat_spoilt"),
    ],
)
def test_one_that_ends_or_talks_nonsense_is_off_and_begins_anew(does, why):  # R-X25
    async def tell(story):
        await story.seat.ready()
        does(story.processes[0])
        await story.until(lambda: story.seat.state == "off" and story.seat.ended)
        assert story.seat.ended.key == why
        assert await story.seat.ready()
        assert len(story.processes) == 2
        assert (story.seat.began_anew.key, story.seat.ended) == (why, NOTHING)
        await story.seat.end(NOTHING)

    played(tell)


def test_one_that_left_in_order_knows_why_when_it_begins_anew():  # R-X25
    async def tell(story):
        await story.seat.ready()
        assert not story.seat.began_anew
        leaving = asyncio.ensure_future(story.seat.leave(30.0, Reason.of("class.seat_left", minutes=20)))
        await asyncio.sleep(0)
        story.processes[0].theirs.close()
        await leaving
        assert await story.seat.ready()
        assert story.seat.began_anew == Reason.of("class.seat_left", minutes=20)
        await story.seat.end(NOTHING)

    played(tell)


def test_a_line_without_end_is_cut_off():  # R-X25
    async def tell(story):
        await story.seat.ready()
        with story.processes[0].theirs.dup() as theirs:
            theirs.setblocking(False)
            loop = asyncio.get_running_loop()
            sending = asyncio.ensure_future(loop.sock_sendall(theirs, b"x" * 4 * messages.LONGEST))
            await story.until(lambda: story.seat.state == "off" and story.seat.ended)
            sending.cancel()
            await asyncio.wait((sending,))
        assert story.seat.ended.key == "class.seat_spoilt"

    played(tell)


def test_orders_reach_it_and_hand_ins_reach_the_class():
    async def tell(story):
        await story.seat.ready()
        story.seat.send(messages.Collect())
        loop = asyncio.get_running_loop()
        story.processes[0].theirs.setblocking(False)
        assert messages.order(await loop.sock_recv(story.processes[0].theirs, 100)) == messages.Collect()
        story.processes[0].says(messages.HandedIn("handed-in/0001"))
        await story.until(lambda: story.told == [messages.HandedIn("handed-in/0001")])
        await story.seat.end(NOTHING)

    played(tell)
