import pytest

from onika.link.caller import Caller, Role
from onika.link.carrier import memory_pair
from onika.link.channel import Channel
from onika.link.client import ClientEnd
from onika.link.link_terms import LOCAL
from onika.link.pump import Pump
from onika.link.sessions import Introduction, Sessions
from onika.words.reason import NOTHING, Reason

MINUTE = 60_000_000_000


class Inn:
    def __init__(self, **settings):
        self.now = 0
        self.sessions = Sessions("life", **settings)
        self.pumps = []

    def come(self, client, user="ann", channel=Channel.ALL, end=None, epoch=None):
        """A connection of this client; why it is turned away, and its end."""
        end = end or ClientEnd(client, LOCAL, channel)
        here, there = memory_pair()
        caller = Caller(user, Role.OWNER, "192.0.2.1", False)
        new = Introduction(channel, client, end.epoch if epoch is None else epoch, caller)
        why = self.sessions.admit(new, there, self.now)
        pump = Pump(end)
        pump.attach(here, self.now)
        self.pumps.append(pump)
        self.talk()
        return why, end

    def talk(self):
        for _ in range(3):
            for pump in self.pumps:
                pump.service(self.now)
            for session in self.sessions.sessions:
                session.service(self.now)

    def names(self):
        return [session.name for session in self.sessions.sessions]


def test_each_client_has_a_session_of_its_own():  # R-F01
    inn = Inn()
    ends = [inn.come(client)[1] for client in ("a", "b")]
    assert inn.names() == ["ann#1", "ann#2"]
    assert ends[0].epoch != ends[1].epoch


def test_a_client_that_comes_back_finds_its_session():  # R-F01
    inn = Inn()
    _, end = inn.come("a")
    inn.sessions.find("ann#1").signal(b"one", inn.now)
    inn.pumps.clear()
    assert inn.come("a", end=end) == (NOTHING, end)
    assert inn.names() == ["ann#1"]


def test_another_users_session_is_not_his():  # R-X12
    inn = Inn()
    inn.come("a")
    why, _ = inn.come("a", user="mallory")
    assert why == Reason.of("link.another_users")


@pytest.mark.parametrize("channel", [Channel.SIGNAL, Channel.STREAM])
def test_only_a_channel_that_asks_begins_a_session(channel):
    why, _ = Inn().come("a", channel=channel)
    assert why == Reason.of("link.no_session")


def test_a_second_shape_of_connections_is_turned_away():
    inn = Inn()
    inn.come("a")
    why, _ = inn.come("a", channel=Channel.SIGNAL)
    assert why == Reason.of("link.channels_mixed")


def test_a_new_program_under_an_old_name_gets_a_new_session_and_the_old_is_lost():  # R-X12
    inn = Inn()
    _, end = inn.come("a")
    end.request(b"move", inn.now)
    inn.talk()
    inn.come("a")
    assert inn.sessions.lost(inn.now) == ["ann#1"]
    assert inn.names() == ["ann#2"]


def test_one_who_missed_the_welcome_has_still_the_same_session():
    inn = Inn()
    inn.come("a")
    inn.come("a")
    assert inn.sessions.lost(inn.now) == []
    assert inn.names() == ["ann#1"]


def test_who_is_away_for_long_is_forgotten_and_lost_once():
    inn = Inn()
    inn.come("a")
    for pump in inn.pumps:
        pump.drop()
    inn.talk()
    inn.now += MINUTE
    assert inn.sessions.lost(inn.now) == ["ann#1"]
    assert inn.names() == ["ann#1"]
    inn.now += 10 * MINUTE
    assert inn.sessions.lost(inn.now) == []
    assert inn.names() == []


def test_where_there_is_no_room_one_who_is_away_makes_it_and_one_who_is_there_does_not():  # R-F01
    inn = Inn(keep=2)
    inn.come("a")
    inn.come("b")
    assert inn.come("c")[0] == Reason.of("link.sessions_full", count=2)
    inn.pumps[0].drop()
    inn.talk()
    assert inn.come("c")[0] == NOTHING
    assert inn.names() == ["ann#2", "ann#3"]
    assert inn.sessions.lost(inn.now) == ["ann#1"]


def test_the_launching_program_is_a_session_too():  # R-A15
    inn = Inn()
    _, there = memory_pair()
    assert inn.sessions.adopt(there, 0).name == "owner#1"
    assert inn.sessions.find("owner#1") is inn.sessions.sessions[0]
