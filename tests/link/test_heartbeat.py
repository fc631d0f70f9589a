import socket
import threading
from hashlib import blake2b

import pytest

from onika.link.heartbeat import EVERY_NS, HEADER, HeartbeatCounter, HeartbeatKey, HeartbeatSender, name_in

MS = 1_000_000
NAME, KEY = bytes(range(8)), bytes(range(32))


def test_what_is_told_of_beats_is_understood_and_keys_are_not_shown():
    heartbeat_key = HeartbeatKey.drawn(7994)
    assert HeartbeatKey.parse(heartbeat_key.header()) == heartbeat_key
    assert (len(heartbeat_key.name), len(heartbeat_key.key)) == (8, 32)
    assert repr(HeartbeatKey(7994, NAME, KEY)) == f"HeartbeatKey(port=7994, name={NAME.hex()})"
    assert HEADER == "Onika-Beats"
    assert HeartbeatKey.drawn(7994) != HeartbeatKey.drawn(7994)


@pytest.mark.parametrize("port", [1, 65535])
def test_every_port_that_there_is_can_be_told(port):
    heartbeat_key = HeartbeatKey(port, NAME, KEY)
    assert HeartbeatKey.parse(f"{port} {NAME.hex()} {KEY.hex()}") == heartbeat_key
    assert heartbeat_key.header() == f"{port} {NAME.hex()} {KEY.hex()}"


@pytest.mark.parametrize(
    "header",
    [
        "", "x", "7994", "7994 00", "7994 zz zz", "1 00 00 00",
        f"0 {NAME.hex()} {KEY.hex()}", f"-1 {NAME.hex()} {KEY.hex()}", f"65536 {NAME.hex()} {KEY.hex()}",
        f"70000 {NAME.hex()} {KEY.hex()}",
        f"7994 {NAME.hex()}00 {KEY.hex()}", f"7994 {NAME.hex()[2:]} {KEY.hex()}", f"7994 {NAME.hex()} {KEY.hex()}00",
        f"7994 {NAME.hex()} {KEY.hex()[2:]}", f"7994 {NAME.hex()} {KEY.hex()} 1",
    ],
)  # fmt: skip
def test_what_cannot_be_used_is_no_heartbeat_key(header):
    assert HeartbeatKey.parse(header) is None


def test_a_beat_is_known_by_its_seal():  # R-X12
    heartbeat_key = HeartbeatKey.drawn(7994)
    beat = heartbeat_key.beat(7)
    assert (len(beat), name_in(beat), heartbeat_key.count_in(beat)) == (32, heartbeat_key.name, 7)
    assert beat[:16] == heartbeat_key.name + (7).to_bytes(8, "big")
    for k in range(32):
        wrong = bytearray(beat)
        wrong[k] ^= 1
        assert heartbeat_key.count_in(bytes(wrong)) is None
    assert (name_in(b"short"), heartbeat_key.count_in(b"short")) == (b"", None)
    assert name_in(beat + b"x") == b""


def test_who_does_not_know_the_key_cannot_seal_a_beat():  # R-X12
    heartbeat_key, other = HeartbeatKey(7994, NAME, KEY), HeartbeatKey(7994, NAME, bytes(32))
    assert heartbeat_key.count_in(other.beat(1)) is None


def test_a_sealed_beat_of_another_name_or_length_is_none_of_this_connection():  # R-X12
    heartbeat_key = HeartbeatKey(7994, NAME, KEY)
    for name in (bytes(8), bytes([255]) * 8):
        assert heartbeat_key.count_in(HeartbeatKey(7994, name, KEY).beat(1)) is None
    assert heartbeat_key.count_in(_sealed(NAME + bytes(8))) == 0
    assert [heartbeat_key.count_in(_sealed(NAME + bytes(length))) for length in (0, 4, 7, 9, 16)] == [None] * 5


def _sealed(head):
    """What the key has sealed, whatever it is."""
    return head + blake2b(head, digest_size=16, key=KEY).digest()


def test_a_beat_speaks_only_for_who_serves_the_connection():  # R-X12
    heartbeat_key = HeartbeatKey.drawn(7994)
    counter = HeartbeatCounter(heartbeat_key)
    assert counter.beat(0) is None
    counter.served(1000)
    assert [heartbeat_key.count_in(counter.beat(1000 + k)) for k in (0, 1, 750 * MS - 1)] == [1, 2, 3]
    assert counter.beat(1000 + 750 * MS) is None
    assert counter.beat(1000 + 900 * MS) is None
    counter.served(1500 * MS)
    assert heartbeat_key.count_in(counter.beat(1500 * MS)) == 4


@pytest.fixture
def there():
    """Where beats arrive."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as there:
        there.bind(("127.0.0.1", 0))
        there.settimeout(3)
        yield there


@pytest.fixture
def sender(there):
    """It beats to where they arrive."""
    heartbeat_key = HeartbeatKey(there.getsockname()[1], NAME, KEY)
    sender = HeartbeatSender(heartbeat_key, "127.0.0.1", socket.AF_INET)
    sender.heartbeat_key = heartbeat_key
    yield sender
    sender.close()


def test_beats_come_while_somebody_serves_and_end_with_the_connection(there, sender):  # R-X12
    sender.served()
    assert [sender.heartbeat_key.count_in(there.recv(100)) for _ in range(3)] == [1, 2, 3]
    sender.close()
    there.settimeout(0.2)
    with pytest.raises(TimeoutError):
        for _ in range(3):
            there.recv(100)


def test_who_is_not_served_is_silent_and_beats_once_he_is(there, sender):  # R-X12
    there.settimeout(0.2)
    with pytest.raises(TimeoutError):
        there.recv(100)
    there.settimeout(3)
    sender.served()
    assert sender.heartbeat_key.count_in(there.recv(100)) == 1


def test_it_beats_twenty_times_a_second_and_ends_with_the_program(sender):  # network.md D4
    assert EVERY_NS == 50 * MS
    assert {thread.daemon for thread in threading.enumerate() if thread.name == "onika beats"} == {True}


def test_where_nobody_listens_it_beats_on(there, sender):  # R-X12
    port = there.getsockname()[1]
    there.close()
    sender.served()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as silent:
        silent.settimeout(0.3)
        with pytest.raises(TimeoutError):  # meanwhile several beats are refused
            silent.recv(1)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as again:
        again.bind(("127.0.0.1", port))
        again.settimeout(3)
        sender.served()
        assert sender.heartbeat_key.count_in(again.recv(100)) > 1


def test_where_there_is_no_way_at_all_beating_harms_nobody():
    heartbeat_sender = HeartbeatSender(HeartbeatKey(7994, NAME, KEY), "::1", socket.AF_INET)
    heartbeat_sender.served()
    heartbeat_sender.close()
    heartbeat_sender.served()
