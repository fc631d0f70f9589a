from types import SimpleNamespace

import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.runs import recording
from onika.wire import act, request
from onika.words.reason import Reason


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def begun(play):
    return play.carried(request.Begin)[-1]


def test_a_recorded_run_is_written_to_a_file_of_its_own(play, tmp_path):  # R-X05
    doc = play.open([job("aC")])
    play.do(act.Run(doc, is_recorded=True))
    path = begun(play).record
    assert path.startswith(str(tmp_path / "state" / "recordings" / "play-")) and path.endswith(".mcap")
    assert play.view.recording == path
    assert (tmp_path / "state" / "recordings").is_dir()


def test_nothing_is_recorded_that_nobody_asked_for(play):  # R-X05
    play.run(play.open([job("aC")]))
    assert (begun(play).record, play.view.recording) == ("", "")


def test_once_it_is_over_the_size_of_its_file_is_told(play, tmp_path):  # R-X05
    play.do(act.Run(play.open([job("aC")]), is_recorded=True))
    assert play.view.recorded_bytes == 0
    (tmp_path / play.view.recording).write_bytes(b"x" * 321)
    play.end()
    assert play.view.recorded_bytes == 321


def test_the_file_of_a_run_whose_runtime_died_is_told_too(play, tmp_path):  # R-E10
    play.do(act.Run(play.open([job("aC")]), is_recorded=True))
    (tmp_path / play.view.recording).write_bytes(b"x" * 99)
    play.lose("it was killed")
    assert play.view.recorded_bytes == 99


def test_a_file_that_somebody_took_away_is_none(play):
    play.do(act.Run(play.open([job("aC")]), is_recorded=True))
    play.end()
    assert play.view.recorded_bytes == 0


def test_where_nothing_can_be_written_it_is_told_before_and_can_run_without(play, tmp_path):  # R-X05, R-X01
    (tmp_path / "state").write_text("a file where a folder is wanted")
    doc = play.open([job("aC")])
    no = play.no(act.Run(doc, is_recorded=True))
    assert "nothing can be written" in str(no.reason) and play.carried_out == []
    (remedy,) = no.remedies
    assert (str(remedy.label), remedy.act) == ("Run without recording", act.Run(doc))
    play.do(remedy.act)
    assert play.view.state == "running"


def test_a_disk_that_is_nearly_full_is_told_before(play, monkeypatch):  # R-X05
    monkeypatch.setattr(recording.shutil, "disk_usage", lambda _: SimpleNamespace(free=7_000_000))
    assert "room for 7 MB" in str(play.no(act.Run(play.open([job("aC")]), is_recorded=True)).reason)


def test_a_runtime_that_somebody_else_started_records_nothing_for_us(play):  # R-X05
    play.do(act.Connect(play.new("c"), url="ws://there"))
    no = play.no(act.Run(play.open([job("aC")]), is_recorded=True))
    assert "ws://there" in str(no.reason) and not no.remedies[0].act.is_recorded


def test_a_recording_that_the_runtime_cannot_make_is_offered_to_be_left_out(play):  # R-X05
    doc = play.open([job("aC")])
    play.rebuffs = {request.Begin: request.Refused(Reason.of("host.no_recording", why="the disk is gone"))}
    no = play.answer(act.Run(doc, is_recorded=True)).no
    assert str(no.reason) == "the run cannot be recorded: the disk is gone"
    assert no.remedies[0].act == act.Run(doc) and play.environment.tree.run is None
