from onika.link.caller import PARENT
from onika.link.carrier import memory_pair
from onika.link.channel import THREE, Channel
from onika.link.client import ClientEnd
from onika.link.link_events import ReadingReceived, ReplyReceived, RequestReceived, SignalReceived
from onika.link.link_quality import LinkQuality
from onika.link.link_terms import LOCAL
from onika.link.pump import Pump
from onika.link.session import EnvironmentSession
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkState
from onika.wire.packet import Beat, encode

SECOND = 1_000_000_000


class Both:
    """A session and the ends of its environment, one for each channel."""

    def __init__(self, channels=(Channel.ALL,), can_return=True):
        self.now = 0
        self.session = EnvironmentSession("me#1", "me", PARENT, SignalJournal("e1"), LOCAL, can_return)
        self.ends = {channel: ClientEnd("me", LOCAL, channel) for channel in channels}
        self.pumps = {channel: Pump(end) for channel, end in self.ends.items()}
        for channel in channels:
            self.connect(channel)

    def connect(self, channel):
        here, there = memory_pair()
        self.session.attach(channel, there, self.now)
        if not channel.asks:
            self.ends[channel].follow("e1")
        self.pumps[channel].attach(here, self.now)
        self.talk()

    def talk(self):
        requests = []
        for _ in range(3):
            for pump in self.pumps.values():
                pump.service(self.now)
            requests += [event for event in self.session.service(self.now) if isinstance(event, RequestReceived)]
        return requests

    def events_of(self, channel, kind):
        return [event for event in self.ends[channel].take_notices() if isinstance(event, kind)]


def test_signals_answers_and_readings_go_their_own_ways():  # R-F01
    both = Both(THREE)
    assert set(both.session.states().values()) == {LinkState.LINKED}
    both.ends[Channel.SESSION].request(b"do", both.now)
    (request,) = both.talk()
    both.session.signal(b"event", both.now)
    both.session.show("X", b"1", both.now)
    both.session.reply(request.ticket, b"done", both.now)
    both.talk()
    assert both.events_of(Channel.SESSION, ReplyReceived) == [ReplyReceived(1, b"done")]
    assert both.events_of(Channel.SIGNAL, SignalReceived) == [SignalReceived(1, b"event")]
    assert both.events_of(Channel.STREAM, ReadingReceived) == [ReadingReceived("X", b"1")]


def test_what_was_said_before_the_signal_channel_is_there_is_heard_on_it():  # R-F01
    both = Both((Channel.SESSION,))
    both.session.signal(b"early", both.now)
    both.ends[Channel.SIGNAL] = ClientEnd("me", LOCAL, Channel.SIGNAL)
    both.pumps[Channel.SIGNAL] = Pump(both.ends[Channel.SIGNAL])
    both.connect(Channel.SIGNAL)
    assert both.events_of(Channel.SIGNAL, SignalReceived) == [SignalReceived(1, b"early")]


def test_a_session_is_lost_once_after_silence_and_again_after_it_came_back():  # R-F01, R-X12
    both = Both()
    both.pumps[Channel.ALL].drop()
    both.session.service(both.now)
    assert not both.session.is_lost(both.now)
    assert both.session.due_ns(both.now) == LOCAL.lost_ns
    both.now += LOCAL.lost_ns
    assert both.session.is_lost(both.now)
    assert not both.session.is_lost(both.now)
    both.connect(Channel.ALL)
    assert not both.session.is_lost(both.now)
    both.now += LOCAL.lost_ns
    both.session.service(both.now)
    assert both.session.is_lost(both.now)


def test_a_session_that_comes_back_in_time_is_not_lost():  # R-F01
    both = Both()
    both.pumps[Channel.ALL].drop()
    both.session.service(both.now)
    both.now += LOCAL.lost_ns - 1
    both.connect(Channel.ALL)
    assert not both.session.is_lost(both.now + 1)


def test_a_good_bye_ends_a_session_at_once_and_so_does_a_cut_where_it_cannot_come_back():  # R-E10
    both = Both()
    both.ends[Channel.ALL].close()
    both.talk()
    assert both.session.is_lost(both.now)
    assert both.session.has_left
    child = Both(can_return=False)
    child.pumps[Channel.ALL].drop()
    child.session.service(child.now)
    assert child.session.is_lost(child.now)


def test_connections_of_two_shapes_do_not_go_together():
    assert not Both(THREE).session.fits(Channel.ALL)
    assert not Both().session.fits(Channel.SIGNAL)
    assert Both(THREE).session.fits(Channel.STREAM)


def test_a_reading_is_a_reason_to_be_served_and_nobody_keeps_it_for_one_who_is_away():
    both = Both()
    both.session.show("X", b"1", both.now)
    assert both.session.due_ns(both.now) == 0
    both.talk()
    both.pumps[Channel.ALL].drop()
    both.session.service(both.now)
    both.session.show("X", b"2", both.now)
    assert both.session.due_ns(both.now) != 0


def test_one_who_says_nothing_is_not_heard_and_is_when_he_says_something_again():  # R-X12
    both = Both()
    assert both.session.is_linked
    both.now += LOCAL.suspect_ns
    both.session.service(both.now)
    assert not both.session.is_linked
    both.talk()
    assert both.session.is_linked
    both.session.drop()
    assert not both.session.is_linked


def test_beats_that_came_beside_the_connection_are_counted_until_it_is_another():  # R-X12
    both = Both()
    assert both.session.link_quality.beats == 0
    both.pumps[Channel.ALL].carrier.send(encode(Beat(1, 0, 700)))
    both.now += 5
    both.session.service(both.now)
    assert both.session.link_quality == LinkQuality(1, 5, 700)
    both.connect(Channel.ALL)
    assert both.session.link_quality == LinkQuality()
