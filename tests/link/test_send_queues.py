from onika.link.body_parts import split
from onika.link.readings import Readings
from onika.link.send_queues import SendQueues
from onika.wire.packet import Ack, Bye, ReadingPacket, RequestPacket
from onika.words.reason import NOTHING


def request(number, body=b""):
    return RequestPacket(number, 1, 0, 0, body)


def test_signals_pass_requests_and_requests_pass_readings():  # R-F01
    readings = Readings()
    readings.put("key", b"", 0)
    queues = SendQueues(readings)
    queues.session([], request(1))
    queues.signal(Ack(1))
    assert queues.take(10_000, 0) == [Ack(1), request(1), ReadingPacket(1, "key", b"")]


def test_without_room_only_the_signal_queue_goes():
    readings = Readings()
    readings.put("key", b"", 0)
    queues = SendQueues(readings)
    queues.session([], request(1))
    queues.signal(Ack(1))
    assert queues.take(0, 0) == [Ack(1)]


def test_a_long_body_lets_signals_through_between_its_parts():
    queues = SendQueues(Readings())
    parts, last = split(1, bytes(1000), 100)
    queues.session(parts, RequestPacket(1, 1, 0, len(parts), last))
    assert queues.take(150, 0) == parts[:2]
    queues.signal(Ack(1))
    assert queues.take(150, 0)[0] == Ack(1)


def test_an_urgent_request_passes_the_others_with_its_parts_in_order():
    queues = SendQueues(Readings())
    queues.session([], request(1))
    parts, last = split(2, b"abcdef", 2)
    queues.session(parts, request(2, last), urgent=True)
    assert queues.take(10_000, 0) == [*parts, request(2, last), request(1)]


def test_what_waits_already_is_not_queued_twice_but_may_be_said_again_later():
    queues = SendQueues(Readings())
    queues.session([], request(1))
    queues.session([], request(1))
    assert queues.take(10_000, 0) == [request(1)]
    queues.session([], request(1))
    assert queues.take(10_000, 0) == [request(1)]


def test_the_last_word_comes_when_all_else_is_said():
    queues = SendQueues(Readings())
    queues.session([], request(1, bytes(100)))
    queues.last(Bye("closed", NOTHING))
    assert queues.take(0, 0) == []
    assert queues.take(1, 0) == [request(1, bytes(100)), Bye("closed", NOTHING)]
    assert queues.take(1, 0) == []


def test_nothing_of_one_connection_goes_over_another():
    readings = Readings()
    readings.put("key", b"", 0)
    queues = SendQueues(readings)
    queues.session([], request(1))
    queues.signal(Ack(1))
    queues.last(Bye("closed", NOTHING))
    queues.clear()
    assert queues.take(10_000, 0) == []
    queues.session([], request(1))
    assert queues.take(10_000, 0) == [request(1)]
