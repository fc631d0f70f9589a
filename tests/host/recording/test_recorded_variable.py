import io

import numpy as np
import pytest
from mcap.reader import make_reader

from onika.host.recording.recorded_variable import VariablePlace, VariableRecorder
from onika.record.writer import Writer
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.words.shape import Shape

MS = 1_000_000


class Bench:
    """A table, and a recording in memory."""

    def __init__(self):
        self.table = Table(Segment.create("test", 1 << 20))
        self.stream = io.BytesIO()
        self.writer = Writer(self.stream)

    def watch(self, name, shape):
        offset = self.table.entry(name, Shape.parse(shape)).offset
        return VariableRecorder("flow0", VariablePlace(name, shape, "", offset), self.table.segment.view, self.writer)

    def write(self, name, *numbers):
        self.table.ring(name).write(np.array(numbers, dtype=float).tobytes())

    def entries(self):
        self.writer.finish()
        self.stream.seek(0)
        return [(entry.log_time, entry.data) for _, _, entry in make_reader(self.stream).iter_messages()]


@pytest.fixture
def bench():
    return Bench()


def test_what_is_taken_at_each_look_is_written_down_at_once_later(bench):  # R-X05, law 29: no value unseen
    watch = bench.watch("X", "double")
    for look in range(5):
        bench.write("X", 2.0 * look)
        bench.write("X", 2.0 * look + 1.0)
        watch.take(4 * MS * (look + 1), 4 * MS * look)
    watch.settle()
    watch.settle()
    assert bench.entries() == [(2 * MS * (n + 1), b'{"value":%d.0}' % n) for n in range(10)]
    assert watch.missed == 0


def test_what_does_not_change_is_written_down_once(bench):
    watch = bench.watch("X", "double[2]")
    for look in range(4):
        bench.write("X", 1.0, 2.0)
        watch.take(look, look - 1)
    watch.settle()
    assert bench.entries() == [(0, b'{"value":[1.0,2.0]}')]


def test_a_long_value_is_not_kept_until_there_are_more(bench):  # bounded
    watch = bench.watch("IMAGE", "double[100]")
    bench.write("IMAGE", *range(100))
    watch.take(0, -1)
    assert len(bench.entries()) == 1


def test_an_entry_that_was_made_anew_is_read_from_its_beginning(bench):
    watch = bench.watch("X", "double")
    for number in (1.0, 2.0, 3.0):
        bench.write("X", number)
    watch.take(0, -1)
    bench.table.ring("X").words[0] = 0
    bench.write("X", 9.0)
    watch.take(1, 0)
    watch.settle()
    assert (bench.entries()[-1], watch.missed) == ((1, b'{"value":9.0}'), 0)
