from onika.link.caller import Caller, Role
from onika.link.carrier import memory_pair
from onika.link.channel import THREE, Channel
from onika.link.link_events import (
    EpochChanged,
    LinkStateChanged,
    ReplyReceived,
    RequestReceived,
    Resumed,
    SignalReceived,
)
from onika.link.link_terms import LOCAL
from onika.link.lost import LossCause
from onika.link.session_channels import SessionChannels
from onika.link.sessions import Introduction, Sessions
from onika.link.state import LinkState
from onika.words.reason import Reason

MS = 1_000_000


class Net:
    """The channels of a session, and a runtime's sessions; connections come about at once."""

    def __init__(self, channels=THREE):
        self.now = 0
        self.session_channels = SessionChannels("me", LOCAL, channels, jitter=lambda: 1.0)
        self.restart("first")

    def restart(self, life):
        self.sessions = Sessions(life)
        self.lines = {}

    def dial(self):
        for channel in self.session_channels.wants(self.now):
            here, there = memory_pair()
            new = Introduction(channel, "me", self.session_channels.epoch, Caller("ann", Role.OWNER, "", False))
            if self.sessions.admit(new, there, self.now):
                there.close()
            self.lines[channel] = there
            self.session_channels.attach(channel, here, self.now)

    def talk(self, rounds=4):
        requests = []
        for _ in range(rounds):
            self.dial()
            self.session_channels.service(self.now)
            for session in self.sessions.sessions:
                requests += [
                    (session, event) for event in session.service(self.now) if isinstance(event, RequestReceived)
                ]
        self.session_channels.service(self.now)
        return requests

    def events_of(self, *kinds):
        return [event for event in self.session_channels.take_notices() if isinstance(event, kinds)]


def test_the_asking_channel_comes_first_and_the_others_follow():  # R-F01
    net = Net()
    assert net.session_channels.wants(0) == [Channel.SESSION]
    net.session_channels.failed(Channel.SESSION, 0)
    assert net.session_channels.wants(0) == []
    assert net.session_channels.due_ns(0) == 250 * MS
    net.now = 250 * MS
    net.talk(1)
    assert net.session_channels.state is not LinkState.LINKED
    net.talk()
    assert net.session_channels.state is LinkState.LINKED
    assert net.events_of(EpochChanged, Resumed) == [EpochChanged("first-1")]


def test_trying_again_takes_longer_each_time_up_to_two_seconds():
    net = Net()
    waits = []
    for _ in range(6):
        assert net.session_channels.wants(net.now) == [Channel.SESSION]
        net.session_channels.failed(Channel.SESSION, net.now)
        waits.append(net.session_channels.due_ns(net.now) // MS)
        net.now += net.session_channels.due_ns(net.now)
    assert waits == [250, 500, 1000, 2000, 2000, 2000]


def test_answers_and_signals_come_out_of_one_session():  # R-F01
    net = Net()
    net.talk()
    number = net.session_channels.request(b"do", net.now)
    ((session, request),) = net.talk()
    session.signal(b"event", net.now)
    session.reply(request.ticket, b"done", net.now)
    net.talk()
    assert net.events_of(ReplyReceived, SignalReceived) == [ReplyReceived(number, b"done"), SignalReceived(1, b"event")]


def test_a_cut_of_one_channel_is_mended_without_a_word():  # R-F01
    net = Net()
    net.talk()
    net.events_of()
    net.lines[Channel.SIGNAL].close()
    net.sessions.sessions[0].signal(b"meanwhile", net.now)
    net.talk()
    assert net.session_channels.state is LinkState.GREETING
    net.now += 300 * MS
    net.talk()
    assert net.session_channels.state is LinkState.LINKED
    assert net.events_of(SignalReceived, LinkStateChanged, EpochChanged) == [SignalReceived(1, b"meanwhile")]


def test_in_a_new_life_of_the_runtime_all_channels_begin_anew():  # R-F01
    net = Net()
    net.talk()
    net.sessions.sessions[0].signal(b"old", net.now)
    net.talk()
    for line in net.lines.values():
        line.close()
    net.restart("second")
    net.talk()
    net.now += 300 * MS
    net.talk()
    net.sessions.sessions[0].signal(b"new", net.now)
    net.talk()
    assert [event.epoch for event in net.events_of(EpochChanged)] == ["first-1", "second-1"]
    assert net.session_channels.state is LinkState.LINKED


def test_signals_of_an_old_life_are_not_told_in_a_new_one():  # R-F01
    net = Net()
    net.talk()
    net.events_of()
    net.sessions.sessions[0].signal(b"old", net.now)  # on its way when the runtime ends
    net.lines[Channel.SESSION].close()
    net.restart("second")
    net.session_channels.service(net.now)
    net.now += 300 * MS
    net.talk()
    events = net.events_of(EpochChanged, SignalReceived)
    assert events[-1] == EpochChanged("second-1")
    assert SignalReceived(1, b"old") not in events[events.index(EpochChanged("second-1")) :]


def test_the_end_is_said_on_all_channels():
    net = Net()
    net.talk()
    net.session_channels.close(Reason.plain("enough"), net.now)
    net.talk()
    assert net.session_channels.state is LinkState.ENDED
    assert net.session_channels.carriers == []
    assert net.events_of(LinkStateChanged)[-1].lost.cause is LossCause.HERE
    assert net.sessions.lost(net.now) == ["ann#1"]


def test_one_connection_may_do_for_everything():
    net = Net((Channel.ALL,))
    net.talk()
    assert net.session_channels.states() == {Channel.ALL: LinkState.LINKED}
