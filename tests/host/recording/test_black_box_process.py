import threading
from time import monotonic_ns

import numpy as np
import pytest

from kit.process.next_message import next_message
from kit.record.recording_builder import run
from onika.desk.run.run_review import Review
from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording import black_box_process
from onika.host.recording.black_box_orders import (
    CloseBlackBox,
    DescribeBlackBox,
    KeepBlackBox,
    OpenBlackBox,
    RunOrder,
    decode_word,
    encode,
    encode_run,
)
from onika.host.recording.last_seconds import TracedVariables
from onika.host.recording.recorded_variable import places_of
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.words.shape import Shape

WORDS = {"completed": "no", "cause": "it fell", "hash": "", "outside": ""}


class Beside:
    """The process's loop in a thread, on the other end of a post, with a run whose variable is written."""

    def __init__(self, path, monkeypatch):
        monkeypatch.setattr("signal.alarm", lambda _seconds: 0)  # it is for a process
        self.post, theirs = ProcessSocket.pair()
        self.far = ProcessSocket(theirs)
        self.thread = threading.Thread(target=black_box_process.hold, args=(self.far,))
        self.thread.start()
        body = encode_run(run())
        memory = Segment.create("run", len(body))
        memory.view[:] = body
        self.post.send(encode(RunOrder(1, OpenBlackBox(1, str(path), monotonic_ns(), 2_000_000))), (memory.fd,))
        memory.close()
        self.table = Table(Segment.create("test", 1 << 20))
        self.table.entry("X", Shape.parse("double"))
        met = TracedVariables("flow0", places_of(self.table, 0, {}))
        self.post.send(encode(RunOrder(1, met)), (self.table.segment.fd,))
        for number in range(5):
            self.table.ring("X").write(np.array([number], dtype=float).tobytes())

    def say(self, order):
        self.post.send(encode(RunOrder(1, order)))

    def word(self):
        return decode_word(next_message(self.post))

    def close(self):
        self.post.close()
        self.thread.join(10)
        self.far.close()
        assert not self.thread.is_alive()


@pytest.fixture
def path(tmp_path):
    return tmp_path / "boxes" / "a.mcap"


@pytest.fixture
def beside(path, monkeypatch):
    beside = Beside(path, monkeypatch)
    yield beside
    beside.close()


def last_of(path):
    with Review(path) as review:
        return review.ending["cause"], review.series["flow0/X"].at(1 << 62)


def test_a_run_that_ended_badly_is_written(beside, path):  # R-X05
    beside.say(CloseBlackBox(1, True, WORDS))
    assert not beside.word().reason
    assert last_of(path) == ("it fell", 4.0)


def test_a_run_that_ended_well_is_forgotten(beside, path):  # R-X05
    beside.say(CloseBlackBox(1, False, WORDS))
    beside.close()
    assert not path.exists()


def test_a_runtime_that_is_gone_leaves_its_runs_written(beside, path):  # R-X05
    beside.close()
    assert last_of(path) == ("the runtime program has died", 4.0)


def test_what_has_become_of_it_is_written(beside, path):  # R-X05
    body = encode_run(run(seed=8))
    memory = Segment.create("run", len(body))
    memory.view[:] = body
    beside.post.send(encode(RunOrder(1, DescribeBlackBox(1))), (memory.fd,))
    memory.close()
    beside.say(CloseBlackBox(1, True, WORDS))
    assert not beside.word().reason
    with Review(path) as review:
        assert review.run.begin.seed == 8


def test_an_end_that_nobody_could_be_answered_before_is_carried_out_all_the_same(beside, path, tmp_path):  # R-X05
    fault = tmp_path / "boxes" / "a.1.mcap"
    beside.say(KeepBlackBox(1, str(fault), WORDS))
    beside.say(CloseBlackBox(1, False, {}))
    beside.close()
    assert fault.exists()
    assert not path.exists()
