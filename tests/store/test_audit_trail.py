import os
from datetime import UTC, datetime

import pytest

from onika.files.trail import older, read
from onika.store.audit_trail import AuditTrail, open_for, open_free


@pytest.fixture
def path(tmp_path):
    return tmp_path / "audit" / "audit.log"


def records(path):
    trail = read(older(path))
    assert trail.faults == []
    return [record["what"] for record in trail.records]


def test_a_line_is_in_the_file_as_soon_as_it_is_noted(path):  # R-X12
    audit = AuditTrail(path, clock=lambda: datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC))
    audit.note("Stop", True, who="ann#2", result="done", about="")
    trail = read([path])
    assert trail.records == [
        {"at": "2026-01-02T03:04:05.000+00:00", "what": "Stop", "who": "ann#2", "result": "done", "before": ""}
    ]
    assert trail.head == audit.head
    audit.close()


def test_only_its_user_can_read_it(path):  # R-X12
    AuditTrail(path).close()
    assert path.stat().st_mode & 0o077 == 0
    assert path.parent.stat().st_mode & 0o077 == 0


def test_the_next_runtime_goes_on_with_the_chain(path):  # R-X12
    for number in range(3):
        audit = AuditTrail(path)
        audit.note(f"run {number}")
        audit.close()
    assert records(path) == ["run 0", "run 1", "run 2"]


@pytest.mark.parametrize("left", [1, 64, 66, 90])
def test_after_a_crash_in_the_midst_of_a_line_it_goes_on(path, left):  # R-X12, network.md F12
    audit = AuditTrail(path)
    for what in ("one", "two", "three"):
        audit.note(what)
    audit.close()
    data = path.read_bytes()
    last = data.rindex(b"\n", 0, -1) + 1
    path.write_bytes(data[: last + left])
    audit = AuditTrail(path)
    audit.note("four")
    audit.note("five")
    audit.close()
    assert records(path) == ["one", "two", "four", "five"]
    assert len(read([path]).notes) == 1


def test_it_is_bounded_and_the_chain_goes_on_through_all_its_files(path):  # R-X12
    audit = AuditTrail(path, limit=1000, kept=3)
    for number in range(100):
        audit.note(f"deed {number}")
    audit.close()
    files = older(path)
    assert [file.name for file in files] == ["audit.log.3", "audit.log.2", "audit.log.1", "audit.log"]
    assert sum(file.stat().st_size for file in files) < 4 * 1300
    entries = records(path)
    assert entries == [f"deed {number}" for number in range(100 - len(entries), 100)]
    assert read(files).begins


def test_long_words_are_cut(path):
    audit = AuditTrail(path)
    audit.note("Stop", about="x" * 10_000)
    audit.close()
    assert path.stat().st_size < 1000


def test_two_runtimes_never_write_one_file(path):  # R-X12
    first, second = open_free(path), open_free(path)
    assert (first.path.name, second.path.name) == ("audit.log", "audit-2.log")
    with pytest.raises(OSError, match="another runtime writes"):
        open_for(str(path))
    for trail in (first, second):
        trail.close()
    open_for(str(path)).close()


def test_where_it_cannot_lie_is_told(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError):
        AuditTrail(tmp_path / "file" / "audit.log")


class FullDisk:
    """`os.write` of a disk that has room for so many bytes of a line."""

    def __init__(self, room):
        self.room = room
        self.write = os.write

    def __call__(self, file, data):
        if self.room is None or data == b"\n":
            return self.write(file, data)
        if not self.room:
            raise OSError(28, "No space left on device")
        return self.write(file, data[: self.room])


@pytest.mark.parametrize("room", [0, 20])
def test_a_full_disk_is_told_and_survived(path, monkeypatch, room):  # R-X12, network.md F11
    disk = FullDisk(None)
    monkeypatch.setattr("onika.store.audit_trail.os.write", disk)
    audit = AuditTrail(path)
    audit.note("one")
    disk.room = room
    audit.note("two", True)
    assert audit.trouble
    disk.room = None
    audit.note("three")
    assert not audit.trouble
    audit.close()
    assert records(path) == ["one", "three"]
