import asyncio
import socket

import pytest

from kit.desk.app_fixture import AppFixture
from onika.classroom import messages, seat_door
from onika.classroom.seat_door import SeatDoor
from onika.classroom.seat_entrance import SeatEntrance
from onika.classroom.seat_rights import SeatRights
from onika.link.caller import Role
from onika.web.access.entrance import Visitor
from onika.web.hub import Hub
from onika.wire.view import ClassSeatView

ANA = Visitor("Ana", Role.OWNER, "learner")


class Values:
    def watch(self, *_):
        """Nobody has values."""

    def frame(self):
        return None


class Seat:
    """A door and the class at the other end of its way."""

    def __init__(self, folder):
        self.desk = AppFixture(folder / "base")
        self.desk.begun("move", "there")
        environment = self.desk.environment
        self.hub = Hub(environment, Values())
        self.entrance = SeatEntrance(("127.0.0.1",), 9001, "Ana", is_secure=False)
        ours, theirs = socket.socketpair()
        self.ours = ours

        def joins():
            return asyncio.ensure_future(asyncio.open_connection(sock=theirs))

        rights = SeatRights(may_write_code=False)
        own = folder / "home" / "onika"
        self.door = SeatDoor(self.entrance, rights, folder, own, environment, self.hub, joins)

    async def hear(self, kind):
        """The next news of a kind."""
        while True:
            news = messages.news(await self.reader.readline())
            if isinstance(news, kind):
                return news

    def order(self, order):
        self.writer.write(messages.line(order))


def played(folder, tell):
    async def play():
        seat = Seat(folder)
        seat.reader, seat.writer = await asyncio.open_connection(sock=seat.ours)
        keeping = asyncio.ensure_future(seat.door.keep())
        await seat.hear(messages.Opened)
        await tell(seat)
        seat.order(messages.LeaveClass())
        await keeping
        seat.door.close()
        seat.writer.close()

    asyncio.run(asyncio.wait_for(play(), 60))


def test_a_seat_tells_its_class_how_it_stands_and_shows_what_the_class_says(tmp_path):  # R-X25
    async def tell(seat):
        seat.hub.come(ANA)
        standing = await seat.hear(messages.SeatStanding)
        assert standing.icons == 2
        seat.order(messages.ShowSeat(ClassSeatView(1, "Ana", "frozen")))
        seat.order(messages.Collect())
        handed_in = await seat.hear(messages.HandedIn)
        assert (tmp_path / handed_in.folder / "appl").is_dir()
        assert seat.desk.environment.tree.class_seat.state == "frozen"

    played(tmp_path, tell)


def test_a_learner_whose_seat_goes_to_another_browser_has_to_go(tmp_path):
    async def tell(seat):
        client = seat.hub.come(ANA)
        seat.order(messages.ShutOut())
        await asyncio.wait_for(client.ended.wait(), 30)

    played(tmp_path, tell)


def test_hand_ins_follow_each_other_slowly(tmp_path):  # R-X25
    async def tell(seat):
        assert not await seat.door._put_together()
        assert (await seat.door._put_together()).key == "class.hand_in_soon"

    played(tmp_path, tell)


def test_who_is_let_in_does_not_wait_for_what_is_collected(tmp_path):  # R-X25
    async def tell(seat):
        async with seat.door._handing:  # it takes long
            seat.order(messages.Collect())
            seat.order(messages.Collect())
            seat.order(messages.Admit("key", is_teacher=True))
            while not (cookie := seat.entrance.enter("key")):
                await asyncio.sleep(0)
            assert seat.entrance.visitor({seat.entrance.cookie_name: cookie}) is not None
        assert (await seat.hear(messages.HandedIn)).folder == "handed-in/0001"

    played(tmp_path, tell)
    assert [path.name for path in (tmp_path / "handed-in").iterdir()] == ["0001"]


def test_a_collection_comes_after_the_pause_that_a_hand_in_makes(tmp_path, monkeypatch):  # R-X25
    monkeypatch.setattr(seat_door, "_PAUSE_S", 0.2)

    async def tell(seat):
        assert not await seat.door._put_together()
        seat.order(messages.Collect())
        folders = [(await seat.hear(messages.HandedIn)).folder for _ in range(2)]
        assert folders == ["handed-in/0001", "handed-in/0002"]

    played(tmp_path, tell)


def test_a_class_that_says_what_no_class_says_ends_it(tmp_path):
    async def play():
        seat = Seat(tmp_path)
        keeping = asyncio.ensure_future(seat.door.keep())
        seat.ours.sendall(b"?\n")
        with pytest.raises(ValueError):
            await keeping
        seat.door.close()
        seat.ours.close()

    asyncio.run(asyncio.wait_for(play(), 60))
