import pytest

from onika.link import lost
from onika.link.happening import Asked, EpochChanged, Failed, Fate, Greeted, Read, Replied, Signalled, Turned
from onika.link.state import LinkState
from onika.testing.witness import Connection, Wanted, Who, Witness
from onika.wire.packet import Ack, Bye, Hello, Signal

ENV, RT = Who.ENVIRONMENT, Who.RUNTIME


def watching():
    witness = Witness()
    witness.environment_starts("me")
    witness.runtime_starts("e1")
    witness.signal("e1", b"before")
    witness.happened(RT, Greeted("me", False), None, 0)
    witness.happened(ENV, EpochChanged("e1"), None, 0)
    witness.signal("e1", b"two")
    witness.signal("e1", b"three")
    return witness


def wanted(witness, connection=None, once=False, begin_by_ns=0):
    want = Wanted("1", b"1 body", once, begin_by_ns, connection)
    witness.wants(want, 1)
    return want


def test_a_witness_finds_nothing_wrong_with_an_honest_story():
    witness, connection = watching(), Connection()
    witness.sent(ENV, connection, Hello(1, "me", "", 0))
    connection.heard_hello = connection.heard_welcome = True
    wanted(witness)
    for who, news in (
        (ENV, Signalled(2, b"two")),
        (ENV, Signalled(3, b"three")),
        (RT, Asked(1, "me", b"1 body")),
        (ENV, Replied(1, b"re: 1 body")),
        (ENV, Turned(LinkState.APART, lost.closed())),
        (ENV, Read("key", b"5")),
    ):
        witness.happened(who, news, connection, 0)
    witness.final("e1", {LinkState.LINKED})
    assert witness.faults == []


@pytest.mark.parametrize(
    ("news", "fault"),
    [
        ([Signalled(3, b"three")], "2 was next"),
        ([Signalled(2, b"two"), Signalled(2, b"two")], "3 was next"),
        ([Signalled(2, b"other")], "not what was said"),
        ([EpochChanged("e1")], "needless new beginning"),
        ([EpochChanged("e2")], "greeted in 'e1'"),
        ([Replied(1, b"re: 1 body")], "never carried out"),
        ([Asked(1, "me", b"1 body"), Asked(2, "me", b"1 body")], "carried out 2 times"),
        ([Asked(1, "me", b"2 else")], "nobody wanted"),
        ([Failed(1, Fate.LOST), Failed(1, Fate.LOST)], "has outcomes"),
        ([Asked(1, "me", b"1 body"), Replied(1, b"other")], "another's answer"),
        ([Turned(LinkState.APART, lost.garbage("x"))], "an honest environment"),
        ([Read("key", b"5"), Read("key", b"4")], "shown after 5"),
    ],
)
def test_a_witness_finds_what_is_wrong(news, fault):
    witness, connection = watching(), Connection()
    wanted(witness)
    for item in news:
        witness.happened(ENV, item, connection, 0)
    assert any(fault in found for found in witness.faults), witness.faults


@pytest.mark.parametrize(("who", "packet"), [(RT, Signal(1, b"")), (ENV, Ack(1))])
def test_a_witness_hears_who_speaks_before_the_greeting(who, packet):
    witness = watching()
    witness.sent(who, Connection(), Bye("closed", ""))
    assert witness.faults == []
    witness.sent(who, Connection(), packet)
    assert len(witness.faults) == 1


def test_a_witness_knows_late_and_repeated_motion():
    witness, first = watching(), Connection()
    wanted(witness, first, once=True, begin_by_ns=10)
    witness.happened(RT, Asked(1, "me", b"1 body"), Connection(), 11)
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


def test_a_witness_asks_at_the_end_for_what_is_missing():
    witness = watching()
    wanted(witness)
    witness.final("e1", {LinkState.LINKED, LinkState.APART})
    assert len(witness.faults) == 3


def test_a_request_said_not_to_be_carried_out_must_not_have_been():
    witness = watching()
    want = wanted(witness)
    witness.happened(RT, Asked(1, "me", b"1 body"), None, 0)
    witness.happened(ENV, Failed(1, Fate.LATE), None, 0)
    want.is_abandoned = True
    witness.final("e1", {LinkState.LINKED})
    assert any("was carried out, but" in fault for fault in witness.faults)
