from onika.link.body_parts import split
from onika.link.readings import Readings
from onika.link.send_queues import SendQueues
from onika.wire.packet import Ack, Bye, Reading, Request


def request(number, body=b""):
    return Request(number, 1, 0, 0, body)


def test_signals_pass_requests_and_requests_pass_readings():  # R-F01
    readings = Readings()
    readings.put("key", b"", 0)
    lanes = SendQueues(readings)
    lanes.session([], request(1))
    lanes.signal(Ack(1))
    assert lanes.take(10_000, 0) == [Ack(1), request(1), Reading(1, "key", b"")]


def test_without_room_only_the_signal_lane_goes():
    readings = Readings()
    readings.put("key", b"", 0)
    lanes = SendQueues(readings)
    lanes.session([], request(1))
    lanes.signal(Ack(1))
    assert lanes.take(0, 0) == [Ack(1)]


def test_a_long_body_lets_signals_through_between_its_parts():
    lanes = SendQueues(Readings())
    parts, last = split(1, bytes(1000), 100)
    lanes.session(parts, Request(1, 1, 0, len(parts), last))
    assert lanes.take(150, 0) == parts[:2]
    lanes.signal(Ack(1))
    assert lanes.take(150, 0)[0] == Ack(1)


def test_an_urgent_request_passes_the_others_with_its_parts_in_order():
    lanes = SendQueues(Readings())
    lanes.session([], request(1))
    parts, last = split(2, b"abcdef", 2)
    lanes.session(parts, request(2, last), urgent=True)
    assert lanes.take(10_000, 0) == [*parts, request(2, last), request(1)]


def test_what_waits_already_is_not_queued_twice_but_may_be_said_again_later():
    lanes = SendQueues(Readings())
    lanes.session([], request(1))
    lanes.session([], request(1))
    assert lanes.take(10_000, 0) == [request(1)]
    lanes.session([], request(1))
    assert lanes.take(10_000, 0) == [request(1)]


def test_the_last_word_comes_when_all_else_is_said():
    lanes = SendQueues(Readings())
    lanes.session([], request(1, bytes(100)))
    lanes.last(Bye("closed", ""))
    assert lanes.take(0, 0) == []
    assert lanes.take(1, 0) == [request(1, bytes(100)), Bye("closed", "")]
    assert lanes.take(1, 0) == []


def test_nothing_of_one_connection_goes_over_another():
    readings = Readings()
    readings.put("key", b"", 0)
    lanes = SendQueues(readings)
    lanes.session([], request(1))
    lanes.signal(Ack(1))
    lanes.last(Bye("closed", ""))
    lanes.clear()
    assert lanes.take(10_000, 0) == []
    lanes.session([], request(1))
    assert lanes.take(10_000, 0) == [request(1)]
