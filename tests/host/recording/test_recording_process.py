import os
import threading
from time import monotonic_ns

import numpy as np

from kit.process.next_message import next_message
from kit.record.recording_builder import run
from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording import recording_process
from onika.host.recording.recorded_variable import VariablePlace
from onika.host.recording.recording_sink import AddVariables, BeginRecording, FinishRecording, encode
from onika.host.units.pose_stream import WorldPoses
from onika.record import topics
from onika.record.reader import Reader
from onika.record.run import RunRecord
from onika.record.series import Series
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.words.reason import NOTHING
from onika.words.shape import Shape


class Beside:
    """The process's loop in a thread, on the other end of a post."""

    def __init__(self, path):
        self.post, theirs = ProcessSocket.pair()
        body = recording_process.encode_run(run())
        memory = Segment.create("run", len(body))
        memory.view[:] = body
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT)
        self.inlet, far = ProcessSocket.pair()
        self.post.send(b"run", (memory.fd, descriptor, far.fileno()))
        far.close()
        os.close(descriptor)
        memory.close()
        self.far = ProcessSocket(theirs)
        self.thread = threading.Thread(target=recording_process.record, args=(self.far, 2_000_000))
        self.thread.start()

    def close(self):
        self.post.close()
        self.inlet.close()
        self.thread.join(10)
        self.far.close()
        assert not self.thread.is_alive()

    def word(self):
        return recording_process.decode_word(next_message(self.post))


def test_it_looks_by_itself_until_the_run_is_over(tmp_path):  # law 29
    beside = Beside(tmp_path / "run.mcap")
    assert beside.word() == recording_process.RecordingBegun()
    table = Table(Segment.create("table", 1 << 18))
    entry = table.entry("X", Shape.parse("long"))
    beside.post.send(encode(BeginRecording(monotonic_ns())))
    beside.post.send(
        encode(AddVariables("flow0", (VariablePlace("X", "long", "", entry.offset),))), (table.segment.fd,)
    )
    table.ring("X").write((7).to_bytes(8, "little"))
    beside.post.send(encode(FinishRecording({"completed": "yes"})))
    assert beside.word() == recording_process.RecordingEnded(0, NOTHING)
    beside.close()
    reader = Reader(tmp_path / "run.mcap")
    assert RunRecord.read(reader) == run()
    assert [value for _, value in Series.all_of(reader)["flow0/X"].values()] == [7]
    assert reader.is_whole


def test_when_the_runtime_is_gone_it_writes_what_it_has_seen(tmp_path):  # R-X05: kill -9
    beside = Beside(tmp_path / "run.mcap")
    beside.word()
    beside.close()
    reader = Reader(tmp_path / "run.mcap")
    assert (RunRecord.read(reader), reader.is_whole) == (run(), False)


def test_poses_come_straight_from_whoever_steps_the_world_and_stand_at_their_own_times(tmp_path):  # law 29, K03
    beside = Beside(tmp_path / "run.mcap")
    beside.word()
    zero = monotonic_ns()
    beside.post.send(encode(BeginRecording(zero)))
    row = np.array([[1, 2, 3, 1, 0, 0, 0]], dtype=np.float32).tobytes()
    for at in (5, 40):
        beside.inlet.send(encode(WorldPoses("yard", 0, row, (), zero + at, left_out=at - 5)))
    beside.post.send(encode(FinishRecording({})))
    assert beside.word() == recording_process.RecordingEnded(0, NOTHING, 35)
    beside.close()
    reader = Reader(tmp_path / "run.mcap")
    assert [at for at, _ in reader.messages(topics.frames("yard"))] == [5, 40]
    assert reader.notes["end"]["untold"] == "35"


def test_a_file_that_cannot_take_any_more_is_told_with_its_reason(tmp_path):  # R-X05: a full disk
    (tmp_path / "full").symlink_to("/dev/full")
    beside = Beside(tmp_path / "full")
    assert "no space is left" in str(beside.word().reason)
    beside.close()
