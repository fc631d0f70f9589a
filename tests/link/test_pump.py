import pytest

from onika.link.carrier import memory_pair, socket_pair
from onika.link.client import ClientEnd
from onika.link.link_events import LinkStateChanged, ReadingReceived, RequestReceived, SignalReceived
from onika.link.link_terms import NO_BEATS
from onika.link.lost import LossCause
from onika.link.pump import Pump
from onika.link.reply_log import ReplyLog
from onika.link.server import ServerEnd
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkState


@pytest.fixture(params=[memory_pair, socket_pair])
def link(request):
    client, server = ClientEnd("me", NO_BEATS), ServerEnd(SignalJournal("e1"), ReplyLog(), NO_BEATS)
    pumps = Pump(client), Pump(server)
    here, there = request.param()
    pumps[1].attach(there, 0)
    pumps[0].attach(here, 0)
    serve(pumps)
    yield client, server, pumps
    for pump in pumps:
        pump.drop()


def serve(pumps, rounds=3):
    for _ in range(rounds):
        for pump in pumps:
            pump.service(0)


def lost(end):
    return [news.lost.cause for news in end.take_notices() if isinstance(news, LinkStateChanged) and news.lost]


def test_two_ends_find_together_and_speak(link):  # R-F01
    client, server, pumps = link
    assert client.state is server.state is LinkState.LINKED
    client.request(b"a", 0)
    server.signal(b"s", 0)
    serve(pumps)
    assert RequestReceived(1, "me", b"a") in server.take_notices()
    assert SignalReceived(1, b"s") in client.take_notices()


def test_a_body_of_megabytes_arrives_whole(link):  # R-F01
    client, server, pumps = link
    body = bytes(range(256)) * 20_000
    client.request(body, 0)
    serve(pumps, rounds=200)
    assert RequestReceived(1, "me", body) in server.take_notices()


def test_garbage_ends_the_connection_and_the_sender_is_told(link):
    client, server, pumps = link
    pumps[0].carrier.send(b"nonsense")
    serve(pumps)
    assert lost(server) == [LossCause.GARBAGE]
    assert lost(client) == [LossCause.GARBAGE]
    assert [pump.carrier for pump in pumps] == [None, None]


def test_the_other_side_learns_of_a_connection_let_go(link):
    client, server, pumps = link
    pumps[0].drop()
    serve(pumps)
    assert lost(client) == [LossCause.HERE]
    assert lost(server) == [LossCause.CLOSED]


def test_a_new_connection_takes_the_place_of_the_old_one(link):  # R-F01
    client, server, pumps = link
    client.take_notices()
    here, there = memory_pair()
    pumps[1].attach(there, 0)
    server.signal(b"meanwhile", 0)
    pumps[0].attach(here, 0)
    serve(pumps)
    assert SignalReceived(1, b"meanwhile") in client.take_notices()


def test_a_reader_that_stops_reading_gets_no_readings_until_it_reads_again():
    client, server = ClientEnd("me", NO_BEATS), ServerEnd(SignalJournal("e1"), ReplyLog(), NO_BEATS)
    pumps = Pump(client), Pump(server)
    here, there = socket_pair()
    pumps[1].attach(there, 0)
    pumps[0].attach(here, 0)
    serve(pumps)
    for number in range(1000):
        server.reading("picture", b"%d" % number + bytes(16_000), 0)
        pumps[1].service(0)
    assert there.pending < 300_000
    seq = server.signal(b"finish", 0)
    serve(pumps, rounds=100)
    news = client.take_notices()
    shown = [int(item.body.rstrip(b"\0")) for item in news if isinstance(item, ReadingReceived)]
    assert shown == sorted(set(shown))
    assert len(shown) < 1000
    assert shown[-1] == 999
    assert SignalReceived(seq, b"finish") in news
    for pump in pumps:
        pump.drop()


def test_a_pump_without_a_connection_does_nothing():
    end = ClientEnd("me")
    pump = Pump(end)
    pump.service(0)
    pump.drop()
    assert end.take_notices() == []
