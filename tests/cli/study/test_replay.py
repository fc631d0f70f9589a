import json

import pytest

from onika.cli import main
from onika.files.state import session_log


def logged(path, *acts):
    """A log of a session that did these acts."""
    records = [{"start": {"bases": [{"name": "lab", "files": {}}]}}, *({"act": each, "by": 0} for each in acts)]
    lines = [
        session_log.line((f"{n}.0", "x", "none", "0", "none", "0", "root"), json.dumps({"s": "a", "n": n, **record}))
        for n, record in enumerate(records)
    ]
    path.write_text("\n".join([session_log.HEADER, *lines]) + "\n")
    return path


NEW = {"t": "NewApplication"}
SAVE = {"t": "Save", "doc": "a1", "name": "mine", "base": "{base0}"}


def test_a_session_is_replayed_at_once_into_a_folder(tmp_path, capsys):  # R-H08
    log = logged(tmp_path / "s.log", NEW, SAVE)
    (tmp_path / "lab").mkdir()
    out = tmp_path / "out"
    assert main(["study", "replay", str(log), "--no-page", "--base", str(tmp_path / "lab"), "--to", str(out)]) == 0
    assert (out / "base0" / "lab" / "appl" / "mine.appl").is_file()
    assert "3 of 3 lines replayed, 0 that" in capsys.readouterr().out
    assert not (tmp_path / "lab" / "appl").exists()


def test_what_could_not_be_done_is_said_with_its_line(tmp_path, capsys):  # R-H08
    log = logged(tmp_path / "s.log", SAVE)
    assert main(["study", "replay", str(log), "--no-page"]) == 1
    assert "s.log:3: expected x to be done as it was" in capsys.readouterr().err


def test_what_is_left_of_a_log_whose_head_was_cut_off_is_replayed(tmp_path, capsys):  # R-H08
    log = logged(tmp_path / "s.log", NEW, SAVE)
    lines = log.read_text().splitlines()
    log.write_text("\n".join(lines[2:]))
    (tmp_path / "lab").mkdir()
    out = tmp_path / "out"
    assert main(["study", "replay", str(log), "--no-page", "--base", str(tmp_path / "lab"), "--to", str(out)]) == 1
    assert (out / "base0" / "lab" / "appl" / "mine.appl").is_file()
    assert "s.log:1: expected the line with which the session began" in capsys.readouterr().err


@pytest.mark.parametrize("text", ["", "nonsense", "770909683\tnew_appl\tnone\t0\tnone\t0\tappl\n", "\x00\xff"])
def test_what_is_no_log_of_a_session_is_refused(tmp_path, capsys, text):  # R-H08
    (tmp_path / "s.log").write_text(text)
    assert main(["study", "replay", str(tmp_path / "s.log"), "--no-page"]) == 2
    assert "expected the log of a session" in capsys.readouterr().err


def test_a_file_that_is_none_and_a_folder_with_files_are_refused(tmp_path, capsys):  # R-H08
    log = logged(tmp_path / "s.log", NEW)
    assert main(["study", "replay", str(log), "--no-page", "--to", str(tmp_path)]) == 2
    assert main(["study", "replay", str(tmp_path / "gone.log"), "--no-page"]) == 2
    assert "expected a new or empty directory" in capsys.readouterr().err
