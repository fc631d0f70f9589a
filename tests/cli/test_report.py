import zipfile

import pytest

from kit.record.recording_builder import RecordingBuilder
from onika.cli import main
from onika.record.black_box_folder import black_boxes_in


@pytest.fixture
def film(tmp_path, monkeypatch):
    """A recording in this folder; nobody sits at the terminal."""
    tape = RecordingBuilder(tmp_path / "film.mcap")
    tape.variable("X", "double", (0.0, 1.0))
    tape.end(completed="no", cause="the hand met the table")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setattr("sys.stdin.isatty", lambda: False, raising=False)
    return tmp_path / "film.mcap"


def test_what_is_in_it_is_shown_before_anything_is_written(film, tmp_path, capsys):  # R-X21: report
    assert main(["report", str(film)]) == 1
    shown = capsys.readouterr()
    for name in ("why.txt", "machine.txt", "libraries.txt", "recording.mcap"):
        assert name in shown.out
    assert "nothing is written" in shown.err
    assert not (tmp_path / "film-report.zip").exists()


@pytest.mark.parametrize(("answer", "code"), [("y", 0), ("n", 1), ("", 1)])
def test_who_sits_there_is_asked(film, tmp_path, monkeypatch, answer, code):  # R-X21: report
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr("builtins.input", lambda _question: answer)
    assert main(["report", str(film)]) == code
    assert (tmp_path / "film-report.zip").exists() == (code == 0)


def test_who_sits_there_may_read_its_texts_before(film, tmp_path, monkeypatch, capsys):  # R-X21: report
    answers = iter(("v", "n"))
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    monkeypatch.setattr("builtins.input", lambda _question: next(answers))
    assert main(["report", str(film)]) == 1
    assert "the hand met the table" in capsys.readouterr().out
    assert not (tmp_path / "film-report.zip").exists()


def test_the_newest_black_box_is_what_is_reported(film, tmp_path, capsys):  # R-X21: report
    assert main(["report", "--yes"]) == 2
    assert "no black box yet" in capsys.readouterr().err
    folder = black_boxes_in(tmp_path / "state" / "onika")
    folder.mkdir(parents=True)
    film.rename(folder / "fall.mcap")
    assert main(["report", "--yes"]) == 0
    with zipfile.ZipFile(tmp_path / "fall-report.zip") as bundle:
        assert "the hand met the table" in bundle.read("why.txt").decode()


def test_a_file_that_is_there_is_not_lost(film, tmp_path, capsys):  # R-E01
    (tmp_path / "film-report.zip").write_text("dear")
    assert main(["report", str(film), "--yes"]) == 2
    assert (tmp_path / "film-report.zip").read_text() == "dear"
    assert main(["report", str(tmp_path / "none.mcap"), "--yes"]) == 2
    assert "none.mcap" in capsys.readouterr().err
