import socket

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from onika.host.sessions.request_server import RequestServer, SessionRequest
from onika.link.caller import Caller, Role
from onika.link.carrier import SocketCarrier, memory_pair
from onika.link.channel import Channel
from onika.link.connection import Connection
from onika.link.link_events import ReadingReceived, SignalReceived
from onika.link.link_terms import CHILD
from onika.link.sessions import Introduction, Sessions
from onika.wire import event, live, request
from onika.words.reason import NOTHING, Reason

SECOND = 1_000_000_000


class Road:
    """Where guests come from, in place of the porter."""

    def __init__(self):
        self.coming = []
        self.post, self.other = socket.socketpair()
        self.end = NOTHING

    deaf = 0

    def deaf_ns(self):
        return self.deaf

    def arrivals(self):
        came, self.coming = self.coming, []
        return came

    def ending(self):
        return self.end


class House:
    """A gate that answers whenever somebody waits, and those who ask it."""

    def __init__(self, accepts_code=False):
        self.now = 0
        self.road = Road()
        self.sessions = Sessions("life")
        self.connections: list[Connection] = []
        self.server = RequestServer(self.sessions, lambda: self.now, self.road, accepts_code)
        self.calls: list[SessionRequest] = []
        self.answers = True

    def serve(self, _sources=(), _timeout=None):
        self.now += 1_000_000
        for call in self.server.requests():
            self.calls.append(call)
            if self.answers:
                self.server.reply(call.ticket, request.Done())

    def parent(self):
        here, there = memory_pair()
        self.server.adopt(there)
        return self._opened(Connection(here, lambda: self.now, CHILD, wait=self.serve))

    def guest(self, role=Role.OWNER, near=True, client="me", epoch=""):
        ours, theirs = socket.socketpair()
        caller = Caller(role.word, role, "127.0.0.1" if near else "192.0.2.7", near)
        self.road.coming.append((Introduction(Channel.ALL, client, epoch, caller), theirs))
        return self._opened(Connection(SocketCarrier(ours), lambda: self.now, CHILD, client, wait=self.serve))

    def _opened(self, connection):
        self.connections.append(connection)
        connection.open()
        return connection

    def close(self):
        for connection in self.connections:
            connection.close(timeout_s=0)
        for session in self.sessions.sessions:
            session.drop()
        self.road.post.close()
        self.road.other.close()


@pytest.fixture
def house():
    made = House()
    yield made
    made.close()


def ask(connection, message):
    return request.decode_response(connection.request(request.encode(message)))


def signals(connection):
    return [event.decode(message.body) for message in connection.poll() if isinstance(message, SignalReceived)]


def test_a_request_comes_out_with_its_session_and_its_response_goes_back(house):  # R-F01, R-F07
    parent = house.parent()
    assert ask(parent, request.Abort(Reason.plain("enough"))) == request.Done()
    assert house.calls == [SessionRequest(1, "owner#1", Role.OWNER, request.Abort(Reason.plain("enough")), "parent")]


def test_what_is_no_request_is_refused_at_once(house):  # R-F07
    parent = house.parent()
    for body in (b"", b"\xc1", b"\x81\xa4type\xa4Nope", request.encode(request.Done())):
        answer = request.decode_response(parent.request(body))
        assert isinstance(answer, request.Refused)
        assert str(answer.reason).startswith("expected a request")
    assert house.calls == []


def test_a_response_may_come_later_and_in_any_order(house):  # R-F07
    house.answers = False
    parent = house.parent()
    first, second = (parent.ask(request.encode(request.Abort(Reason.plain(word)))) for word in "ab")
    parent.poll()
    house.serve()
    for call, reason in zip(reversed(house.calls), "yx", strict=True):
        house.server.reply(call.ticket, request.Refused(Reason.plain(reason)))
    replied = {
        message.number: str(request.decode_response(message.body).reason)
        for message in parent.poll()
        if hasattr(message, "number")
    }
    assert replied == {first: "x", second: "y"}


def test_events_arrive_in_their_order(house):  # R-F01
    parent = house.parent()
    steps = [event.Done(0, number, number / 2) for number in range(5)]
    for step in steps:
        house.server.tell(step)
    house.serve()
    assert signals(parent) == steps


def test_an_event_goes_to_those_who_attend_and_to_the_one_it_is_for(house):  # R-F01
    parent, near, far = house.parent(), house.guest(client="a"), house.guest(client="b")
    house.server.attend("owner#2", ("left",))
    steps = [event.Done(0, number, 0.0) for number in range(5)]
    house.server.tell(steps[0], "left")
    house.server.tell(steps[1], "right", "owner#3")
    house.server.tell(steps[2])
    house.server.attend("owner#3", ("*",))
    house.server.tell(steps[3], "right")
    house.serve()
    assert signals(parent) == [steps[2]]
    assert signals(near) == [steps[0], steps[2]]
    assert signals(far) == [steps[1], steps[2], steps[3]]


def test_a_reading_is_shown_to_one_session_and_only_the_newest(house):
    near, far = house.guest(client="a"), house.guest(client="b")
    house.server.show("owner#1", "X", b"1")
    house.server.show("owner#1", "X", b"2")
    house.server.show("nobody", "X", b"3")
    assert house.server.due_s() == 0
    house.serve()
    assert [message for message in near.poll() if isinstance(message, ReadingReceived)] == [ReadingReceived("X", b"2")]
    assert [message for message in far.poll() if isinstance(message, ReadingReceived)] == []


def test_it_is_open_until_the_launching_program_goes(house):  # R-E10
    parent, _ = house.parent(), house.guest()
    parent.close(timeout_s=0)
    house.serve()
    assert not house.server.is_open
    assert house.server.lost() == ["owner#1"]
    assert house.server.lost() == []


