import select
import signal
from pathlib import Path
from time import monotonic

import pytest

from kit.record.recording_builder import run
from onika.host.recording import recording_place
from onika.host.recording.recording_place import InProcessWriter, WriterProcess
from onika.host.recording.recording_sink import AddMessage, BeginRecording, FinishRecording
from onika.record import topics
from onika.record.reader import Reader

TELL = AddMessage(topics.EVENTS, 5, b'{"subsystem":"","event":{"type":"Done","flow":0,"index":0,"at_s":0.0}}')


def served(writer, is_enough):
    until = monotonic() + 20
    while not is_enough() and monotonic() < until:
        select.select(writer.readers(), [], [], 0.1)
        writer.serve()
    return is_enough()


def test_beside_the_clock_everything_is_written_at_once(tmp_path):  # law 29
    path = tmp_path / "run.mcap"
    writer = InProcessWriter(str(path), run())
    assert (writer.is_up, writer.is_done, list(writer.readers())) == (True, False, [])
    writer.take(TELL)
    writer.look(0)
    writer.serve()
    assert Reader(path).count(topics.EVENTS) == 1
    writer.take(FinishRecording({}))
    assert (writer.is_done, writer.missed, str(writer.reason)) == (True, 0, "")
    writer.close()
    assert Reader(path).is_whole


def test_a_full_disk_ends_a_recording_and_no_run():  # R-X05
    writer = InProcessWriter("/dev/null", run())
    writer._stream.close()  # what is written now fails as on a disk that is full, but for the exception
    writer._stream = Path("/dev/full").open("wb", buffering=0)  # noqa: SIM115
    writer._sink._stream = writer._sink._writer._stream = writer._stream
    writer.take(TELL)
    writer.look(10**12)
    assert "no space is left" in str(writer.reason)
    assert writer.is_done
    writer.close()


def test_a_process_writes_it_in_wall_time(tmp_path):  # law 29
    path = tmp_path / "run.mcap"
    writer = WriterProcess(str(path), run(), 4_000_000, with_fifo=False)
    assert served(writer, lambda: writer.is_up)
    writer.take(BeginRecording(0))
    writer.take(TELL)
    writer.take(FinishRecording({"completed": "yes"}))
    assert served(writer, lambda: writer.is_done)
    writer.close()
    assert (str(writer.reason), writer.untold) == ("", 0)
    assert list(Reader(path).messages(topics.EVENTS)) == [(5, TELL.body)]


def test_a_process_that_dies_is_noticed(tmp_path):  # R-X05
    writer = WriterProcess(str(tmp_path / "run.mcap"), run(), 4_000_000, with_fifo=False)
    writer._process.kill()
    assert served(writer, lambda: writer.is_done)
    assert "ended with code -9" in str(writer.reason)
    writer.close()


def test_a_process_that_is_frozen_is_ended_and_told_and_its_file_reads(tmp_path):  # R-X05
    path = tmp_path / "run.mcap"
    writer = WriterProcess(str(path), run(), 4_000_000, with_fifo=False)
    assert served(writer, lambda: writer.is_up)
    writer._process.send_signal(signal.SIGSTOP)
    assert served(writer, lambda: writer.is_done)
    assert str(writer.reason) == "the process that writes it was frozen, and has been ended"
    assert writer._process.returncode == -signal.SIGKILL
    writer.close()
    assert not Reader(path).is_whole


def test_where_too_much_waits_it_is_counted_and_left_out(tmp_path, monkeypatch):  # bounded, and told
    monkeypatch.setattr(recording_place, "_MOST_WAITING", 0)
    writer = WriterProcess(str(tmp_path / "run.mcap"), run(), 4_000_000, with_fifo=False)
    writer.take(TELL)
    writer.take(TELL)
    assert writer.untold == 2
    writer.close()


def test_a_file_that_cannot_be_made_is_an_error():
    with pytest.raises(OSError, match="No such file"):
        InProcessWriter("/nowhere/run.mcap", run())
    with pytest.raises(OSError, match="No such file"):
        WriterProcess("/nowhere/run.mcap", run(), 1, with_fifo=False)
