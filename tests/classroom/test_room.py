import asyncio

import pytest

from onika.classroom import messages
from onika.classroom.footprint import Footprint
from onika.classroom.room import IDLE_S, LOOK_S, ClassRoom
from onika.classroom.roster import Grade, GradedExpectation
from onika.words.reason import NOTHING, Reason


class Seat:
    """A seat without a process."""

    def __init__(self, begins, hears):
        self.name, self.hears, self.sent = begins, hears, []
        self.state, self.port, self.pid, self.ended = "off", 9000, None, NOTHING
        self.began_anew = NOTHING
        self.silent_s, self.footprint, self.standing = 0.0, Footprint(), messages.SeatStanding()

    async def ready(self):
        self.state, self.pid = "there", 1
        return True

    def send(self, order):
        self.sent.append(order)

    async def end(self, reason):
        self.state, self.ended = "off", reason

    async def leave(self, _patience_s, reason=NOTHING):
        self.state, self.ended = "left", reason


class Grader:
    def __init__(self):
        self.graded = []

    async def grade(self, number, folder):
        self.graded.append((number, sorted(path.name for path in folder.rglob("*.appl"))))
        return Grade(number, (GradedExpectation("LAMP == 1", holds=True),))


@pytest.fixture
def room(tmp_path):
    room = ClassRoom(tmp_path, 2, lambda learner: learner.name, Grader(), 100, Seat)
    room.tokens = [room.join(name)[0] for name in ("Ana", "Ben")]
    return room


def shown(room, number):
    return [order.seat for order in room.seat(number).sent if isinstance(order, messages.ShowSeat)][-1]


def test_a_token_leads_to_the_seat_of_its_learner_and_to_no_other(room):  # R-X25
    assert [room.learner(token).seat for token in room.tokens] == [1, 2]
    assert room.learner("") is None
    assert room.learner("guess") is None
    assert room.join("Eve") == ("", room.join("Eve")[1])
    assert room.join("Eve")[1].key == "class.full"


def test_whoever_comes_to_a_seat_gets_a_key_that_the_seat_knows(room):  # R-X25
    port, key = asyncio.run(room.admitted(1))
    assert port == 9000
    assert room.seat(1).sent[-1] == messages.Admit(key)
    assert shown(room, 1).learner == "Ana"
    assert asyncio.run(room.admitted(7)) is None


def test_what_the_teacher_does_with_seats_reaches_those_and_is_kept(room, tmp_path):  # R-X25
    for number in (1, 2):
        room.seat(number)
    room.set_state((1,), "frozen")
    room.tell((1, 2, 9), "  look \n up ")
    assert (shown(room, 1).state, shown(room, 2).state) == ("frozen", "works")
    assert (shown(room, 2).note, shown(room, 2).note_number) == ("look up", 1)
    again = ClassRoom(tmp_path, 2, lambda learner: learner.name, Grader(), 100, Seat)
    assert [(learner.name, learner.state) for learner in again.roster.learners] == [("Ana", "frozen"), ("Ben", "works")]
    assert again.learner(room.tokens[0]).seat == 1


def test_a_seat_that_goes_to_another_browser_shuts_the_first_one_out(room):
    room.seat(1)
    room.let_return(1)
    token, _ = room.join("ana")
    assert messages.ShutOut() in room.seat(1).sent
    assert room.learner(room.tokens[0]) is None
    assert room.learner(token).seat == 1


@pytest.mark.parametrize(
    ("state", "silent_s", "size", "why"),
    [("there", 0.0, 101, "class.seat_too_large"), ("silent", 61.0, 1, "class.seat_hung"), ("there", 0.0, 99, "")],
)
def test_a_seat_that_takes_too_much_or_hangs_is_ended_and_no_other(room, state, silent_s, size, why):  # R-X25
    async def look():
        for number in (1, 2):
            await room.seat(number).ready()
        room.seat(1).state, room.seat(1).silent_s = state, silent_s
        await room._look(1, Footprint(size))
        await room._look(2, Footprint(1))

    asyncio.run(look())
    assert room.seat(1).ended.key == why
    assert room.seat(2).state == "there"


def test_a_seat_that_nobody_looks_at_leaves_after_a_while(room):
    async def look(pages):
        await room.seat(1).ready()
        room.seat(1).standing = messages.SeatStanding(pages=pages)
        for _ in range(int(IDLE_S / LOOK_S) + 1):
            await room._look(1, Footprint(1))

    asyncio.run(look(1))
    assert room.seat(1).state == "there"
    asyncio.run(look(0))
    assert room.seat(1).state == "left"
    assert room.seat(1).ended == Reason.of("class.seat_left", minutes=20)


def test_who_comes_back_to_a_seat_that_had_ended_is_told_why_it_begins_anew(room):  # R-X25
    room.seat(1).began_anew = Reason.of("class.seat_left", minutes=20)
    asyncio.run(room.admitted(1))
    asyncio.run(room.admitted(2))
    assert shown(room, 1).began_anew == Reason.of("class.seat_left", minutes=20)
    assert not shown(room, 2).began_anew


def test_a_hand_in_is_taken_over_and_graded(room, tmp_path):  # R-X25
    appl = tmp_path / "seats" / "01" / "handed-in" / "0001" / "appl"
    appl.mkdir(parents=True)
    (appl / "mine.appl").write_text("x")

    async def hand_in():
        await room.seat(1).hears(messages.HandedIn("handed-in/0001"))
        await asyncio.gather(*room._work)

    asyncio.run(hand_in())
    assert room._grader.graded == [(1, ["mine.appl"])]
    assert (shown(room, 1).handed_in, shown(room, 1).grade) == (1, (1, 1))
    assert (tmp_path / "handed-in" / "01 Ana" / "0001" / "appl" / "mine.appl").read_text() == "x"


@pytest.mark.parametrize("folder", ["handed-in/..", "../02/handed-in/0001", "/etc", "handed-in/0002", "0001"])
def test_a_seat_hands_in_nothing_but_its_own(room, tmp_path, folder):  # R-X25
    secret = tmp_path / "secret"
    secret.mkdir()
    (secret / "key").write_text("x")
    handed_in = tmp_path / "seats" / "01" / "handed-in"
    handed_in.mkdir(parents=True)
    (handed_in / "0002").symlink_to(secret)

    async def hand_in():
        await room.seat(1).hears(messages.HandedIn(folder))
        await asyncio.gather(*room._work)

    asyncio.run(hand_in())
    assert room._grader.graded == []
    assert room.roster.at(1).handed_in == 0


def test_all_that_the_teacher_collects_is_asked_of_each_seat_and_nobody_waits_for_one_that_begins(room):  # R-X25
    async def collect():
        begun = asyncio.Event()

        async def slowly():
            await begun.wait()
            return True

        room.seat(1).ready = slowly
        room.collect((1, 2, 3))
        assert (await room.admitted(2))[0] == 9000
        assert messages.Collect() not in room.seat(1).sent
        begun.set()
        await asyncio.gather(*room._work)

    asyncio.run(collect())
    assert [messages.Collect() in room.seat(number).sent for number in (1, 2)] == [True, True]


def test_a_seat_that_cannot_begin_is_told_and_the_others_are_collected(room):
    async def collect():
        async def never():
            raise OSError("no port")

        room.seat(1).ready = never
        room.collect((1, 2))
        await asyncio.gather(*room._work)

    asyncio.run(collect())
    assert str(room.trouble) == "no port"
    assert messages.Collect() in room.seat(2).sent
