import pytest

from kit.link.sim_link import SimLink
from onika.link.channel import Channel
from onika.link.lost import LinkLost
from onika.wire.packet import Ack, Hello, Welcome, encode

HELLO = encode(Hello(1, "me", "", 0))


class SimNetwork:
    """A network that brings everything at once and writes down what it is told."""

    def __init__(self):
        self.now_ns = 7
        self.said = []

    def carry(self, plug, act):
        act()

    def tell_end(self, plug, act):
        act()

    def sent(self, plug, packet):
        self.said.append(("sent", packet))

    def came(self, plug, packet, payload):
        self.said.append(("came", packet))

    def ended(self, plug):
        self.said.append(("ended", plug.is_runtime))


def test_what_one_end_sends_lies_in_the_others_inbox():
    air = SimNetwork()
    cable = SimLink(air, Channel.ALL, "me")
    air.now_ns = 9
    cable.environment.send(HELLO)
    assert cable.runtime.receive() == [HELLO]
    assert cable.runtime.receive() == []
    assert (cable.heard_hello, cable.heard_welcome, cable.runtime.heard_ns) == (True, False, 9)
    cable.runtime.send(encode(Welcome(1, "e", 0, False, 0)))
    assert cable.heard_welcome
    assert [kind for kind, _ in air.said] == ["sent", "came", "sent", "came"]


def test_the_end_comes_after_what_was_said_before():
    air = SimNetwork()
    cable = SimLink(air, Channel.ALL, "me")
    cable.environment.send(HELLO)
    cable.environment.close()
    assert air.said[-1] == ("ended", True)
    assert cable.runtime.receive() == [HELLO]
    with pytest.raises(LinkLost):
        cable.runtime.receive()


def test_nothing_arrives_over_a_broken_cable_or_at_a_closed_end():
    cable = SimLink(SimNetwork(), Channel.SIGNAL, "me")
    cable.is_broken = True
    cable.environment.send(encode(Ack(1)))
    assert cable.runtime.receive() == []
    cable.is_broken = False
    cable.runtime.close()
    cable.environment.send(encode(Ack(1)))
    assert cable.runtime.receive() == []
