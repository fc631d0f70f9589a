import select
import socket

import pytest

from onika.host.sessions.listen_options import ListenerSettings
from onika.host.sessions.listener_process import ListenerProcess
from onika.host.sessions.users import User
from onika.link.address import Address
from onika.link.caller import Caller, Role
from onika.link.carrier import SocketCarrier, wait_for
from onika.link.channel import Channel
from onika.link.lost import LinkLost
from onika.link.sessions import Introduction
from onika.link.token import digest
from onika.link.websocket_opening import WebSocketOpening
from onika.wire.packet import Hello, encode

HELLO = encode(Hello(2, "me", "e", 3))


def listening(port=0):
    return ListenerSettings("127.0.0.1", port, "", "", (User("ann", Role.VIEWER, digest("anns")),), ("localhost",))


@pytest.mark.site
def test_whom_it_lets_in_the_program_is_given_with_an_end_of_the_connection():  # R-F01
    listener = ListenerProcess(listening())
    listener.open()
    address = Address.parse(listener.address)
    outside = WebSocketOpening(address, "anns")(Channel.STREAM)
    outside.send(HELLO)
    select.select([listener.post], [], [], 10.0)
    ((new, connected),) = listener.arrivals()
    assert new == Introduction(Channel.STREAM, "me", "e", Caller("ann", Role.VIEWER, "127.0.0.1", True))
    inside = SocketCarrier(connected)
    assert received(inside) == [HELLO]
    inside.send(b"down")
    assert received(outside) == [b"down"]
    inside.close()
    with pytest.raises(LinkLost):
        received(outside)
    outside.close()
    assert not listener.ending()
    listener.close()


def received(carrier):
    while True:
        wait_for([carrier], 10.0)
        came = carrier.receive()
        if came:
            return came


@pytest.mark.site
def test_a_place_that_is_taken_is_told():
    with socket.create_server(("127.0.0.1", 0)) as taken:
        listener = ListenerProcess(listening(taken.getsockname()[1]))
        with pytest.raises(OSError, match=r"cannot listen on 127\.0\.0\.1 port"):
            listener.open()
        listener.close()


@pytest.mark.site
def test_its_end_is_noticed():
    listener = ListenerProcess(listening())
    listener.open()
    listener._process.kill()
    listener._process.wait()
    assert listener.arrivals() == []
    assert str(listener.ending()) == "the porter was killed by signal 9; nobody new can connect"
    listener.close()
