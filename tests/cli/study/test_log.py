import pytest

from onika.cli import main
from onika.files.state import session_log


@pytest.fixture
def diary(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    folder = tmp_path / "state" / "onika" / "diary"
    folder.mkdir(parents=True)

    def write(name, *places):
        words = ("0.0", "x", "none", "0", "none", "0", "root")
        lines = [session_log.line(words, f'{{"s":"{name[:4]}","n":{place}}}') for place in places]
        (folder / f"{name}.log").write_text("\n".join([session_log.HEADER, *lines]) + "\n")

    return write


def test_the_last_session_is_handed_over_as_one_file(diary, tmp_path, capsys):  # R-H01, R-H08
    diary("2025-01-01T00-00-00-9", 0)
    diary("2026-01-01T00-00-00-12", 0, 1)
    diary("2026-01-01T00-00-00-12-2", 2)
    diary("2026-01-01T00-00-00-12-10", 3)
    out = tmp_path / "p1.log"
    assert main(["study", "log", "-o", str(out)]) == 0
    lines, faults = session_log.read(out.read_text(), "p1.log")
    assert [line.place for line in lines] == [0, 1, 2, 3] and faults == ()
    assert out.read_text().count("time\tevent") == 1
    assert "4 lines of session 2026-01-01T00-00-00-12" in capsys.readouterr().out


def test_sessions_are_listed_and_one_is_chosen(diary, tmp_path, capsys):  # R-H01
    diary("2025-01-01T00-00-00-9", 0)
    diary("2026-01-01T00-00-00-12", 0, 1)
    assert main(["study", "log"]) == 0
    assert "2025-01-01T00-00-00-9  " in capsys.readouterr().out
    assert main(["study", "log", "2025-01-01T00-00-00-9", "-o", str(tmp_path / "p1.log")]) == 0
    assert "1 lines" in capsys.readouterr().out


def test_what_is_not_there_or_would_be_overwritten_is_refused(diary, tmp_path, capsys):  # R-H01
    assert main(["study", "log"]) == 0
    assert "no session has a diary" in capsys.readouterr().out
    assert main(["study", "log", "-o", str(tmp_path / "p1.log")]) == 1
    diary("2026-01-01T00-00-00-12", 0)
    (tmp_path / "p1.log").write_text("mine")
    assert main(["study", "log", "-o", str(tmp_path / "p1.log")]) == 1
    assert (tmp_path / "p1.log").read_text() == "mine"
    assert main(["study", "log", "-o", str(tmp_path / "p1.log"), "--overwrite"]) == 0
