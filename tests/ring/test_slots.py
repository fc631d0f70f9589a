"""One entry of shared memory: whole, newest, and never blocked by a dead writer."""

import itertools
import signal
import subprocess
import sys

import pytest
from hypothesis import given, settings, strategies as st

from onika.ring.segment import Segment
from onika.ring.slots import LINE, Ring
from onika.words.reason import Reason

SIZE = 1 << 16
WRITE_FOR_EVER = """
import sys
from onika.ring.segment import Segment
from onika.ring.slots import Ring
fd, size = int(sys.argv[1]), int(sys.argv[2])
data = bytearray(size)
publish = Ring(Segment.attach(fd).view, 0, size).writer(memoryview(data))
number = 0
print("writing", flush=True)
while True:
    number += 1
    data[:] = bytes([number % 251]) * size
    publish()
"""


def ring(size=8):
    return Ring(memoryview(bytearray(Ring.footprint(size))), 0, size)


def test_an_entry_is_zero_before_the_first_write():
    entry = ring(16)
    assert entry.read() == bytes(16)
    assert entry.count == 0


@given(st.lists(st.binary(min_size=12, max_size=12), min_size=1, max_size=30))
def test_the_newest_value_is_read_and_every_write_is_counted(values):  # law 4
    entry = ring(12)
    for number, value in enumerate(values, 1):
        entry.write(value)
        assert (entry.read(), entry.count) == (value, number)


def test_several_entries_lie_side_by_side_in_one_view():
    sizes = (1, 8, 64, 65)
    offsets = list(itertools.accumulate(map(Ring.footprint, sizes), initial=0))
    assert all(offset % LINE == 0 for offset in offsets)
    view = memoryview(bytearray(offsets[-1]))
    rings = [Ring(view, offset, size) for offset, size in zip(offsets, sizes, strict=False)]
    for _ in range(5):
        for number, entry in enumerate(rings, 1):
            entry.write(bytes([number]) * entry.size)
    assert [entry.read() for entry in rings] == [bytes([number]) * entry.size for number, entry in enumerate(rings, 1)]
    assert [entry.count for entry in rings] == [5] * 4


def test_a_writer_publishes_what_its_source_holds_at_the_time_of_the_call():
    entry, source = ring(2), bytearray(b"ab")
    publish = entry.writer(memoryview(source))
    publish()
    source[:] = b"cd"
    assert entry.read() == b"ab"
    publish()
    assert entry.read() == b"cd"


def test_a_reader_tells_the_count_of_the_value_it_copied():
    entry, target = ring(1), bytearray(1)
    fetch = entry.reader(memoryview(target))
    assert fetch() == 0
    entry.write(b"x")
    assert (fetch(), bytes(target)) == (1, b"x")


def test_a_refresher_copies_when_something_new_was_written_and_only_then():
    entry, target = ring(1), bytearray(1)
    refresh = entry.refresher(memoryview(target))
    entry.write(b"x")
    refresh()
    assert bytes(target) == b"x"
    target[:] = b"?"
    refresh()
    assert bytes(target) == b"?"
    entry.write(b"x")
    refresh()
    assert bytes(target) == b"x"


def test_what_is_forgotten_is_still_read_but_stands_below_the_mark():  # law 3
    entry = ring(1)
    entry.write(b"x")
    assert entry.count > entry.mark
    entry.forget()
    assert entry.count == entry.mark
    assert entry.read() == b"x"
    entry.write(b"y")
    assert entry.count > entry.mark


class Meddled:
    """Counters beside which a writer is busy between the copy and its judgement."""

    def __init__(self, ring, writes):
        self.words, self.ring, self.writes, self.reads = ring.words, ring, writes, 0

    def __getitem__(self, index):
        self.reads += 1
        if self.reads == 2:
            for number in range(self.writes):
                self.ring.write(bytes([10 + number]))
        return self.words[index]


@pytest.mark.parametrize("writes", [0, 1, 62, 63, 64, 100])
@pytest.mark.parametrize("kind", ["reader", "refresher"])
def test_a_copy_is_taken_again_when_the_writer_came_round(kind, writes):  # R-A02
    view, target = memoryview(bytearray(Ring.footprint(1))), bytearray(1)
    entry, writer = Ring(view, 0, 1), Ring(view, 0, 1)
    entry.write(b"\1")
    entry.words = Meddled(writer, writes)
    getattr(entry, kind)(memoryview(target))()
    assert writer.count == 1 + writes
    assert target[0] == (1 if writes < 63 else 10 + writes - 1)


@pytest.mark.parametrize("buffer", [memoryview(bytearray(7)), memoryview(bytearray(8)).cast("d")])
def test_a_buffer_of_another_size_or_format_is_refused(buffer):
    for take in (ring(8).writer, ring(8).reader, ring(8).refresher):
        with pytest.raises(ValueError, match="expected a buffer of 8 bytes"):
            take(buffer)


def test_a_value_of_another_size_is_never_written():  # R-A02
    entry = ring(8)
    with pytest.raises(ValueError, match="8 bytes"):
        entry.write(b"short")
    assert entry.count == 0


