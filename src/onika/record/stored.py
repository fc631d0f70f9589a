"""The bytes of a file that another program may overwrite or cut at the same time.

It is read and not mapped: where a mapped file becomes shorter, whoever looks at it is killed.
"""

import os
import stat
import weakref
from pathlib import Path

from onika.words.reason import Reason


def unfit(path: Path, why: Reason) -> ValueError:
    """What is raised where a file is not what it has to be."""
    return ValueError(Reason.of("record.of_file", path=str(path), why=why))


class StoredFile:
    """Raises OSError where it cannot be read, ValueError where it is no file; may be read in several threads."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file = os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK)  # a pipe without a writer would wait
        self._close = weakref.finalize(self, os.close, self._file)
        about = os.fstat(self._file)
        if not stat.S_ISREG(about.st_mode):
            is_folder = stat.S_ISDIR(about.st_mode)
            kind = Reason.of("record.folder") if is_folder else Reason.of("record.pipe_or_device")
            raise unfit(path, Reason.of("record.no_file", given=kind))
        self.size = about.st_size
        """When it was opened."""

    def read(self, at: int, size: int) -> bytes:
        """So many bytes from there; raises ValueError where they are not there any more."""
        if not self._close.alive:
            raise unfit(self._path, Reason.of("record.it_is_closed"))
        is_inside = 0 <= at <= self.size and 0 <= size <= self.size - at
        data = os.pread(self._file, size, at) if is_inside else b""  # what is asked may come from the file itself
        if len(data) != size:
            given = Reason.of("record.written_over", count=len(data))
            raise unfit(self._path, Reason.of("record.too_few_bytes", size=size, at=at, given=given))
        return data

    def close(self) -> None:
        """Give it back."""
        self._close()
