import signal
import socket
import threading
import time

import pytest

from onika.link.carrier import SocketCarrier, memory_pair, socket_pair, wait_for
from onika.link.lost import LinkLost, LossCause
from onika.wire.frame import frame


def tcp_pair():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        here = socket.create_connection(listener.getsockname())
        there, _ = listener.accept()
    return SocketCarrier(here), SocketCarrier(there)


@pytest.fixture(params=[memory_pair, socket_pair, tcp_pair])
def pair(request):
    here, there = request.param()
    yield here, there
    here.close()
    there.close()


def take(carrier, count):
    taken = []
    while len(taken) < count:
        if carrier.fileno() >= 0:
            wait_for([carrier], 5.0)
        taken += carrier.receive()
    return taken


def end_of(carrier):
    while True:
        if carrier.fileno() >= 0:
            wait_for([carrier], 5.0)
        try:
            carrier.receive()
        except LinkLost as why:
            return why


def test_payloads_arrive_whole_and_in_order_both_ways(pair):  # R-F01
    here, there = pair
    for number in range(20):
        here.send(b"%d" % number)
        there.send(b"-%d" % number)
    assert take(there, 20) == [b"%d" % number for number in range(20)]
    assert take(here, 20) == [b"-%d" % number for number in range(20)]
    assert here.receive() == []


def test_what_was_sent_before_the_end_arrives_and_then_the_end(pair):  # R-F01
    here, there = pair
    here.send(b"last")
    here.close()
    assert take(there, 1) == [b"last"]
    assert end_of(there).cause is LossCause.CLOSED
    there.send(b"into the void")
    assert end_of(there).cause is LossCause.CLOSED


def test_a_carrier_that_was_closed_here_says_so(pair):
    here, _ = pair
    here.close()
    with pytest.raises(LinkLost) as caught:
        here.receive()
    assert caught.value.cause is LossCause.HERE


def test_a_reader_that_stops_reading_is_cut_and_never_waited_for():
    for here, there in (socket_pair(), memory_pair(buffer_limit=1 << 20)):
        if isinstance(here, SocketCarrier):
            here._buffer_limit = 1 << 20
        with pytest.raises(LinkLost) as caught:
            for _ in range(10_000):
                here.send(bytes(100_000))
        assert caught.value.cause is LossCause.BEHIND
        here.close()
        there.close()


def test_what_did_not_fit_goes_on_later():
    here, there = socket_pair()
    payloads = [bytes([number]) * 400_000 for number in range(8)]
    for payload in payloads:
        here.send(payload)
    assert here.pending > 0
    taken = []
    while len(taken) < len(payloads):
        taken += there.receive()
        here.flush()
    assert taken == payloads
    assert here.pending == 0
    here.close()
    there.close()


def test_bytes_that_are_no_frames_are_garbage_after_what_was_good():
    raw, theirs = socket.socketpair()
    carrier = SocketCarrier(theirs)
    raw.sendall(frame(b"good"))
    assert take(carrier, 1) == [b"good"]
    raw.sendall(b"\xff\xff\xff\xffGET / HTTP/1.1")
    why = end_of(carrier)
    assert (why.cause, "expected a frame" in str(why)) == (LossCause.GARBAGE, True)
    raw.close()
    carrier.close()


def test_an_end_in_the_middle_of_a_message_is_told_as_such():
    raw, theirs = socket.socketpair()
    carrier = SocketCarrier(theirs)
    raw.sendall(frame(b"cut off")[:6])
    raw.close()
    assert "in the middle of a message" in str(end_of(carrier))
    carrier.close()


def test_waiting_ends_when_something_came():
    here, there = socket_pair()
    there.send(b"x")
    wait_for([here], None)
    assert here.receive() == [b"x"]
    wait_for([here], 0.0)
    here.close()
    there.close()
    assert here.fileno() == -1


class Interrupted(Exception):
    """What a handler of this test raises."""


def test_a_signal_that_another_thread_was_given_ends_a_wait():  # R-E07
    """After a freeze the system gives a Ctrl-C to any thread; the handler still runs in the first one only."""
    here, there = socket_pair()
    was_handled = threading.Event()

    def handle(_number, _frame):
        was_handled.set()
        raise Interrupted

    def be_signalled():
        time.sleep(0.05)  # by then the wait has begun
        signal.pthread_kill(threading.get_ident(), signal.SIGUSR1)
        was_handled.wait(5.0)
        there.send(b"x")  # else the wait would have no end

    former = signal.signal(signal.SIGUSR1, handle)
    other = threading.Thread(target=be_signalled)
    try:
        with pytest.raises(Interrupted):
            other.start()
            wait_for([here], None)
        assert here.receive() == []
    finally:
        other.join()
        signal.signal(signal.SIGUSR1, former)
        here.close()
        there.close()
