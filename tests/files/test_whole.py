import os
from pathlib import Path

import pytest

from onika.files import whole


def test_a_file_is_replaced_and_nothing_else_is_left(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"  # R-B07
    whole.write(path, "old")
    whole.write(path, "né")
    assert path.read_text("utf-8") == "né"
    assert list(tmp_path.iterdir()) == [path]


def test_an_existing_file_keeps_its_mode_and_a_new_one_follows_the_mask(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"
    path.touch(0o640)
    path.chmod(0o640)
    whole.write(path, "x")
    assert path.stat().st_mode & 0o777 == 0o640
    mask = os.umask(0o027)
    try:
        whole.write(tmp_path / "b.conf", "x")
    finally:
        os.umask(mask)
    assert (tmp_path / "b.conf").stat().st_mode & 0o777 == 0o640


def test_a_link_is_followed(tmp_path: Path) -> None:
    path, link = tmp_path / "a.conf", tmp_path / "link.conf"
    path.write_text("old")
    link.symlink_to(path)
    whole.write(link, "new")
    assert link.is_symlink()
    assert path.read_text() == "new"


@pytest.mark.parametrize("failing", ["fsync", "write", "rename"])
def test_a_failure_leaves_the_old_file_and_no_other(
    failing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.conf"  # R-B07
    path.write_text("old")

    def fail(*_: object) -> None:
        raise OSError(28, "No space left on device")

    if failing == "rename":
        monkeypatch.setattr(Path, "replace", fail)
    elif failing == "fsync":
        monkeypatch.setattr(os, "fsync", fail)
    else:
        monkeypatch.setattr(os, "fchmod", fail)
    with pytest.raises(OSError, match="No space"):
        whole.write(path, "new")
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_text_that_is_no_utf_8_changes_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"
    path.write_text("old")
    with pytest.raises(UnicodeEncodeError):
        whole.write(path, "\ud800")
    assert path.read_text() == "old"
