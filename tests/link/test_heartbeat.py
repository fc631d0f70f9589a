import socket

import pytest

from onika.link.heartbeat import EVERY_NS, LENGTH, PATIENCE_NS, HeartbeatCounter, HeartbeatKey, HeartbeatSender, name_in


def test_what_is_told_of_beats_is_understood_and_keys_are_not_shown():
    heartbeat_key = HeartbeatKey.drawn(7994)
    assert HeartbeatKey.parse(heartbeat_key.header()) == heartbeat_key
    assert heartbeat_key.key.hex() not in repr(heartbeat_key)
    assert HeartbeatKey.drawn(7994) != HeartbeatKey.drawn(7994)


@pytest.mark.parametrize(
    "header", ["", "x", "7994", "7994 00", "7994 zz zz", "0 " + "00" * 8 + " " + "00" * 32, "1 00 00 00"]
)
def test_what_cannot_be_used_is_no_heartbeat_key(header):
    assert HeartbeatKey.parse(header) is None


def test_a_beat_is_known_by_its_seal():  # R-X12
    heartbeat_key = HeartbeatKey.drawn(7994)
    beat = heartbeat_key.beat(7)
    assert (len(beat), name_in(beat), heartbeat_key.count_in(beat)) == (LENGTH, heartbeat_key.name, 7)
    for k in range(LENGTH):
        wrong = bytearray(beat)
        wrong[k] ^= 1
        assert heartbeat_key.count_in(bytes(wrong)) is None
    assert (name_in(b"short"), heartbeat_key.count_in(b"short")) == (b"", None)


def test_a_beat_speaks_only_for_who_serves_the_connection():  # R-X12
    heartbeat_key = HeartbeatKey.drawn(7994)
    counter = HeartbeatCounter(heartbeat_key)
    assert counter.beat(0) is None
    counter.served(1000)
    assert [heartbeat_key.count_in(counter.beat(1000 + k)) for k in (0, 1, PATIENCE_NS - 1)] == [1, 2, 3]
    assert counter.beat(1000 + PATIENCE_NS) is None
    counter.served(2 * PATIENCE_NS)
    assert heartbeat_key.count_in(counter.beat(2 * PATIENCE_NS)) == 4


def test_beats_come_while_somebody_serves_and_end_with_the_connection():  # R-X12
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as there:
        there.bind(("127.0.0.1", 0))
        there.settimeout(10)
        heartbeat_key = HeartbeatKey.drawn(there.getsockname()[1])
        heartbeat_sender = HeartbeatSender(heartbeat_key, "127.0.0.1", socket.AF_INET)
        heartbeat_sender.served()
        assert [heartbeat_key.count_in(there.recv(100)) for _ in range(3)] == [1, 2, 3]
        heartbeat_sender.close()
        there.settimeout(4 * EVERY_NS * 1e-9)
        with pytest.raises(TimeoutError):
            for _ in range(3):
                there.recv(100)


def test_where_nobody_listens_beating_harms_nobody():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as there:
        there.bind(("127.0.0.1", 0))
        port = there.getsockname()[1]
    heartbeat_sender = HeartbeatSender(HeartbeatKey.drawn(port), "127.0.0.1", socket.AF_INET)
    heartbeat_sender.served()
    heartbeat_sender.close()
    heartbeat_sender.served()
