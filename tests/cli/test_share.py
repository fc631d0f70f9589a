import pytest

from kit.desk.film_reader import FilmReader
from kit.record.recording_builder import RecordingBuilder
from onika.cli import main, share


@pytest.fixture
def film(tmp_path, monkeypatch):
    """A recording in this folder, and a player that was built."""
    tape = RecordingBuilder(tmp_path / "film.mcap")
    tape.variable("X", "double", *((k / 100, k * k % 7.3) for k in range(1500)))
    tape.end(completed="yes")
    (tmp_path / "player.js").write_text("1")
    (tmp_path / "player.css").write_text("")
    monkeypatch.setattr(share, "PLAYER", tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return tmp_path / "film.mcap"


def test_a_recording_is_written_as_a_file_that_plays(film, tmp_path, capsys):  # R-X21
    assert main(["share", str(film)]) == 0
    assert capsys.readouterr().out == "film.html written, 0.0 MB\n"
    reader = FilmReader.of_page((tmp_path / "film.html").read_text())
    assert reader.head["variables"].keys() == {"flow0/X"}


def test_a_file_that_is_there_is_not_lost(film, tmp_path, capsys):  # R-E01
    (tmp_path / "run.html").write_text("dear")
    assert main(["share", str(film), "-o", "run.html"]) == 2
    assert "--overwrite" in capsys.readouterr().err
    assert (tmp_path / "run.html").read_text() == "dear"
    assert main(["share", str(film), "-o", "run.html", "--overwrite"]) == 0
    assert (tmp_path / "run.html").read_text() != "dear"


def test_what_becomes_too_large_is_coarser_and_says_so(film, tmp_path, capsys):  # R-X21: at most 5 MB
    assert main(["share", str(film)]) == 0
    assert "shows an instant every" not in capsys.readouterr().err
    limit = (tmp_path / "film.html").stat().st_size * 0.9e-6
    assert main(["share", str(film), "--limit", str(limit), "--overwrite"]) == 0
    assert (tmp_path / "film.html").stat().st_size <= limit * 1e6
    assert "shows an instant every" in capsys.readouterr().err
    assert main(["share", str(film), "--limit", "0.0001", "--overwrite"]) == 0
    assert "larger than 0.0001 MB" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["share", str(film), "--limit", "-1"])


def test_a_cut_recording_says_so(film, capsys):  # R-X21: bad input
    film.write_bytes(film.read_bytes()[:-9])
    assert main(["share", str(film)]) == 0
    assert "cut short" in capsys.readouterr().err


def test_what_cannot_be_read_or_written_is_said(film, tmp_path, capsys):  # R-E01
    assert main(["share", str(tmp_path / "none.mcap")]) == 2
    assert "none.mcap" in capsys.readouterr().err
    assert main(["share", str(film), "-o", str(tmp_path / "gone" / "run.html")]) == 2
    assert "run.html" in capsys.readouterr().err
