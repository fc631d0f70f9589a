import select
from pathlib import Path
from time import monotonic

import pytest

from kit.recording_builder import run
from onika.host.recording import recording_place
from onika.host.recording.recording_place import InProcessWriter, WriterProcess
from onika.host.recording.recording_sink import AddMessage, BeginRecording, FinishRecording
from onika.record import topics
from onika.record.reader import Reader

TELL = AddMessage(topics.EVENTS, 5, b'{"subsystem":"","event":{"type":"Done","flow":0,"index":0,"at_s":0.0}}')


def served(pen, is_enough):
    until = monotonic() + 20
    while not is_enough() and monotonic() < until:
        select.select(pen.readers(), [], [], 0.1)
        pen.serve()
    return is_enough()


def test_beside_the_clock_everything_is_written_at_once(tmp_path):  # law 29
    path = tmp_path / "run.mcap"
    pen = InProcessWriter(str(path), run())
    assert (pen.is_up, pen.is_done, list(pen.readers())) == (True, False, [])
    pen.take(TELL)
    pen.look(0)
    pen.serve()
    assert Reader(path).count(topics.EVENTS) == 1
    pen.take(FinishRecording({}))
    assert (pen.is_done, pen.missed, pen.reason) == (True, 0, "")
    pen.close()
    assert Reader(path).is_whole


def test_a_full_disk_ends_a_recording_and_no_run():  # R-X05
    pen = InProcessWriter("/dev/null", run())
    pen._stream.close()  # what is written now fails as on a disk that is full, but for the exception
    pen._stream = Path("/dev/full").open("wb", buffering=0)  # noqa: SIM115
    pen._sink._stream = pen._sink._writer._stream = pen._stream
    pen.take(TELL)
    pen.look(10**12)
    assert "No space left" in pen.reason
    assert pen.is_done
    pen.close()


def test_a_process_writes_it_in_wall_time(tmp_path):  # law 29
    path = tmp_path / "run.mcap"
    pen = WriterProcess(str(path), run(), 4_000_000, with_fifo=False)
    assert served(pen, lambda: pen.is_up)
    pen.take(BeginRecording(0))
    pen.take(TELL)
    pen.take(FinishRecording({"completed": "yes"}))
    assert served(pen, lambda: pen.is_done)
    pen.close()
    assert (pen.reason, pen.untold) == ("", 0)
    assert list(Reader(path).messages(topics.EVENTS)) == [(5, TELL.body)]


def test_a_process_that_dies_is_noticed(tmp_path):  # R-X05
    pen = WriterProcess(str(tmp_path / "run.mcap"), run(), 4_000_000, with_fifo=False)
    pen._process.kill()
    assert served(pen, lambda: pen.is_done)
    assert "ended with code -9" in pen.reason
    pen.close()


def test_where_too_much_waits_it_is_counted_and_left_out(tmp_path, monkeypatch):  # bounded, and told
    monkeypatch.setattr(recording_place, "_MOST_WAITING", 0)
    pen = WriterProcess(str(tmp_path / "run.mcap"), run(), 4_000_000, with_fifo=False)
    pen.take(TELL)
    pen.take(TELL)
    assert pen.untold == 2
    pen.close()


def test_a_file_that_cannot_be_made_is_an_error():
    with pytest.raises(OSError, match="No such file"):
        InProcessWriter("/nowhere/run.mcap", run())
    with pytest.raises(OSError, match="No such file"):
        WriterProcess("/nowhere/run.mcap", run(), 1, with_fifo=False)
