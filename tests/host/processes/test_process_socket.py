import os
import select
from pathlib import Path

from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.host.processes.process_socket import ProcessSocket


def pair():
    ours, theirs = ProcessSocket.pair()
    return ours, ProcessSocket(theirs)


def everything(post):
    descriptors = []
    while (received := post.receive()) is not None:
        descriptors.append(received[0])
    return descriptors


@settings(deadline=None, max_examples=examples(30))
@given(st.lists(st.binary(min_size=1, max_size=2000), max_size=20))
def test_datagrams_arrive_whole_and_in_order(bodies):  # law 30
    ours, theirs = pair()
    for body in bodies:
        ours.send(body)
    assert everything(theirs) == bodies
    ours.close()
    theirs.close()


def test_what_is_longer_than_a_datagram_may_be_arrives_whole_and_in_order():  # law 30, R-X19
    ours, theirs = pair()
    read, write = os.pipe()
    held = len(list(Path("/proc/self/fd").iterdir()))
    ours.send(b"before")
    ours.send(bytes(20_000_000), (write,))
    ours.send(b"behind")
    assert theirs.receive() == (b"before", [])
    body, (there,) = theirs.receive()
    assert body == bytes(20_000_000) and theirs.receive() == (b"behind", [])
    os.close(there)
    assert len(list(Path("/proc/self/fd").iterdir())) == held
    for descriptor in (read, write):
        os.close(descriptor)
    ours.close()
    theirs.close()


def test_file_descriptors_travel_with_a_datagram():  # law 31
    ours, theirs = pair()
    read, write = os.pipe()
    ours.send(b"here", (write,))
    body, (there,) = theirs.receive()
    assert body == b"here"
    os.write(there, b"through")
    assert os.read(read, 10) == b"through"
    for descriptor in (read, write, there):
        os.close(descriptor)
    ours.close()
    theirs.close()


def test_what_finds_no_room_waits_in_order_and_nobody_blocks():  # law 30
    ours, theirs = pair()
    sent = 0
    while not ours.is_waiting:
        ours.send(sent.to_bytes(4) * 1000)
        sent += 1
    ours.send(sent.to_bytes(4) * 1000)
    received = everything(theirs)
    while ours.is_waiting:
        ours.flush()
        received += everything(theirs)
    assert [int.from_bytes(body[:4]) for body in received] == list(range(sent + 1))
    ours.close()
    theirs.close()


def test_the_end_of_the_other_side_is_seen_and_sending_goes_nowhere():
    ours, theirs = pair()
    theirs.close()
    assert ours.receive() is None
    assert ours.is_closed
    ours.send(b"anybody?")
    ours.close()


def test_what_was_said_before_the_end_still_arrives():
    ours, theirs = pair()
    ours.send(b"last words")
    ours.close()
    assert theirs.receive()[0] == b"last words"
    assert not theirs.is_closed
    assert theirs.receive() is None
    assert theirs.is_closed
    theirs.close()


def test_sending_to_a_side_that_is_gone_closes():
    ours, theirs = pair()
    theirs.close()
    ours.send(b"anybody?")
    assert ours.is_closed
    ours.close()


def test_it_can_be_waited_for():
    ours, theirs = pair()
    assert select.select([theirs], [], [], 0)[0] == []
    ours.send(b"x")
    assert select.select([theirs], [], [], 0)[0] == [theirs]
    ours.close()
    theirs.close()


def test_how_much_waits_is_known():  # law 30
    ours, theirs = ProcessSocket.pair()
    assert ours.waiting == 0
    while not ours.waiting:
        ours.send(bytes(100_000))
    assert ours.waiting == 1
    theirs.close()
    ours.close()


def test_how_many_bytes_wait_is_known():  # law 30
    ours, theirs = pair()
    while not ours.is_waiting:
        ours.send(bytes(100_000))
    assert ours.unsent == 100_000
    ours.send(b"more")
    ours.send(bytes(1_000_000))
    assert ours.unsent == 1_100_004
    everything(theirs)
    ours.flush()
    assert ours.unsent == 0
    ours.send(b"with room")
    assert ours.unsent == 0
    ours.close()
    theirs.close()
