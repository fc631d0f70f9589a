import socket

import pytest

from onika.host.sessions.listener_main import hear_beats, listen


def test_a_listening_socket_takes_any_port_or_says_why_not():
    with listen("127.0.0.1", 0) as listener:
        port = listener.getsockname()[1]
        assert port > 0
        with pytest.raises(OSError, match="in use"):
            listen("127.0.0.1", port)


def test_beats_are_heard_under_the_number_of_the_door_or_under_another():  # R-F07
    with listen("127.0.0.1", 0) as door:
        first = hear_beats(door)
        assert first is not None
        with first, hear_beats(door) as second:
            ports = [listener.getsockname()[1] for listener in (door, first, second)]
    assert ports[0] == ports[1] != ports[2]
    assert first.type == socket.SOCK_DGRAM
