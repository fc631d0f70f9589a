import socket

import pytest
from websockets.client import ClientProtocol
from websockets.frames import Frame
from websockets.http11 import Request
from websockets.server import ServerProtocol
from websockets.uri import parse_uri

from onika.link.lost import LinkLost, LossCause
from onika.link.websocket import WebSocketCarrier
from onika.wire.frame import FRAME_LIMIT


class Pair:
    """A carrier, and the other side of its WebSocket by hand."""

    def __init__(self, **settings):
        ours, self.raw = socket.socketpair()
        client = ClientProtocol(parse_uri("ws://localhost/"), max_size=FRAME_LIMIT)
        self.server = ServerProtocol(max_size=2 * FRAME_LIMIT)
        client.send_request(client.connect())
        self.server.receive_data(b"".join(client.data_to_send()))
        (request,) = self.server.events_received()
        assert isinstance(request, Request)
        self.server.send_response(self.server.accept(request))
        client.receive_data(b"".join(self.server.data_to_send()))
        self.carrier = WebSocketCarrier(ours, client, **settings)
        self.raw.settimeout(5.0)

    def say(self, payload):
        self.server.send_binary(payload)
        self.flush()

    def flush(self):
        for data in self.server.data_to_send():
            if data:
                self.raw.sendall(data)

    def hear(self):
        self.server.receive_data(self.raw.recv(1 << 20))
        return [bytes(frame.data) for frame in self.server.events_received() if isinstance(frame, Frame)]

    def close(self):
        self.carrier.close()
        self.raw.close()


@pytest.fixture
def pair():
    made = Pair()
    yield made
    made.close()


def test_each_payload_is_one_message_both_ways(pair):  # R-F01
    pair.carrier.send(b"one")
    pair.carrier.send(b"two")
    assert pair.hear() == [b"one", b"two"]
    pair.say(b"three")
    pair.say(b"four" * 20_000)
    assert pair.carrier.receive() == [b"three", b"four" * 20_000]
    assert pair.carrier.receive() == []


def test_nobody_waits_for_a_slow_reader_until_too_much_waits():  # R-F01
    pair = Pair(buffer_limit=1 << 20)
    with pytest.raises(LinkLost) as lost:
        for _ in range(100):
            pair.carrier.send(b"x" * 100_000)
    assert lost.value.cause is LossCause.BEHIND
    assert pair.carrier.pending > 1 << 20
    pair.close()


def test_what_came_before_the_end_is_still_given(pair):
    pair.say(b"last")
    pair.server.send_close(1000, "enough")
    pair.flush()
    pair.raw.shutdown(socket.SHUT_WR)
    assert pair.carrier.receive() == [b"last"]
    with pytest.raises(LinkLost) as lost:
        pair.carrier.receive()
    assert (lost.value.cause, "enough" in str(lost.value)) == (LossCause.CLOSED, True)


@pytest.mark.parametrize("data", [b"\xff\xff\xff\xff", b"\x81\x02hi", b"\x82\x7f" + b"\xff" * 8])
def test_what_is_no_message_of_ours_is_garbage(pair, data):  # R-F01
    pair.raw.sendall(data)
    with pytest.raises(LinkLost) as lost:
        pair.carrier.receive()
    assert lost.value.cause is LossCause.GARBAGE


def test_a_ping_is_answered(pair):
    pair.server.send_ping(b"there?")
    pair.flush()
    assert pair.carrier.receive() == []
    assert pair.hear() == [b"there?"]


def test_after_the_end_nothing_is_sent_and_there_is_no_descriptor(pair):
    pair.carrier.close()
    assert pair.carrier.fileno() == -1
    assert pair.carrier.held == 0
    pair.carrier.flush()
    with pytest.raises(LinkLost):
        pair.carrier.receive()
