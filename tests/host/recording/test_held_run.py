from kit.record.recording_builder import run
from onika.desk.run.run_review import Review
from onika.host.recording.black_box_orders import OpenBlackBox
from onika.host.recording.held_run import HeldRun
from onika.words.reason import NOTHING

WORDS = {"completed": "no", "cause": "it fell", "hash": "", "outside": ""}


def test_what_is_held_is_written_where_it_was_said(tmp_path):  # R-X05
    path = tmp_path / "boxes" / "a.mcap"
    word = HeldRun(OpenBlackBox(4, str(path), 0, 1), run()).write(WORDS)
    assert (word.number, word.reason) == (4, NOTHING)
    with Review(path) as review:
        assert review.ending["cause"] == "it fell"


def test_why_it_cannot_be_written_is_told(tmp_path):  # R-X05, R-E01
    (tmp_path / "boxes").write_text("a file in the way")
    word = HeldRun(OpenBlackBox(4, str(tmp_path / "boxes" / "a.mcap"), 0, 1), run()).write(WORDS)
    assert str(word.reason)