@settings(deadline=None, max_examples=20)
@given(st.integers(1, 300), st.integers(0, 9))
def test_entries_in_shared_memory_are_seen_by_whoever_attaches(size, writes):
    segment = Segment.create("test", Ring.footprint(size))
    entry, other = Ring(segment.view, 0, size), Ring(memoryview(segment.view), 0, size)
    for number in range(writes):
        entry.write(bytes([number]) * size)
    assert other.read() == bytes([max(writes - 1, 0)]) * size
    del entry, other
    segment.close()


def test_a_writer_that_dies_half_way_tears_nothing_and_blocks_nobody():  # R-A02, law 31
    segment = Segment.create("test", Ring.footprint(SIZE))
    entry, target = Ring(segment.view, 0, SIZE), bytearray(SIZE)
    fetch = entry.reader(memoryview(target))
    for _ in range(6):
        before = entry.count
        words = [sys.executable, "-c", WRITE_FOR_EVER, str(segment.fd), str(SIZE)]
        with subprocess.Popen(words, pass_fds=[segment.fd], stdout=subprocess.PIPE) as writer:
            writer.stdout.readline()
            while entry.count < before + 200:
                fetch()
                assert target.count(target[0]) == SIZE, "torn while it was being written"
            writer.send_signal(signal.SIGKILL)
        fetch()
        assert target.count(target[0]) == SIZE, "torn by a dead writer"
    entry.write(b"\xfd" * SIZE)
    assert entry.read() == b"\xfd" * SIZE
    del fetch, entry
    segment.close()


# Integrity


def armed(size=8):
    memory = memoryview(bytearray(2 * Ring.footprint(size)))
    entry = Ring(memory, Ring.footprint(size), size)
    entry.arm()
    return entry, memory


def test_an_entry_that_its_writer_writes_is_sound_however_often():  # R-A12
    entry, _ = armed()
    source = bytearray(8)
    writer = entry.signed_writer(memoryview(source))
    for n in range(10):
        assert entry.faults() == []
        source[0] = n
        writer.publish()
    entry.seal()
    assert entry.faults() == []


def test_a_strange_publication_is_counted_when_the_writer_next_publishes():  # R-A12
    entry, _ = armed()
    writer = entry.signed_writer(memoryview(bytearray(8)))
    writer.publish()
    entry.signed_writer(memoryview(bytearray(b"strange!"))).publish()
    assert entry.faults() == []
    writer.publish()
    assert list(map(str, entry.faults())) == ["it was published 1 time by somebody who is not its writer"]


def test_a_writer_that_takes_an_entry_over_finds_nothing_strange():  # R-A12
    entry, _ = armed()
    first, second = (entry.signed_writer(memoryview(bytearray(8))) for _ in range(2))
    first.publish()
    second.look()
    second.publish()
    first.look()
    first.publish()
    assert entry.faults() == []


@pytest.mark.parametrize(
    ("place", "finding"),
    [
        (0, "guard"),
        (7, "guard"),
        (64 + 8 * 64, "not what its writer"),
        (64 + 9, "between"),
    ],
)
def test_each_part_of_an_entry_is_watched(place, finding):  # R-A12
    entry, memory = armed()
    writer = entry.signed_writer(memoryview(bytearray(8)))
    for _ in range(8):
        writer.publish()
    memory[Ring.footprint(8) + place] ^= 0x40
    assert [finding in str(reason) for reason in entry.faults()] == [True]


def test_a_counter_that_jumps_is_found_when_its_writer_next_publishes():  # R-A12
    entry, _ = armed()
    writer = entry.signed_writer(memoryview(bytearray(8)))
    for _ in range(4):
        writer.publish()
    entry.words[0] += 4
    writer.publish()
    assert list(map(str, entry.faults())) == ["it was published 1 time by somebody who is not its writer"]


def test_what_rests_is_sealed_whatever_its_length():  # R-A12
    for size, stride in ((8, 64), (5000, 5056)):
        entry, memory = armed(size)
        writer = entry.signed_writer(memoryview(bytearray(size)))
        for _ in range(3):
            writer.publish()
        entry.seal()
        assert entry.faults() == []
        memory[Ring.footprint(size) + 64 + 3 * stride] ^= 1
        assert entry.faults() == [Reason.of("runtime.value_strange")]


def test_an_entry_needs_room():
    with pytest.raises(ValueError, match="expected 4160 bytes of room at 64, found 4160"):
        Ring(memoryview(bytearray(4160)), 64, 8)


@pytest.mark.parametrize("back", [2, 5, 8])
def test_a_counter_that_was_put_back_is_found_where_something_was_sealed_since(back):  # R-A12
    entry, _ = armed()
    writer = entry.signed_writer(memoryview(bytearray(8)))
    for _ in range(8):
        writer.publish()
    entry.seal()
    entry.words[0] -= back
    assert Reason.of("runtime.counter_put_back") in entry.faults()


def test_the_values_since_a_count_are_there_as_far_as_they_were_not_written_over():  # law 29
    for size, kept in ((8, 63), (600, 3)):
        entry = ring(size)
        assert entry.since(0) == (0, [])
        for number in range(1, 101):
            entry.write(number.to_bytes(size, "little"))
        assert entry.since(100) == (100, [])
        assert [int.from_bytes(each, "little") for each in entry.since(98)[1]] == [99, 100]
        assert [int.from_bytes(each, "little") for each in entry.since(0)[1]] == list(range(101 - kept, 101))
