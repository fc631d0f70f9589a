import io

import numpy as np
import pytest

from kit.record.recording_builder import run
from onika.host.recording.last_seconds import LastSeconds, TracedEvent, TracedVariables
from onika.host.recording.recorded_variable import places_of
from onika.record import topics
from onika.record.reader import Reader
from onika.record.run import BLACK_BOX, END, RunRecord
from onika.record.series import Series
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.wire import event
from onika.words.reason import Reason
from onika.words.shape import Shape

MS, SECOND = 1_000_000, 1_000_000_000
WORDS = {"completed": "no", "cause": "it fell", "hash": "", "outside": ""}


class Held:
    """A run with two variables, of which the last seconds are held."""

    def __init__(self, lasts_ns=30 * SECOND, most_bytes=1 << 20):
        self.last_seconds = LastSeconds(lasts_ns, most_bytes)
        self.table = Table(Segment.create("test", 1 << 20))
        for name, shape in (("X", "double"), ("LAMP", "int")):
            self.table.entry(name, Shape.parse(shape))
        self.last_seconds.meet(TracedVariables("flow0", places_of(self.table, 0, {"X": "m"})), self.table.segment.view)

    def write(self, number):
        self.table.ring("X").write(np.array([number], dtype=float).tobytes())

    def light(self, number):
        self.table.ring("LAMP").write(np.array([number], dtype=np.int32).tobytes())

    def tell(self, at, message, standing=""):
        body = topics.encode(topics.EventRecord("flow0", message))
        self.last_seconds.note(TracedEvent(topics.EVENTS, at, body, standing))

    def seconds(self, number):
        """So many pass; X changes ten times in each."""
        for look in range(number * 10):
            self.write(look)
            self.last_seconds.look(look * 100 * MS)

    def reader(self, tmp_path):
        path = tmp_path / "box.mcap"
        stream = io.BytesIO()
        self.last_seconds.write(stream, run(), WORDS)
        path.write_bytes(stream.getvalue())
        return Reader(path)


def events(reader):
    return [(at, topics.decode_happened(body).event) for at, body in reader.messages(topics.EVENTS)]


def test_it_is_a_recording_like_any_other(tmp_path):  # R-X05
    held = Held()
    held.tell(0, event.Began(0, 0, 1, "lift", 0.0))
    held.seconds(3)
    reader = held.reader(tmp_path)
    assert reader.is_whole
    assert RunRecord.read(reader).prepare == run().prepare
    assert reader.notes[END] == {**WORDS, "missed": "0", "untold": "0"}
    series = Series.all_of(reader)
    assert series["flow0/X"].unit == "m"
    assert [value for _, value in series["flow0/X"].values()] == list(range(30))
    assert series["flow0/X"].at(1_050 * MS) == 10
    assert "flow0/LAMP" in series
    assert events(reader) == [(0, event.Began(0, 0, 1, "lift", 0.0))]


def test_only_the_last_seconds_are_in_it_and_what_was_in_force_before(tmp_path):  # R-X05
    held = Held(lasts_ns=5 * SECOND)
    held.light(1)
    held.tell(100, event.TaskState("flow0", "servo", "ON", 0.0), "task servo")
    held.tell(200, event.TaskState("flow0", "servo", "ERROR", 0.0), "task servo")
    held.tell(300, event.Warned("flow0", "servo", Reason.plain("hot"), 0.0))
    held.seconds(20)
    held.tell(20 * SECOND, event.Done(0, 0, 20.0))
    reader = held.reader(tmp_path)
    begin = int(reader.notes[BLACK_BOX]["from_ns"])
    assert 14 * SECOND <= begin <= 16 * SECOND
    assert reader.span == (begin, 20 * SECOND)
    assert Series.all_of(reader)["flow0/LAMP"].at(begin) == 1
    assert [message for _, message in events(reader)] == [
        event.TaskState("flow0", "servo", "ERROR", 0.0),
        event.Done(0, 0, 20.0),
    ]
    assert not RunRecord.read(reader).is_fresh


def test_a_run_that_fits_in_can_be_begun_again(tmp_path):  # R-X05
    held = Held()
    held.seconds(2)
    assert RunRecord.read(held.reader(tmp_path)).is_fresh == run().is_fresh


