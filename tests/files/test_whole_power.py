"""Power is lost while a file is saved: whatever of the writes has reached the disk by then, the file is whole (F13).

A disk keeps what was written only from `fsync` on. Before, of a file's content any part may be there, and of a
directory's changes any beginning: a rename may have reached the disk, or not.
"""

import os

import pytest

from onika.files import whole
from onika.files.whole import ABSENT

OLD, NEW = "the old text\n" * 300, "the new text, which is longer\n" * 300


class FragileDisk:
    """Stands in place of `os`, and remembers after each step what a loss of power could leave under a name."""

    def __init__(self, folder, name):
        self._name = name
        self._content = {name: {OLD.encode()}} if (folder / name).exists() else {name: {None}}
        """By name, everything that may be read there after the power came back; None: no file."""
        self._fresh = {}
        """By descriptor, the name of a file that is being written."""
        self.after = []
        """After each step, what may stand under the name."""
        self._former = set()
        """What stood there before a rename that may not have reached the disk."""

    def __getattr__(self, name):
        return getattr(os, name)

    def open(self, path, flags, mode=0o777, *, dir_fd=None):
        descriptor = os.open(path, flags, mode, dir_fd=dir_fd)
        if flags & os.O_CREAT:
            self._fresh[descriptor] = path
            self._content[path] = {b"", NEW.encode()[:100], NEW.encode()}  # any part, as soon as it is written
            self._note()
        return descriptor

    def fsync(self, descriptor):
        os.fsync(descriptor)
        if descriptor in self._fresh:
            self._content[self._fresh[descriptor]] = {NEW.encode()}
        else:  # the directory
            self._content[self._name] -= self._former
        self._note()

    def rename(self, source, target, *, src_dir_fd, dst_dir_fd):
        os.rename(source, target, src_dir_fd=src_dir_fd, dst_dir_fd=dst_dir_fd)
        self._former = set(self._content[target])
        self._content[target] = self._former | self._content.pop(source)
        self._note()

    def _note(self):
        self.after.append(set(self._content[self._name]))


@pytest.mark.parametrize("is_there", [True, False])
def test_after_a_loss_of_power_a_file_is_the_old_one_or_the_new_one(tmp_path, monkeypatch, is_there):  # R-B07
    path = tmp_path / "a.conf"
    if is_there:
        path.write_text(OLD)
    disk = FragileDisk(tmp_path, path.name)
    monkeypatch.setattr(whole, "os", disk)
    written = whole.write(path, NEW, whole.stamp(OLD) if is_there else ABSENT)
    assert written == whole.stamp(NEW)
    former = OLD.encode() if is_there else None
    assert len(disk.after) == 4
    for content in disk.after:
        assert content <= {former, NEW.encode()}
    assert disk.after[-1] == {NEW.encode()}  # once it is told that it is saved, it is


def test_the_disk_that_is_played_finds_a_saving_that_leaves_out_a_sync(tmp_path, monkeypatch):
    path = tmp_path / "a.conf"
    path.write_text(OLD)
    disk = FragileDisk(tmp_path, path.name)
    monkeypatch.setattr(disk, "fsync", lambda descriptor: None, raising=False)
    monkeypatch.setattr(whole, "os", disk)
    whole.write(path, NEW, whole.stamp(OLD))
    assert b"" in disk.after[-1]
    assert OLD.encode() in disk.after[-1]
