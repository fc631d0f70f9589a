import pytest

from onika.link import lost
from onika.link.client import ClientEnd
from onika.link.link_events import (
    EpochChanged,
    LinkStateChanged,
    ReadingReceived,
    ReplyReceived,
    RequestFailed,
    RequestFate,
    Resumed,
    SignalReceived,
)
from onika.link.link_terms import LinkTerms
from onika.link.lost import LossCause
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
from onika.words.reason import Reason

ROOM = 1_000_000
TERMS = LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=1000, greeting_ns=1000, piece=4)


def welcome(epoch="e1", seq=0, resumed=False, clock_ns=0):
    return Welcome(VERSION, epoch, seq, resumed, clock_ns)


def greet(end, packet=None):
    end.open(0)
    end.feed(packet or welcome(), 0)
    end.take_packets(0, ROOM)
    end.take_notices()
    return end


def linked(terms=TERMS):
    return greet(ClientEnd("me", terms))


def packets(end, now_ns=0):
    return end.take_packets(now_ns, ROOM)


def events(end):
    return [news for news in end.take_notices() if not isinstance(news, LinkStateChanged)]


def test_the_first_word_on_a_connection_says_who_and_how_far_and_is_all_until_the_welcome():  # R-F01
    end = ClientEnd("me", TERMS)
    end.open(0)
    end.request(b"what", 0)
    assert packets(end) == [Hello(VERSION, "me", "", 0)]
    end.feed(welcome(seq=7), 0)
    assert packets(end) == [RequestPacket(1, 1, 0, 0, b"what")]
    assert events(end) == [EpochChanged("e1")]
    end.feed(SignalPacket(8, b"x"), 0)
    end.cut(lost.closed())
    end.open(0)
    assert packets(end) == [Hello(VERSION, "me", "e1", 8)]


def test_only_the_very_next_signal_is_accepted_and_all_are_acknowledged_at_once():  # R-F01
    end = linked()
    for seq in (1, 3, 1, 2, 2):
        end.feed(SignalPacket(seq, b"%d" % seq), 0)
    assert events(end) == [SignalReceived(1, b"1"), SignalReceived(2, b"2")]
    assert packets(end) == [Ack(2)]
    assert packets(end) == []


def test_a_resumed_link_asks_again_what_was_not_answered():  # R-F01
    end = linked()
    end.request(b"a", 0)
    packets(end)
    end.cut(lost.closed())
    end.open(0)
    packets(end)
    end.feed(welcome(resumed=True), 0)
    assert packets(end) == [RequestPacket(1, 1, 0, 0, b"a")]
    assert events(end) == [Resumed("e1")]


def test_a_new_epoch_voids_what_was_asked_of_the_old_one():  # R-F01
    end = linked()
    end.request(b"a", 0)
    packets(end)
    end.cut(lost.closed())
    end.open(0)
    end.feed(welcome("e2", seq=3, resumed=True), 0)
    assert events(end) == [RequestFailed(1, RequestFate.LOST), EpochChanged("e2")]
    assert packets(end) == [Hello(VERSION, "me", "e1", 0)]
    end.feed(SignalPacket(4, b"new"), 0)
    assert events(end) == [SignalReceived(4, b"new")]


def test_what_moves_a_robot_is_never_said_on_another_connection():  # R-X12
    end = linked()
    end.request(b"go", 0, once=True)
    end.cut(lost.closed())
    assert events(end) == [RequestFailed(1, RequestFate.LOST)]
    end.request(b"go", 0, once=True)
    assert events(end) == [RequestFailed(2, RequestFate.UNSENT)]
    greet(end, welcome(resumed=True))
    end.request(b"go", 0, once=True)
    end.open(0)
    assert events(end) == [RequestFailed(3, RequestFate.LOST)]


def test_an_answer_is_told_once_and_one_that_is_not_wanted_never():  # R-F07
    end = linked()
    end.request(b"a", 0)
    end.request(b"b", 0)
    end.forget(2)
    for packet in (
        ReplyPacket(2, False, 0, b"B"),
        ReplyPacket(1, False, 0, b"A"),
        ReplyPacket(1, False, 0, b"A"),
        ReplyPacket(9, False, 0, b""),
    ):
        end.feed(packet, 0)
    assert events(end) == [ReplyReceived(1, b"A")]


def test_a_request_names_the_first_number_that_is_not_settled():  # R-F07
    end = linked()
    for _ in range(3):
        end.request(b"", 0)
    end.feed(ReplyPacket(1, False, 0, b""), 0)
    end.request(b"", 0)
    assert [packet.done_below for packet in packets(end)] == [1, 1, 1, 2]


def test_a_deadline_is_told_on_the_clock_of_the_runtime():
    end = greet(ClientEnd("me", TERMS), welcome(clock_ns=5000))
    end.request(b"", 100, begin_within_ns=50)
    end.feed(Beat(1, 9000), 200)
    end.request(b"", 200, begin_within_ns=50)
    assert [packet.deadline_ns for packet in packets(end)] == [5150, 9050]


