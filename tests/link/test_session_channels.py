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

MS = 1_000_000


class Net:
    """A bundle and a runtime's guests; connections come about at once."""

    def __init__(self, channels=THREE):
        self.now = 0
        self.bundle = SessionChannels("me", LOCAL, channels, jitter=lambda: 1.0)
        self.restart("first")

    def restart(self, life):
        self.guests = Sessions(life)
        self.lines = {}

    def dial(self):
        for channel in self.bundle.wants(self.now):
            here, there = memory_pair()
            new = Introduction(channel, "me", self.bundle.epoch, Caller("ann", Role.OWNER, "", False))
            if self.guests.admit(new, there, self.now):
                there.close()
            self.lines[channel] = there
            self.bundle.attach(channel, here, self.now)

    def talk(self, rounds=4):
        requests = []
        for _ in range(rounds):
            self.dial()
            self.bundle.service(self.now)
            for session in self.guests.sessions:
                requests += [
                    (session, event) for event in session.service(self.now) if isinstance(event, RequestReceived)
                ]
        self.bundle.service(self.now)
        return requests

    def events_of(self, *kinds):
        return [event for event in self.bundle.take_happenings() if isinstance(event, kinds)]


def test_the_asking_channel_comes_first_and_the_others_follow():  # R-F01
    net = Net()
    assert net.bundle.wants(0) == [Channel.SESSION]
    net.bundle.failed(Channel.SESSION, 0)
    assert net.bundle.wants(0) == []
    assert net.bundle.due_ns(0) == 250 * MS
    net.now = 250 * MS
    net.talk(1)
    assert net.bundle.state is not LinkState.LINKED
    net.talk()
    assert net.bundle.state is LinkState.LINKED
    assert net.events_of(EpochChanged, Resumed) == [EpochChanged("first-1")]


def test_trying_again_takes_longer_each_time_up_to_two_seconds():
    net = Net()
    waits = []
    for _ in range(6):
        assert net.bundle.wants(net.now) == [Channel.SESSION]
        net.bundle.failed(Channel.SESSION, net.now)
        waits.append(net.bundle.due_ns(net.now) // MS)
        net.now += net.bundle.due_ns(net.now)
    assert waits == [250, 500, 1000, 2000, 2000, 2000]


def test_answers_and_signals_come_out_of_one_bundle():  # R-F01
    net = Net()
    net.talk()
    number = net.bundle.request(b"do", net.now)
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
    net.guests.sessions[0].signal(b"meanwhile", net.now)
    net.talk()
    assert net.bundle.state is LinkState.GREETING
    net.now += 300 * MS
    net.talk()
    assert net.bundle.state is LinkState.LINKED
    assert net.events_of(SignalReceived, LinkStateChanged, EpochChanged) == [SignalReceived(1, b"meanwhile")]


def test_in_a_new_life_of_the_runtime_all_channels_begin_anew():  # R-F01
    net = Net()
    net.talk()
    net.guests.sessions[0].signal(b"old", net.now)
    net.talk()
    for line in net.lines.values():
        line.close()
    net.restart("second")
    net.talk()
    net.now += 300 * MS
    net.talk()
    net.guests.sessions[0].signal(b"new", net.now)
    net.talk()
    assert [event.epoch for event in net.events_of(EpochChanged)] == ["first-1", "second-1"]
    assert net.bundle.state is LinkState.LINKED


def test_signals_of_an_old_life_are_not_told_in_a_new_one():  # R-F01
    net = Net()
    net.talk()
    net.events_of()
    net.guests.sessions[0].signal(b"old", net.now)  # on its way when the runtime ends
    net.lines[Channel.SESSION].close()
    net.restart("second")
    net.bundle.service(net.now)
    net.now += 300 * MS
    net.talk()
    events = net.events_of(EpochChanged, SignalReceived)
    assert events[-1] == EpochChanged("second-1")
    assert SignalReceived(1, b"old") not in events[events.index(EpochChanged("second-1")) :]


def test_the_end_is_said_on_all_channels():
    net = Net()
    net.talk()
    net.bundle.close("enough", net.now)
    net.talk()
    assert net.bundle.state is LinkState.ENDED
    assert net.bundle.carriers == []
    assert net.events_of(LinkStateChanged)[-1].lost.cause is LossCause.HERE
    assert net.guests.lost(net.now) == ["ann#1"]


def test_one_connection_may_do_for_everything():
    net = Net((Channel.ALL,))
    net.talk()
    assert net.bundle.states() == {Channel.ALL: LinkState.LINKED}
