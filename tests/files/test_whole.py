import os
import resource
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from onika.files import whole
from onika.files.whole import ABSENT, ANYTHING
from onika.words.fault import Refusal


def refused(path: Path, text: str, expected: str) -> str:
    """The reason of a refusal, after which the directory is as it was."""
    before = {item: item.read_bytes() for item in path.parent.iterdir() if item.is_file()}
    write = whole.write(path, text, expected)
    assert isinstance(write, Refusal)
    assert {item: item.read_bytes() for item in path.parent.iterdir() if item.is_file()} == before
    return str(write.reason)


def test_a_file_is_replaced_and_nothing_else_is_left(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"  # R-B07
    first = whole.write(path, "old", ABSENT)
    assert first == whole.stamp("old")
    assert whole.write(path, "né", first) == whole.stamp("né")
    assert whole.read(path) == (("né", whole.stamp("né")), ())
    assert list(tmp_path.iterdir()) == [path]


def test_what_cannot_be_read_has_no_stamp(tmp_path: Path) -> None:
    result, (fault,) = whole.read(tmp_path / "a.conf")
    assert (result, str(fault.reason)) == (None, "expected a file that can be read, found No such file or directory")


def test_what_someone_else_changed_is_not_overwritten_and_it_is_said_whose_it_is(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"  # R-B07
    path.write_text("theirs")
    os.utime(path, (1e9, 1e9))
    reason = refused(path, "mine", whole.stamp("as I read it"))
    assert reason.startswith(f"{path} has changed since it was read, written 2001-09-09 01:46:40 UTC and owned by ")
    assert "is there already" in refused(path, "mine", ABSENT)
    path.unlink()
    assert "was removed since it was read" in refused(path, "mine", whole.stamp("theirs"))


def test_an_explicit_overwriting_replaces_whatever_is_there(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"
    path.write_text("theirs")
    assert whole.write(path, "mine", ANYTHING) == whole.stamp("mine")
    path.unlink()
    assert whole.write(path, "mine", ANYTHING) == whole.stamp("mine")
    assert path.read_text() == "mine"


def test_of_two_who_read_the_same_one_saves_and_the_other_is_told(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"  # R-B07
    path.write_text("0")
    results: list[list[bool]] = [[] for _ in range(4)]
    barrier = threading.Barrier(4)

    def save(mine: list[bool], number: int) -> None:
        for turn in range(25):
            barrier.wait()
            result, _ = whole.read(path)
            barrier.wait()
            assert result
            mine.append(not isinstance(whole.write(path, f"{turn} {number}", result[1]), Refusal))

    threads = [threading.Thread(target=save, args=(mine, number)) for number, mine in enumerate(results)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [sum(turn) for turn in zip(*results, strict=True)] == [1] * 25
    assert list(tmp_path.iterdir()) == [path]


def test_an_existing_file_keeps_its_mode_and_owner_and_a_new_one_follows_the_mask(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"
    path.touch()
    path.chmod(0o640)
    if os.geteuid() == 0:
        os.chown(path, 1234, 1234)
    whole.write(path, "x", ANYTHING)
    assert path.stat().st_mode & 0o7777 == 0o640
    assert path.stat().st_uid == (1234 if os.geteuid() == 0 else os.getuid())
    mask = os.umask(0o027)
    try:
        whole.write(tmp_path / "b.conf", "x", ABSENT)
    finally:
        os.umask(mask)
    assert (tmp_path / "b.conf").stat().st_mode & 0o777 == 0o640


def test_a_link_is_followed_and_stays(tmp_path: Path) -> None:
    path, link = tmp_path / "a.conf", tmp_path / "link.conf"
    path.write_text("old")
    link.symlink_to(path)
    whole.write(link, "new", whole.stamp("old"))
    assert link.is_symlink()
    assert path.read_text() == "new"


def test_links_to_nowhere_and_to_themselves(tmp_path: Path) -> None:
    path, link, loop = tmp_path / "a.conf", tmp_path / "link.conf", tmp_path / "loop.conf"
    link.symlink_to(path)
    assert whole.write(link, "new", ABSENT) == whole.stamp("new")
    assert path.read_text() == "new"
    loop.symlink_to(loop)
    assert isinstance(whole.write(loop, "new", ANYTHING), Refusal)
    assert loop.is_symlink()


@pytest.mark.parametrize("expected", [ABSENT, ANYTHING])
def test_what_is_no_plain_file_is_not_replaced(tmp_path: Path, expected: str) -> None:
    path = tmp_path / "a.conf"
    os.mkfifo(path)
    assert "is no plain file" in refused(path, "x", expected)
    path.unlink()
    path.mkdir()
    assert "is no plain file" in refused(path, "x", expected)


@pytest.mark.parametrize("failing", ["fsync", "fchmod", "rename", "open"])
def test_a_failure_leaves_the_old_file_and_no_other(
    failing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.conf"  # R-B07
    path.write_text("old")
    works = os.open

    def fail(*given: object, **_: object) -> None:
        raise OSError(28, "No space left on device")

    def fail_new(name: str, flags: int, *rest: int, **at: int) -> int:
        return fail() or 0 if flags & os.O_CREAT else works(name, flags, *rest, **at)

    monkeypatch.setattr(os, failing, fail_new if failing == "open" else fail)
    assert refused(path, "new", ANYTHING) == f"{path} cannot be saved: no space is left on that disk"
    assert path.read_text() == "old"


def test_what_a_killed_process_left_is_removed(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"  # R-B07
    (tmp_path / ".a.conf.saving").write_text("half")
    (tmp_path / ".b.conf.saving").symlink_to("/dev/null")
    whole.write(path, "new", ABSENT)
    whole.write(tmp_path / "b.conf", "new", ABSENT)
    assert sorted(item.name for item in tmp_path.iterdir()) == ["a.conf", "b.conf"]


def test_a_file_longer_than_the_system_allows_leaves_the_old_one(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"  # R-B07
    path.write_text("old")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    code = (
        "import resource, sys; from pathlib import Path; from onika.files import whole\n"
        f"resource.setrlimit(resource.RLIMIT_FSIZE, (8192, {before[1]}))\n"
        "print(whole.write(Path(sys.argv[1]), 'x' * 100_000, '*'))"
    )
    ran = subprocess.run([sys.executable, "-c", code, str(path)], capture_output=True, text=True, check=True)
    assert ran.stdout.startswith(f"{path} cannot be saved: the file would be larger")
    assert (path.read_text(), list(tmp_path.iterdir())) == ("old", [path])


def test_a_missing_directory_is_a_refusal(tmp_path: Path) -> None:
    write = whole.write(tmp_path / "none" / "a.conf", "x", ABSENT)
    assert isinstance(write, Refusal)
    assert "No such file or directory" in str(write.reason)


def test_text_that_is_no_utf_8_changes_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.conf"
    path.write_text("old")
    with pytest.raises(UnicodeEncodeError):
        whole.write(path, "\ud800", ANYTHING)
    assert path.read_text() == "old"