def test_one_without_a_launching_program_is_always_open(house):
    assert house.server.is_open
    house.guest().close(timeout_s=0)
    house.serve()
    assert house.server.is_open


@pytest.mark.parametrize(
    ("role", "wish", "sentence"),
    [
        (Role.VIEWER, request.Abort(Reason.plain("x")), "expected an operator for Abort, found viewer, who is viewer"),
        (Role.OPERATOR, request.Quit(), "expected an owner"),
    ],
)
def test_what_a_role_may_not_is_refused_at_once(house, role, wish, sentence):  # R-X12, law 27
    guest = house.guest(role)
    assert str(ask(guest, wish).reason).startswith(sentence)
    assert ask(guest, request.Stop(Reason.plain("stop!"))) == request.Done()
    assert ask(guest, live.Survey()) == request.Done()
    assert [type(call.asked) for call in house.calls] == [request.Stop, live.Survey]


def test_code_from_another_machine_is_refused_unless_it_is_accepted(house):  # law 23
    shop = PlanBuilder()
    shop.task("bell", "from onika.module import Module\n\nclass Bell(Module):\n    trigger = True\n")
    prepare = request.Prepare(shop.plan([action("bell")]), ())
    far = house.guest(near=False)
    assert "code from another machine (192.0.2.7) is not accepted" in str(ask(far, prepare).reason)
    assert ask(far, request.Prepare(prepare.plan.__class__("x", (), ()), ())) == request.Done()
    near = house.guest(client="near")
    assert ask(near, prepare) == request.Done()
    open_house = House(accepts_code=True)
    far = open_house.guest(near=False)
    assert ask(far, prepare) == request.Done()
    operator = open_house.guest(Role.OPERATOR, client="o")
    assert "is brought by a programmer" in str(ask(operator, prepare).reason)
    open_house.close()


def test_a_flood_is_served_a_little_at_a_time_and_the_others_in_between(house):  # R-F01
    house.answers = False
    flood, honest = house.guest(client="a"), house.guest(client="b")
    for _ in range(500):
        flood.ask(request.encode(live.Survey()))
    honest.ask(request.encode(request.Stop(Reason.plain("now"))))
    house.serve()
    assert [call.session for call in house.calls].count("owner#1") <= 16
    assert "owner#2" in [call.session for call in house.calls]
    assert house.server.due_s() == 0
    for _ in range(200):
        flood.poll()
        house.serve()
    assert len(house.calls) == 501


def test_a_session_that_is_silent_for_too_long_is_lost_once_and_another_users_is_turned_away(house):
    house.guest()
    house.serve()
    house.now += 4 * SECOND
    house.server.requests()
    assert house.server.lost() == ["owner#1"]
    assert house.server.lost() == []
    with pytest.raises(Exception, match="another user's"):
        house.guest(Role.VIEWER)


def test_the_porters_end_is_told_and_those_who_are_there_stay(house):
    guest = house.guest()
    house.road.end = Reason.of("host.porter_killed", signal=9)
    house.serve()
    house.serve()
    (lost,) = signals(guest)
    assert lost.name == "porter"
    assert lost.cause == Reason.of("host.porter_killed", signal=9)
    assert ask(guest, request.Abort(NOTHING)) == request.Done()


class Witnessed:
    """Keeps what a gate says to its witness."""

    def __init__(self):
        self.seen = []

    def answered(self, call, response):
        self.seen.append((type(call.asked).__name__, call.session, call.address, type(response).__name__))

    def garbage(self, session, text):
        self.seen.append(("garbage", session))

    def came(self, new, why_not):
        self.seen.append(("came", new.caller.user, why_not))

    def lost(self, session):
        self.seen.append(("lost", session))

    def told(self, line):
        self.seen.append(("told", type(line).__name__))


def test_its_witness_sees_every_request_with_its_answer_refused_ones_too(house):  # R-X12
    audit_log = house.server.watcher = Witnessed()
    viewer = house.guest(Role.VIEWER)
    (session,) = [session.name for session in house.server.sessions()]
    viewer.request(request.encode(live.Survey()))
    viewer.request(request.encode(live.Take("s0")))
    viewer.request(b"garbage")
    house.server.tell(event.Held("s0", "me"))
    viewer.close()
    house.serve()
    house.server.lost()
    came, survey, take, garbage, told_line, lost = audit_log.seen
    assert (survey[0], take[0], take[3]) == ("Survey", "Take", "Refused")
    assert take[1:3] == (session, survey[2])
    assert (came[0], garbage, told_line, lost) == ("came", ("garbage", session), ("told", "Held"), ("lost", session))


def test_who_is_there_and_how_long_he_was_silent(house):  # R-X12
    house.parent()
    house.guest(Role.OPERATOR)
    parent, guest = house.server.sessions()
    assert (parent.role, guest.role, guest.is_here) == ("owner", "operator", True)
    before = house.server.hearing(guest.name)
    house.now += SECOND
    assert house.server.hearing(guest.name).silent_ns == before.silent_ns + SECOND
    assert before.beats == 0
    assert house.server.hearing(parent.name) is None
    assert house.server.hearing("nobody") is None


def test_whoever_overhears_is_told_everything_at_once(house):  # law 29
    messages = []

    def hear(message, subsystem):
        messages.append((message, subsystem))

    house.server.overhear(hear)
    house.server.tell(event.Stopped(True, Reason.plain("x")), "flow0")
    house.server.leave(hear)
    house.server.tell(event.Stopped(False, NOTHING))
    assert messages == [(event.Stopped(True, Reason.plain("x")), "flow0")]
