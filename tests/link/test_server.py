import pytest

from onika.link import lost
from onika.link.link_events import Greeted, LinkStateChanged, RequestReceived
from onika.link.link_terms import LinkTerms
from onika.link.lost import LossCause
from onika.link.reply_log import ReplyLog
from onika.link.server import ServerEnd
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkState
from onika.wire.packet import (
    VERSION,
    Ack,
    Beat,
    Bye,
    Hello,
    Part,
    ReadingPacket,
    ReplyPacket,
    RequestPacket,
    SignalPacket,
    Welcome,
)
from onika.words.reason import NOTHING, Reason

ROOM = 1_000_000
TERMS = LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=1000, greeting_ns=1000, piece=4, window=3)


def hello(client="me", epoch="e1", seq=0):
    return Hello(VERSION, client, epoch, seq)


def request(number, body=b"", done_below=1, deadline_ns=0):
    return RequestPacket(number, done_below, deadline_ns, 0, body)


def made(terms=TERMS, journal=None, replies=None):
    return ServerEnd(journal or SignalJournal("e1"), replies or ReplyLog(), terms)


def greet(end, packet=None):
    end.open(0)
    end.feed(packet or hello(), 0)
    end.take_packets(0, ROOM)
    end.take_notices()
    return end


def packets(end, now_ns=0):
    return end.take_packets(now_ns, ROOM)


def requests(end):
    return [news for news in end.take_notices() if not isinstance(news, LinkStateChanged)]


def test_nothing_is_said_on_a_new_connection_before_the_greeting():  # R-F01
    end = made(LinkTerms(beat_ns=1))
    end.signal(b"x", 0)
    end.open(0)
    end.signal(b"y", 0)
    end.reading("key", b"", 0)
    end.tick(5)
    assert packets(end) == []


def test_a_newcomer_is_welcomed_with_the_number_after_which_signals_come():  # R-F01
    end = made()
    end.signal(b"past", 0)
    end.open(0)
    end.feed(hello(epoch=""), 77)
    assert requests(end) == [Greeted("me", False)]
    end.signal(b"now", 77)
    assert packets(end) == [Welcome(VERSION, "e1", 1, False, 77), SignalPacket(2, b"now")]


def test_signals_are_said_again_from_the_last_that_was_accepted():  # R-F01
    end = greet(made())
    for body in (b"1", b"2"):
        end.signal(body, 0)
    end.cut(lost.closed())
    end.signal(b"3", 0)
    end.open(0)
    end.feed(hello(seq=1), 0)
    assert requests(end) == [Greeted("me", True)]
    assert packets(end) == [Welcome(VERSION, "e1", 1, True, 0), SignalPacket(2, b"2"), SignalPacket(3, b"3")]


def test_no_more_signals_are_under_way_than_the_window_allows():
    end = greet(made())
    for _ in range(5):
        end.signal(b"", 0)
    assert [packet.seq for packet in packets(end)] == [1, 2, 3]
    end.feed(Ack(2), 0)
    assert [packet.seq for packet in packets(end)] == [4, 5]


@pytest.mark.parametrize("packet", [hello(epoch="e0"), hello(seq=9), hello(client="stranger")])
def test_who_comes_from_another_life_or_future_begins_anew(packet):  # R-F01
    end = greet(made())
    end.cut(lost.closed())
    requests(end)
    end.open(0)
    end.feed(packet, 0)
    assert requests(end) == [Greeted(packet.client, False)]


def test_a_request_said_twice_is_handed_over_once_and_its_answer_repeated():  # R-F07
    end = greet(made())
    end.feed(request(1, b"a"), 0)
    end.feed(request(1, b"a"), 0)
    assert requests(end) == [RequestReceived(1, "me", b"a")]
    end.reply(1, b"A")
    assert packets(end) == [ReplyPacket(1, False, 0, b"A")]
    end.cut(lost.closed())
    greet(end)
    end.feed(request(1, b"a"), 0)
    assert requests(end) == []
    assert packets(end) == [ReplyPacket(1, False, 0, b"A")]


def test_an_answer_given_while_nobody_is_there_is_kept_for_the_repetition():  # R-F07
    end = greet(made())
    end.feed(request(1), 0)
    end.cut(lost.closed())
    end.reply(1, b"A")
    greet(end)
    assert packets(end) == []
    end.feed(request(1), 0)
    assert packets(end) == [ReplyPacket(1, False, 0, b"A")]


def test_settled_answers_are_forgotten_and_their_requests_ignored():
    end = greet(made())
    end.feed(request(1), 0)
    end.reply(1, b"A")
    packets(end)
    end.feed(request(2, done_below=2), 0)
    end.feed(request(1), 0)
    assert [request.ticket for request in requests(end)] == [1, 2]
    assert packets(end) == []


def test_a_late_request_is_refused_and_stays_refused():  # R-X12
    end = greet(made())
    end.feed(request(1, deadline_ns=50), 51)
    end.feed(request(1, deadline_ns=50), 51)
    end.feed(request(2, deadline_ns=51), 51)
    assert [request.ticket for request in requests(end)] == [1]
    assert packets(end) == [ReplyPacket(1, True, 0, b"")]


def test_an_answer_never_reaches_another_environment():
    end = greet(made())
    end.feed(request(1), 0)
    end.cut(lost.closed())
    greet(end, hello("other"))
    end.feed(request(1), 0)
    end.reply(1, b"his")
    assert packets(end) == []
    end.reply(2, b"mine")
    assert packets(end) == [ReplyPacket(1, False, 0, b"mine")]


def test_a_ticket_is_good_for_one_answer():
    end = greet(made())
    end.feed(request(1), 0)
    end.reply(1, b"")
    with pytest.raises(KeyError):
        end.reply(1, b"")


