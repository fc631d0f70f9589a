from kit.record.recording_builder import RecordingBuilder
from onika.desk.environment.lone_review import read_alone
from onika.store.site import open_site


def test_a_recording_is_looked_at_without_a_page(tmp_path):  # R-X21
    tape = RecordingBuilder(tmp_path / "film.mcap")
    tape.variable("X", "double", (0.0, 1.0), (1.0, 2.0))
    tape.end(completed="yes")
    looked_at = read_alone(tmp_path / "film.mcap", open_site([], {}, None))
    assert looked_at.subject.view.variables.keys() == {"flow0/X"}
    assert looked_at.tree.review.recording.path == str(tmp_path / "film.mcap")
    looked_at.subject.review.close()


def test_what_is_no_recording_is_said(tmp_path):  # R-X21: bad input
    (tmp_path / "film.mcap").write_text("no film")
    wrong = read_alone(tmp_path / "film.mcap", open_site([], {}, None))
    assert wrong.key == "desk.recording_unseen"
    assert "film.mcap" in str(wrong)
