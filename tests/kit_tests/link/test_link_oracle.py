import pytest

from kit.link.link_oracle import LinkOracle, Wanted, Who
from kit.link.sim_link import SimLink
from onika.link import lost
from onika.link.channel import Channel
from onika.link.link_events import (
    EpochChanged,
    Greeted,
    LinkStateChanged,
    ReadingReceived,
    ReplyReceived,
    RequestFailed,
    RequestFate,
    RequestReceived,
    SignalReceived,
)
from onika.link.state import LinkState
from onika.wire.packet import Ack, Bye, Hello, SignalPacket, Welcome
from onika.words.reason import NOTHING

ENV, RT = Who.ENVIRONMENT, Who.RUNTIME


class StillAir:
    now_ns = 0


def cable(channel=Channel.ALL):
    return SimLink(StillAir(), channel, "me")


def watching():
    witness = LinkOracle()
    witness.environment_starts("me")
    witness.session("me#1", "e1", "me")
    witness.called("me#1", 0)
    witness.signal("e1", b"before")
    line = cable()
    line.heard_hello = True
    witness.served("me#1", Greeted("me", False), line, 0)
    witness.sent(RT, line, Welcome(1, "e1", 1, False, 0))
    witness.heard("me", EpochChanged("e1"), line)
    witness.signal("e1", b"two")
    witness.signal("e1", b"three")
    return witness


def wanted(witness, where=None, once=False, begin_by_ns=0):
    want = Wanted("1", "me", b"1 body", once, begin_by_ns, where)
    witness.wants(want, 1)
    return want


def tell(witness, news, where, now_ns=0):
    if isinstance(news, RequestReceived):
        witness.served("me#1", news, where, now_ns)
    else:
        witness.heard("me", news, where)


def test_a_witness_finds_nothing_wrong_with_an_honest_story():
    witness, line = watching(), cable()
    witness.sent(ENV, line, Hello(1, "me", "", 0))
    line.heard_hello = line.heard_welcome = True
    witness.sent(RT, line, Welcome(1, "e1", 1, False, 0))
    witness.sent(RT, line, SignalPacket(2, b"two"))
    wanted(witness)
    for news in (
        SignalReceived(2, b"two"),
        SignalReceived(3, b"three"),
        RequestReceived(1, "me", b"1 body"),
        ReplyReceived(1, b"re: 1 body"),
        LinkStateChanged(LinkState.APART, lost.closed()),
        ReadingReceived("key", b"5"),
    ):
        tell(witness, news, line)
    witness.stands(9, 10)
    witness.final("me", "e1", LinkState.LINKED)
    witness.final_requests()
    assert witness.faults == []


@pytest.mark.parametrize(
    ("news", "fault"),
    [
        ([SignalReceived(3, b"three")], "2 was next"),
        ([SignalReceived(2, b"two"), SignalReceived(2, b"two")], "3 was next"),
        ([SignalReceived(2, b"other")], "not what was said"),
        ([EpochChanged("e1")], "needless new beginning"),
        ([EpochChanged("e2")], "greeted in ''"),
        ([ReplyReceived(1, b"re: 1 body")], "never carried out"),
        ([RequestReceived(1, "me", b"1 body"), RequestReceived(2, "me", b"1 body")], "carried out 2 times"),
        ([RequestReceived(1, "you", b"1 body")], "came as one of you"),
        ([RequestReceived(1, "me", b"2 else")], "nobody wanted"),
        ([RequestFailed(1, RequestFate.LOST), RequestFailed(1, RequestFate.LOST)], "has outcomes"),
        ([RequestReceived(1, "me", b"1 body"), ReplyReceived(1, b"other")], "another's answer"),
        ([LinkStateChanged(LinkState.APART, lost.garbage("x"))], "an honest environment"),
        ([ReadingReceived("key", b"5"), ReadingReceived("key", b"4")], "shown after 5"),
    ],
)
def test_a_witness_finds_what_is_wrong(news, fault):
    witness, line = watching(), cable()
    wanted(witness)
    for item in news:
        tell(witness, item, line)
    assert any(fault in sentence for sentence in witness.faults), witness.faults


@pytest.mark.parametrize(("who", "packet"), [(RT, SignalPacket(1, b"")), (ENV, Ack(1))])
def test_a_witness_hears_who_speaks_before_the_greeting(who, packet):
    witness = watching()
    witness.sent(who, cable(), Bye("closed", NOTHING))
    assert witness.faults == []
    witness.sent(who, cable(), packet)
    assert len(witness.faults) == 1


def test_a_witness_knows_what_belongs_on_which_channel():
    witness, line = watching(), cable(Channel.SIGNAL)
    line.heard_hello = line.heard_welcome = line.is_welcomed = True
    witness.sent(ENV, line, Ack(1))
    assert witness.faults == []
    line = cable(Channel.STREAM)
    line.heard_hello = line.heard_welcome = line.is_welcomed = True
    witness.sent(ENV, line, Ack(1))
    assert "has no place on the stream channel" in witness.faults[0]


def test_a_witness_knows_late_and_repeated_motion():
    witness, first = watching(), cable()
    wanted(witness, first, once=True, begin_by_ns=10)
    tell(witness, RequestReceived(1, "me", b"1 body"), cable(), 11)
    assert [fault.split(" ", 2)[2] for fault in witness.faults] == [
        "was carried out 1 ns too late",
        "was said again on another connection",
    ]


@pytest.mark.parametrize(
    ("state", "silence_ns", "faults"),
    [(LinkState.LINKED, 9, 0), (LinkState.LINKED, 10, 1), (LinkState.SUSPECT, 10, 0), (LinkState.SUSPECT, 20, 1)],
)
def test_a_witness_knows_who_overlooks_silence(state, silence_ns, faults):
    witness = watching()
    witness.heard_last(ENV, state, silence_ns, 10, 20)
    assert len(witness.faults) == faults


def test_a_witness_knows_when_a_session_has_to_be_given_up():
    witness = watching()
    witness.stands(10, 10)
    assert "was not given up after 10 ns" in witness.faults.pop()
    witness.given_up("me#1", 9, 10)
    assert "was given up 9 ns after it was heard" in witness.faults.pop()
    witness.given_up("me#1", 20, 10)
    assert "it was not there" in witness.faults.pop()


@pytest.mark.parametrize("why", ["leaves", "comes_anew"])
def test_a_session_may_be_given_up_early_where_its_program_left(why):
    witness = watching()
    getattr(witness, why)("me")
    witness.given_up("me#1", 1, 10)
    assert witness.faults == []


def test_a_witness_asks_at_the_end_for_what_is_missing():
    witness = watching()
    wanted(witness)
    witness.final("me", "e2", LinkState.APART)
    witness.final_requests()
    assert len(witness.faults) == 4


def test_a_request_said_not_to_be_carried_out_must_not_have_been():
    witness = watching()
    wanted(witness)
    tell(witness, RequestReceived(1, "me", b"1 body"), None)
    tell(witness, RequestFailed(1, RequestFate.LATE), None)
    witness.environment_ends("me")
    witness.final_requests()
    assert any("was carried out, but" in fault for fault in witness.faults)