def test_a_request_that_could_not_be_sent_in_time_is_not_sent():
    end = ClientEnd("me", TERMS)
    end.request(b"", 0, begin_within_ns=50)
    end.open(0)
    end.feed(welcome(), 51)
    assert events(end) == [EpochChanged("e1"), RequestFailed(1, RequestFate.UNSENT)]
    assert not any(isinstance(packet, RequestPacket) for packet in packets(end))


def test_a_request_refused_as_late_has_failed():
    end = linked()
    end.request(b"", 0, begin_within_ns=50)
    end.feed(ReplyPacket(1, True, 0, b""), 0)
    assert events(end) == [RequestFailed(1, RequestFate.LATE)]


def test_long_bodies_go_and_come_in_parts():  # R-F01
    end = linked()
    end.request(b"abcdefghij", 0)
    assert packets(end) == [Part(1, 0, b"abcd"), Part(1, 1, b"efgh"), RequestPacket(1, 1, 0, 2, b"ij")]
    end.feed(Part(1, 0, b"1234"), 0)
    end.feed(Part(1, 1, b"5678"), 0)
    end.feed(ReplyPacket(1, False, 2, b"90"), 0)
    assert events(end) == [ReplyReceived(1, b"1234567890")]


def test_an_overtaken_reading_is_not_shown():
    end = linked()
    for count, body in ((1, b"old"), (3, b"new"), (2, b"overtaken")):
        end.feed(ReadingPacket(count, "key", body), 0)
    assert events(end) == [ReadingReceived("key", b"old"), ReadingReceived("key", b"new")]


@pytest.mark.parametrize("packet", [Hello(VERSION, "x", "", 0), RequestPacket(1, 1, 0, 0, b""), Ack(1)])
def test_what_only_an_environment_says_ends_the_connection(packet):
    end = linked()
    end.feed(packet, 0)
    (turned,) = end.take_notices()
    assert (turned.state, turned.lost.cause) == (LinkState.APART, LossCause.GARBAGE)
    not_its_part = Reason.of("link.not_of_runtime", packet=type(packet).__name__)
    assert turned.lost.reason == Reason.of("link.garbage", detail=not_its_part)
    assert packets(end) == [Bye("garbage", turned.lost.reason)]


def test_parts_without_end_end_the_connection():
    end = linked(LinkTerms(body_limit=1000))
    end.request(b"", 0)
    for index in range(20):
        end.feed(Part(1, index, bytes(100)), 0)
    assert end.state is LinkState.APART


@pytest.mark.parametrize(
    "packet",
    [Welcome(VERSION + 1, "e", 0, False, 0), Bye("version", f"this runtime speaks version {VERSION + 1} of the link")],
)
def test_another_version_ends_the_link_for_good(packet):  # R-B06
    end = ClientEnd("me", TERMS)
    end.request(b"", 0)
    end.open(0)
    end.feed(packet, 0)
    turned, failed = end.take_notices()[1:]
    assert (turned.state, turned.lost.cause) == (LinkState.ENDED, LossCause.VERSION)
    assert f"version {VERSION + 1} " in str(turned.lost)
    assert failed == RequestFailed(1, RequestFate.LOST)


def test_a_good_bye_leaves_the_way_open_for_a_new_connection():
    end = linked()
    end.feed(Bye("closed", Reason.plain("going home")), 0)
    (turned,) = end.take_notices()
    assert (turned.state, str(turned.lost)) == (LinkState.APART, "the other side closed the connection: going home")
    end.open(0)
    assert end.state is LinkState.GREETING


def test_silence_ends_the_connection_and_keeps_what_may_be_asked_again():
    end = linked()
    end.request(b"a", 0)
    end.tick(1000)
    assert end.state is LinkState.APART
    assert events(end) == []


def test_a_closed_link_says_good_bye_and_fails_what_was_asked():
    end = linked()
    end.request(b"a", 0)
    end.close(Reason.plain("enough"))
    assert events(end) == [RequestFailed(1, RequestFate.LOST)]
    assert packets(end) == [Bye("closed", Reason.plain("enough"))]
    end.close()
    assert (end.take_notices(), packets(end)) == ([], [])
    end.request(b"b", 0)
    assert events(end) == [RequestFailed(2, RequestFate.UNSENT)]


def test_on_a_carrier_that_loses_packets_everything_is_said_again():
    end = ClientEnd("me", LinkTerms(beat_ns=0, suspect_ns=0, lost_ns=0, retry_ns=10))
    end.open(0)
    packets(end)
    end.tick(9)
    assert packets(end) == []
    end.tick(10)
    assert packets(end, 10) == [Hello(VERSION, "me", "", 0)]
    end.feed(welcome(), 10)
    end.request(b"a", 10)
    assert packets(end) == [RequestPacket(1, 1, 0, 0, b"a")]
    end.tick(20)
    assert packets(end) == [RequestPacket(1, 1, 0, 0, b"a")]
    assert end.due_ns(20) == 10


def test_a_request_that_is_too_long_is_not_sent_and_said_to_be_so():  # R-X19
    end = linked(LinkTerms(body_limit=1000))
    end.take_notices()
    packets(end)
    assert end.request(bytes(1001), 0) == 1
    assert end.take_notices() == [RequestFailed(1, RequestFate.TOO_LONG)] and packets(end) == []
    end.request(bytes(1000), 0)
    assert packets(end)
