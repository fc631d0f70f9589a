import pytest

from onika.host.sessions.heartbeat_registry import HeartbeatRegistry


@pytest.fixture
def came():
    return []


def test_each_beat_of_a_connection_counts_once_and_never_again(came):  # R-X12
    book = HeartbeatRegistry(7994)
    heartbeat_key = book.open(came.append)
    assert heartbeat_key.port == 7994
    assert not book.take(heartbeat_key.beat(0))
    assert all(book.take(heartbeat_key.beat(count)) for count in (1, 2, 5))
    assert not any(book.take(heartbeat_key.beat(count)) for count in (5, 2, 1, 4))
    assert came == [1, 2, 5]


def test_what_strangers_send_counts_for_nobody(came):  # R-X12
    book = HeartbeatRegistry(7994)
    heartbeat_key, other = book.open(came.append), HeartbeatRegistry(7994).open(came.append)
    beat = heartbeat_key.beat(1)
    forged = [
        b"", b"x", b"\0" * 32, b"\0" * 65000, beat[:-1], beat + b"\0", beat[:-1] + bytes([beat[-1] ^ 1]),
        beat[:8] + bytes([255]) + beat[9:], other.beat(1), heartbeat_key.name + other.beat(9)[8:],
    ]  # fmt: skip
    assert {book.take(beat) for beat in forged} == {False}
    assert came == []
    assert book.take(beat)


def test_beats_of_a_connection_that_is_no_more_count_no_more(came):  # R-X12
    book = HeartbeatRegistry(7994)
    heartbeat_key = book.open(came.append)
    book.close(heartbeat_key)
    assert not book.take(heartbeat_key.beat(1))
    book.close(None)


def test_where_no_datagram_can_come_nobody_is_told_to_send_any(came):
    assert HeartbeatRegistry().open(came.append) is None