def test_two_ends_that_share_a_journal_say_the_same_signals():
    journal, replies = SignalJournal("e1"), ReplyLog()
    ends = [greet(made(journal=journal, replies=replies), hello(client)) for client in ("one", "two")]
    ends[0].signal(b"x", 0)
    ends[1].tick(1)
    assert [packets(end) for end in ends] == [[SignalPacket(1, b"x")], [SignalPacket(1, b"x")]]


def test_who_falls_behind_the_journal_is_cut_and_begins_anew():
    end = greet(made(journal=SignalJournal("e1", keep=4)))
    for _ in range(5):
        end.signal(b"", 0)
    assert end.state is LinkState.LINKED
    for _ in range(5):
        end.signal(b"", 0)
    turned = end.take_notices()[-1]
    assert (turned.state, turned.lost.cause) == (LinkState.APART, LossCause.BEHIND)
    assert packets(end) == [Bye("behind", Reason.of("link.signal_forgotten", number=4))]
    end.open(0)
    end.feed(hello(seq=3), 0)
    assert requests(end) == [Greeted("me", False)]


def test_a_lost_welcome_is_said_again_unchanged():
    end = greet(made())
    end.signal(b"x", 0)
    packets(end)
    end.feed(hello(), 5)
    assert packets(end) == [Welcome(VERSION, "e1", 0, False, 0)]


def test_on_a_carrier_that_loses_packets_signals_are_said_again():
    end = greet(made(LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=0, retry_ns=10)))
    end.signal(b"x", 0)
    assert packets(end) == [SignalPacket(1, b"x")]
    end.tick(9)
    assert packets(end) == []
    end.tick(10)
    assert packets(end) == [SignalPacket(1, b"x")]
    end.feed(Ack(1), 11)
    end.tick(30)
    assert packets(end) == []


@pytest.mark.parametrize(
    "packet",
    [
        Welcome(VERSION, "e", 0, False, 0),
        ReplyPacket(1, False, 0, b""),
        SignalPacket(1, b""),
        ReadingPacket(1, "k", b""),
        Ack(5),
        hello("x"),
    ],
)
def test_what_has_no_place_here_ends_the_connection(packet):
    end = greet(made())
    end.feed(packet, 0)
    (turned,) = end.take_notices()
    assert (turned.state, turned.lost.cause) == (LinkState.APART, LossCause.GARBAGE)
    assert [bye.cause for bye in packets(end)] == ["garbage"]


def test_who_does_not_greet_first_is_cut():
    end = made()
    end.open(0)
    end.feed(request(1), 0)
    assert end.state is LinkState.APART


def test_parts_without_end_end_the_connection():
    end = greet(made(LinkTerms(body_limit=1000)))
    for index in range(20):
        end.feed(Part(1, index, bytes(100)), 0)
    assert end.state is LinkState.APART


def test_another_version_is_told_so_and_nothing_else():
    end = made()
    end.signal(b"x", 0)
    end.open(0)
    end.feed(Hello(VERSION + 1, "me", "", 0), 0)
    (bye,) = packets(end)
    assert (bye.cause, f"not {VERSION + 1}" in bye.reason) == ("version", True)
    assert end.state is LinkState.APART


def test_a_connection_without_greeting_is_given_up():
    end = made()
    end.open(0)
    end.tick(1000)
    assert end.state is LinkState.APART


def test_beats_are_answered_by_nothing_but_count_as_life():
    end = greet(made())
    end.feed(Beat(1, 0), 900)
    end.tick(1800)
    assert (packets(end), end.state) == ([], LinkState.LINKED)


def test_long_bodies_come_and_go_in_parts():  # R-F01
    end = greet(made())
    end.feed(Part(1, 0, b"abcd"), 0)
    end.feed(RequestPacket(1, 1, 0, 1, b"ef"), 0)
    assert requests(end) == [RequestReceived(1, "me", b"abcdef")]
    end.reply(1, b"123456")
    assert packets(end) == [Part(1, 0, b"1234"), ReplyPacket(1, False, 1, b"56")]


def test_a_closed_link_still_says_what_was_answered_and_signalled():
    end = greet(made())
    end.feed(request(1), 0)
    end.reply(1, b"A")
    end.signal(b"x", 0)
    end.close(Reason.of("link.runtime_ends"))
    assert packets(end) == [
        SignalPacket(1, b"x"),
        ReplyPacket(1, False, 0, b"A"),
        Bye("closed", Reason.of("link.runtime_ends")),
    ]
    assert end.state is LinkState.ENDED


def test_a_client_that_said_good_bye_is_forgotten():
    end = greet(made())
    end.feed(Bye("closed", NOTHING), 0)
    assert end.state is LinkState.APART
    end.open(0)
    end.feed(hello(), 0)
    assert requests(end) == [Greeted("me", False)]


def test_readings_are_for_those_who_are_there_now():
    end = made()
    end.reading("key", b"early", 0)
    greet(end)
    assert packets(end) == []
    end.reading("key", b"now", 0)
    assert packets(end) == [ReadingPacket(1, "key", b"now")]


@pytest.mark.parametrize(
    ("say", "what"),
    [
        (lambda end: end.signal(bytes(11), 0), "signal"),
        (lambda end: end.reading("key", bytes(11), 0), "reading"),
        (lambda end: end.reply(1, bytes(21)), "reply"),
    ],
)
def test_what_is_too_long_is_the_programmers_fault(say, what):
    with pytest.raises(ValueError, match=f"expected a {what} of .0 bytes at most"):
        say(greet(made(LinkTerms(single=10, body_limit=20))))