def test_its_memory_is_bounded_whatever_is_written():  # R-X05
    held = Held(most_bytes=20_000)
    sizes = []
    for look in range(4_000):
        held.write(look)
        held.tell(look * 10 * MS, event.Warned("flow0", "servo", Reason.plain("hot"), 0.0))
        held.last_seconds.look(look * 10 * MS)
        sizes.append(held.last_seconds.size)
    assert max(sizes) < 20_000 + 100 * 64 + 4_000 * 200
    assert sum(trace.size for trace in held.last_seconds._traces) < 20_000 + 100 * 64


def test_events_are_bounded_too():  # R-X05
    held = Held()
    for number in range(30_000):
        held.tell(number, event.Warned("flow0", "servo", Reason.plain("x" * 1_000), 0.0))
    assert held.last_seconds.size < 9 * 2**20


def test_what_came_after_the_last_look_is_not_left_out(tmp_path):  # R-X05
    held = Held()
    held.seconds(1)
    held.tell(9 * SECOND, event.Lost("rt0", Reason.plain("killed"), 9.0))
    assert events(held.reader(tmp_path)) == [(9 * SECOND, event.Lost("rt0", Reason.plain("killed"), 9.0))]


def test_a_full_disk_is_an_error_of_the_system():  # R-X05
    class Full(io.BytesIO):
        def write(self, data):
            raise OSError(28, "No space left on device")

    with pytest.raises(OSError, match="No space"):
        Held().last_seconds.write(Full(), run(), WORDS)


def test_a_variable_that_is_gone_keeps_what_was_written_to_it_and_nothing_of_what_lies_there_now(tmp_path):  # R-C12
    held = Held()
    held.seconds(1)
    held.table.free(held.table.drop("X"))
    held.table.entry("Y", Shape.parse("double"))
    held.last_seconds.meet(TracedVariables("flow0", (), ("X",)), held.table.segment.view)
    held.table.ring("Y").write(np.array([99.0]).tobytes())
    held.last_seconds.look(2 * SECOND)
    values = [value for _, value in Series.all_of(held.reader(tmp_path))["flow0/X"].values()]
    assert (values[-1], 99.0 in values) == (9.0, False)


def test_a_variable_that_comes_again_goes_on_where_it_was(tmp_path):  # R-X05
    held = Held()
    held.seconds(1)
    held.table.free(held.table.drop("X"))
    held.table.entry("X", Shape.parse("double"))
    there = tuple(place for place in places_of(held.table, 0, {"X": "m"}) if place.name == "X")
    held.last_seconds.meet(TracedVariables("flow0", there, ("X",)), held.table.segment.view)
    held.write(20)
    held.last_seconds.look(2 * SECOND)
    values = [value for _, value in Series.all_of(held.reader(tmp_path))["flow0/X"].values()]
    assert values[-2:] == [9.0, 20.0]


def test_of_a_variable_with_another_type_only_what_it_is_now_is_told(tmp_path):  # R-X05, law 12
    held = Held()
    held.seconds(1)
    held.table.free(held.table.drop("X"))
    held.table.entry("X", Shape.parse("int"))
    there = tuple(place for place in places_of(held.table, 0, {"X": "m"}) if place.name == "X")
    held.last_seconds.meet(TracedVariables("flow0", there, ("X",)), held.table.segment.view)
    held.table.ring("X").write(np.array([7], dtype=np.int32).tobytes())
    held.last_seconds.look(2 * SECOND)
    assert [value for _, value in Series.all_of(held.reader(tmp_path))["flow0/X"].values()] == [7]


def test_what_is_gone_for_long_is_forgotten(tmp_path):  # R-X05
    held = Held(lasts_ns=2 * SECOND)
    held.seconds(1)
    held.last_seconds.meet(TracedVariables("flow0", (), ("X",)), held.table.segment.view)
    before = held.last_seconds.size
    held.last_seconds.look(10 * SECOND)
    assert held.last_seconds.size < before
    assert "flow0/X" not in Series.all_of(held.reader(tmp_path))
