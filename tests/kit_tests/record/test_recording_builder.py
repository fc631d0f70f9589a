import pytest

from kit.record.recording_builder import RecordingBuilder
from onika.record.series import Series
from onika.wire import event


def test_a_tape_is_a_recording(tmp_path):  # R-X05
    tape = RecordingBuilder(tmp_path / "run.mcap")
    tape.variable("X", "double", (0.0, 1.0), (0.5, 2.0))
    tape.tell(0.25, event.Done(0, 0, 0.25))
    reader = tape.end(completed="yes")
    assert reader.is_whole
    assert Series.all_of(reader)["flow0/X"].at(600_000_000) == 2.0


def test_a_tape_that_is_cut_is_not_whole(tmp_path):
    assert not RecordingBuilder(tmp_path / "run.mcap").cut().is_whole
    with pytest.raises(FileNotFoundError):
        RecordingBuilder(tmp_path / "nowhere" / "run.mcap")
