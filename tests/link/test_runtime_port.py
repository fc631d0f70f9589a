import pytest

from onika.link.carrier import memory_pair, socket_pair
from onika.link.connection import Connection
from onika.link.link_events import Greeted, LinkStateChanged, RequestReceived, SignalReceived
from onika.link.link_terms import NO_BEATS
from onika.link.lost import LinkLost, LossCause
from onika.link.reply_log import ReplyLog
from onika.link.runtime_port import ServerPort
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkState
from onika.words.reason import Reason


def linked(make_pair=memory_pair, port=None):
    port = port or ServerPort(SignalJournal("e1"), terms=NO_BEATS)
    here, there = make_pair()
    port.attach(there, 0)
    connection = Connection(here, lambda: 0, NO_BEATS, client="me", wait=lambda *_: None)
    port.service(0)
    connection.poll()
    return port, connection


def test_a_port_tells_who_is_there_what_is_asked_and_when_nobody_is_there_any_more():  # R-F01
    port = ServerPort(SignalJournal("e1"), terms=NO_BEATS)
    here, there = memory_pair()
    port.attach(there, 0)
    connection = Connection(here, lambda: 0, NO_BEATS, client="me")
    assert port.service(0)[-1] == Greeted("me", False)
    connection.poll()
    connection.ask(b"a")
    assert port.service(0) == [RequestReceived(1, "me", b"a")]
    here.close()
    (turned,) = port.service(0)
    assert isinstance(turned, LinkStateChanged)
    assert (turned.state, turned.lost.cause) == (LinkState.APART, LossCause.CLOSED)
    assert (port.is_open, port.fileno()) == (False, -1)


def test_a_port_waits_for_writing_only_while_something_waits():
    port, connection = linked(socket_pair)
    assert port.is_open
    assert port.fileno() >= 0
    assert not port.want_write()
    for _ in range(200):
        port.signal(bytes(400_000), 0)
        if port.want_write():
            break
    assert port.want_write()
    got = []
    while port.want_write():
        got += connection.poll()
        port.service(0)
    got += connection.poll()
    seqs = [news.seq for news in got if isinstance(news, SignalReceived)]
    assert seqs == list(range(1, len(seqs) + 1))
    port.drop()
    connection.close()


def test_an_answer_goes_out_at_once():
    port, connection = linked()
    number = connection.ask(b"a")
    (request,) = port.service(0)
    port.reply(request.ticket, b"A", 0)
    (replied,) = connection.poll()
    assert (replied.number, replied.body) == (number, b"A")
    with pytest.raises(KeyError):
        port.reply(request.ticket, b"again", 0)


def test_two_ports_of_a_runtime_serve_two_environments():  # R-X12
    journal, replies = SignalJournal("e1"), ReplyLog()
    ports = [ServerPort(journal, replies, NO_BEATS) for _ in range(2)]
    connections = [linked(port=port)[1] for port in ports]
    ports[0].signal(b"s", 0)
    ports[1].service(0)
    assert [connection.poll() for connection in connections] == [[SignalReceived(1, b"s")]] * 2


def test_a_closed_port_lets_the_last_words_out_and_then_the_connection():
    port, connection = linked()
    port.signal(b"last", 0)
    port.close(0, Reason.of("link.runtime_ends"))
    assert not port.is_open
    assert connection.poll()[0] == SignalReceived(1, b"last")
    with pytest.raises(LinkLost, match="the runtime ends"):
        connection.request(b"a")


def test_without_beats_a_port_is_never_due():  # law 15
    port, _ = linked()
    assert port.due_ns(0) is None
    assert port.state is LinkState.LINKED
