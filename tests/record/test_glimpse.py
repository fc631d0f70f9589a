import pytest

from kit.recording_builder import RecordingBuilder
from onika.record.glimpse import glimpse
from onika.record.reader import UNREADABLE


@pytest.fixture
def tape(tmp_path):
    recording = RecordingBuilder(tmp_path / "run.mcap")
    recording.variable("X", "double", (0.0, 1.0), (4.25, 2.0))
    return recording


def test_a_whole_recording_tells_what_it_is_at_its_ends(tape):  # R-X05
    tape.end()
    summary = glimpse(tape.path)
    assert (summary.took_s, summary.is_whole, summary.began) == (4.25, True, "2026-01-02T03:04:05+00:00")
    assert summary.application == tape.plan.application


def test_one_that_was_cut_short_tells_how_far_it_goes(tape):  # R-X05: kill -9
    tape.cut()
    assert (glimpse(tape.path).took_s, glimpse(tape.path).is_whole) == (4.25, False)


@pytest.mark.parametrize("keeps", [0, 5, 8, 12, 40, 200])
def test_what_is_none_is_refused(tape, keeps):
    tape.end()
    whole = tape.path.read_bytes()
    tape.path.write_bytes(whole[:keeps])
    with pytest.raises(UNREADABLE):
        glimpse(tape.path)
