"""Applications without any robot: files of a folder are gathered and compared (K10)."""

import json
import os

import pytest

from onika.cli import main

pytestmark = pytest.mark.site


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A home with downloads and pictures of its own."""
    monkeypatch.setenv("HOME", str(tmp_path))
    for name, content in {
        "Downloads/new.jpg": b"new",
        "Downloads/ñandú.PNG": b"bird",
        "Downloads/old.jpg": b"old",
        "Downloads/notes.txt": b"notes",
        "Pictures/one.jpg": b"the same",
        "Pictures/other.jpg": b"the same",
        "Pictures/third.jpg": b"not equal",
    }.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(content)
    os.utime(tmp_path / "Downloads/old.jpg", (0, 0))
    return tmp_path


def run(capsys, *words):
    code = main(["run", *words, "--virtual", "--json"])
    return code, json.loads(capsys.readouterr().out.splitlines()[-1])


def test_new_pictures_are_gathered_and_the_rest_is_left(capsys, home):  # R-K10, R-A19
    code, result = run(capsys, "gather_pictures", "--expect", "COPIED == 2")
    assert (code, result["state"]) == (0, "completed")
    assert sorted(path.name for path in (home / "Pictures/new").iterdir()) == ["new.jpg", "ñandú.PNG"]
    assert len(list((home / "Downloads").iterdir())) == 4


def test_what_is_there_twice_is_listed(capsys, home):  # R-K10, R-A19
    code, result = run(capsys, "find_twins")
    assert (code, result["state"]) == (0, "completed")
    rows = (home / "files.csv").read_text().splitlines()
    assert [row.split(",")[0] for row in rows] == ["name", "one.jpg", "other.jpg"]


def test_a_folder_that_is_not_there_is_told_before_anything_is_done(capsys, home):  # R-K10, R-B07
    (home / "Downloads").rename(home / "elsewhere")
    code, result = run(capsys, "gather_pictures")
    assert (code != 0, result["state"]) == (True, "aborted")
    assert "Downloads" in json.dumps(result)
    assert not (home / "Pictures/new").exists()
