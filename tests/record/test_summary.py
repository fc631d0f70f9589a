import pytest

from kit.record.recording_builder import RecordingBuilder
from onika.record.reader import UNREADABLE
from onika.record.summary import summary


@pytest.fixture
def tape(tmp_path):
    recording = RecordingBuilder(tmp_path / "run.mcap")
    recording.variable("X", "double", (0.0, 1.0), (4.25, 2.0))
    return recording


def test_a_whole_recording_tells_what_it_is_at_its_ends(tape):  # R-X05
    tape.end()
    whole = summary(tape.path)
    assert (whole.took_s, whole.is_whole, whole.began) == (4.25, True, "2026-01-02T03:04:05+00:00")
    assert whole.application == tape.plan.application


def test_of_a_black_box_it_tells_how_much_of_the_run_is_in_it(tmp_path):  # R-X05
    recording = RecordingBuilder(tmp_path / "box.mcap", held_s=(70.0, 100.0))
    recording.variable("X", "double", (70.0, 1.0), (100.0, 2.0))
    recording.end()
    box = summary(recording.path)
    assert (box.is_black_box, box.is_whole) == (True, True)
    assert (box.took_s, box.lasted_s) == pytest.approx((100.0, 30.0))


def test_a_recording_from_the_beginning_is_no_black_box_and_holds_all_of_its_run(tape):  # R-X05
    tape.end()
    whole = summary(tape.path)
    assert (whole.is_black_box, whole.lasted_s) == (False, 4.25)


def test_one_that_was_cut_short_tells_how_far_it_goes(tape):  # R-X05: kill -9
    tape.cut()
    assert (summary(tape.path).took_s, summary(tape.path).is_whole) == (4.25, False)


def test_one_that_was_cut_anywhere_behind_its_last_message_is_not_whole(tape):  # R-X05: kill -9, a full disk
    tape.end()
    whole = tape.path.read_bytes()
    note_at = whole.index(b"\x03\x00\x00\x00end")
    for size in range(note_at, len(whole)):
        tape.path.write_bytes(whole[:size])
        assert (summary(tape.path).took_s, summary(tape.path).is_whole) == (4.25, False)


@pytest.mark.parametrize("keeps", [0, 5, 8, 12, 40, 200])
def test_what_is_none_is_refused(tape, keeps):
    tape.end()
    whole = tape.path.read_bytes()
    tape.path.write_bytes(whole[:keeps])
    with pytest.raises(UNREADABLE):
        summary(tape.path)
