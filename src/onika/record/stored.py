"""The bytes of a file that another program may overwrite or cut at the same time.

It is read and not mapped: where a mapped file becomes shorter, whoever looks at it is killed.
"""

import os
import stat
import weakref
from pathlib import Path


class StoredFile:
    """Raises OSError where it cannot be read, ValueError where it is no file; may be read in several threads."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file = os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK)  # a pipe without a writer would wait
        self._close = weakref.finalize(self, os.close, self._file)
        about = os.fstat(self._file)
        if not stat.S_ISREG(about.st_mode):
            kind = "a folder" if stat.S_ISDIR(about.st_mode) else "a pipe or a device"
            raise ValueError(f"{path}: expected a file, found {kind}")
        self.size = about.st_size
        """When it was opened."""

    def read(self, at: int, size: int) -> bytes:
        """So many bytes from there; raises ValueError where they are not there any more."""
        if not self._close.alive:
            raise ValueError(f"{self._path}: it is closed")
        data = os.pread(self._file, size, at)
        if len(data) != size:
            raise ValueError(f"{self._path}: expected {size} bytes at {at}, found {len(data)}: it was written over")
        return data

    def close(self) -> None:
        """Give it back."""
        self._close()
