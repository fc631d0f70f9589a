import pytest

from onika.link.channel import THREE, Channel
from onika.wire.packet import (
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
from onika.words.reason import NOTHING

EVERYWHERE = (Hello(1, "me", "", 0), Welcome(1, "e", 0, True, 0), Beat(1, 0), Bye("closed", NOTHING))
OWN = {
    Channel.SESSION: (RequestPacket(1, 1, 0, 0, b""), ReplyPacket(1, False, 0, b""), Part(1, 0, b"")),
    Channel.SIGNAL: (SignalPacket(1, b""), Ack(1)),
    Channel.STREAM: (ReadingPacket(1, "k", b""),),
}


@pytest.mark.parametrize("channel", THREE)
def test_a_channel_carries_its_own_packets_and_the_greeting_only(channel):  # R-F01
    assert all(channel.carries(packet) for packet in (*EVERYWHERE, *OWN[channel]))
    others = [packet for other, packets in OWN.items() if other is not channel for packet in packets]
    assert not any(channel.carries(packet) for packet in others)


def test_one_connection_may_carry_everything():
    assert all(Channel.ALL.carries(packet) for packets in (EVERYWHERE, *OWN.values()) for packet in packets)


def test_a_session_stands_and_falls_with_the_channel_that_asks():
    assert [channel for channel in Channel if channel.asks] == [Channel.ALL, Channel.SESSION]
