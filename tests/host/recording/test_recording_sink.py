import msgspec
import numpy as np
import pytest

from onika.host.recording.recorded_variable import VariablePlace
from onika.host.recording.recording_sink import (
    AddMessage,
    AddScene,
    AddVariables,
    FinishRecording,
    RecordingSink,
    decode,
    encode,
)
from onika.host.units.pose_stream import WorldPoses
from onika.record import foxglove, topics
from onika.record.reader import Reader
from onika.record.series import Series
from onika.record.writer import Writer
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.wire import event
from onika.words.shape import Shape

MS = 1_000_000


class Desk:
    """A table and the scribe that looks into it."""

    def __init__(self, path):
        self.path = path
        self.table = Table(Segment.create("test", 1 << 18))
        self._stream = path.open("wb")
        self.sink = RecordingSink(self._stream, Writer(self._stream))

    def meet(self, name, shape):
        entry = self.table.entry(name, Shape.parse(shape))
        order = AddVariables("flow0", (VariablePlace(name, shape, "m", entry.offset),))
        self.sink.take(decode(encode(order)), self.table.segment.view)

    def write(self, name, *numbers):
        self.table.ring(name).write(np.array(numbers, dtype=float).tobytes())

    def close(self):
        self._stream.close()

    def read(self):
        self.sink.take(FinishRecording({"completed": "yes"}, 2))
        self._stream.close()
        return Reader(self.path)


@pytest.fixture
def desk(tmp_path):
    desk = Desk(tmp_path / "run.mcap")
    yield desk
    desk.close()


def test_a_variable_is_written_down_when_it_has_changed(desk):  # R-X05, law 29: at write rate
    desk.meet("X", "double[2]")
    desk.sink.look(0)
    for at, numbers in ((10, (1, 2)), (20, (1, 2)), (30, (3, 4))):
        desk.write("X", *numbers)
        desk.sink.look(at * MS)
        desk.sink.look(at * MS + 1)
    series = Series.all_of(desk.read())["flow0/X"]
    assert list(series.values()) == [(10 * MS, [1.0, 2.0]), (30 * MS, [3.0, 4.0])]
    assert series.unit == "m"


def test_several_values_since_the_last_look_are_all_there_each_at_a_time_of_its_own(desk):  # law 29
    desk.meet("X", "double")
    desk.sink.look(0)
    for k in (1, 2, 3):
        desk.write("X", k)
    desk.sink.look(6 * MS)
    reader = desk.read()
    assert list(Series.all_of(reader)["flow0/X"].values()) == [(2 * MS, 1.0), (4 * MS, 2.0), (6 * MS, 3.0)]
    assert reader.notes["end"] == {"completed": "yes", "missed": "0", "untold": "2"}


def test_what_was_written_over_is_counted(desk):  # X05: dropping is counted and told in the file
    desk.meet("X", "double")
    desk.sink.look(0)
    for k in range(68):
        desk.write("X", k)
    desk.sink.look(MS)
    assert desk.sink.missed == 5
    reader = desk.read()
    assert [value for _, value in Series.all_of(reader)["flow0/X"].values()] == [float(k) for k in range(5, 68)]
    assert reader.notes["end"]["missed"] == "5"


def test_a_value_that_was_there_before_is_written_down_at_the_first_look(desk):
    desk.table.entry("C", Shape.parse("double"))
    desk.write("C", 4.5)
    desk.meet("C", "double")
    desk.sink.look(3 * MS)
    assert list(Series.all_of(desk.read())["flow0/C"].values()) == [(3 * MS, 4.5)]


def test_worlds_are_drawn_once_and_again_when_a_lamp_shines(desk):  # K03
    shape = {"name": "lamp", "body": 0, "kind": "sphere", "size": [0.1], "position": [0, 0, 0],
             "quaternion": [1, 0, 0, 0], "rgba": [1, 0, 0, 1], "paint": ""}  # fmt: skip
    row = np.array([[0, 0, 1, 1, 0, 0, 0]], dtype=np.float32).tobytes()
    desk.sink.take(decode(encode(AddScene("boxes", (shape,)))))
    for at, lit in ((1, ()), (2, ()), (3, ("lamp",))):
        desk.sink.take(decode(encode(WorldPoses("boxes", at * MS, row, lit))))
    reader = desk.read()
    assert [at for at, _ in reader.messages(topics.scene("boxes"))] == [0, 3 * MS]
    assert foxglove.lit(reader.newest(topics.scene("boxes"), 3 * MS)[1]) == ["lamp"]
    assert msgspec.json.decode(reader.attachment(topics.shapes("boxes"))) == [shape]
    assert foxglove.rows(reader.newest(topics.frames("boxes"), 9 * MS)[1]) == [[0, 0, 1, 1, 0, 0, 0]]


def test_what_was_said_stands_there_and_is_out_at_every_flush(desk):  # R-X05: kill -9
    body = topics.encode(topics.EventRecord("flow0", event.Done(0, 1, 0.5)))
    desk.sink.take(AddMessage(topics.EVENTS, 5 * MS, body))
    desk.sink.flush()
    assert list(Reader(desk.path).messages(topics.EVENTS)) == [(5 * MS, body)]
    desk.sink.take(AddMessage(topics.EVENTS, 6 * MS, body))
    desk.sink.look(10**10)
    assert Reader(desk.path).count(topics.EVENTS) == 2


def test_a_file_that_is_deleted_or_cut_meanwhile_is_told(desk):  # R-X05: else it would be missed after the run
    body = topics.encode(topics.EventRecord("flow0", event.Done(0, 1, 0.5)))
    desk.sink.take(AddMessage(topics.EVENTS, 5 * MS, body))
    desk.sink.flush()
    with desk.path.open("r+b") as file:
        file.truncate(10)
    with pytest.raises(OSError, match="was cut while"):
        desk.sink.flush()
    desk.path.unlink()
    with pytest.raises(OSError, match="was deleted or replaced"):
        desk.sink.take(FinishRecording({}))


def test_what_is_long_and_no_constant_is_looked_at_twice_as_often(desk):  # R-X05, law 29: no value unseen
    assert desk.sink.is_in_no_hurry
    desk.meet("Q_MEZ", "double[6]")
    desk.meet("MAP", "double[100]")
    assert not desk.sink.is_in_no_hurry  # it may be written in every cycle
    desk.write("MAP", *range(100))
    assert desk.sink.is_in_no_hurry  # a constant is written once
    desk.write("MAP", *range(100))
    assert not desk.sink.is_in_no_hurry
    desk.sink.take(AddVariables("flow0", (), gone=("MAP",)), desk.table.segment.view)
    assert desk.sink.is_in_no_hurry
