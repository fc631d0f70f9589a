"""Several files of a directory that are replaced together: all of them, or none, also where the machine loses power.

What is to be is written into a hidden folder first, then a list of it; from then on it is carried out, if need be when
the site is served again.
"""

import shutil
from collections.abc import Mapping
from pathlib import Path

from msgspec import DecodeError, json

from onika.store.remote.object_cache import write_whole

_FOLDER = ".onika-change"
_LIST = "list"
_MODE = 0o644


class FileSet:
    """The files of one base directory. Used by one thread at a time; everything raises OSError."""

    def __init__(self, base: Path) -> None:
        self._base = base
        self._folder = base / _FOLDER

    def complete(self) -> None:
        """Carry out what was decided when the last program ended, and drop what was not."""
        try:
            paths = json.decode((self._folder / _LIST).read_bytes(), type=dict[str, bool])
        except (FileNotFoundError, DecodeError):
            paths = {}
        self._carry_out(paths)

    def replace(self, contents: Mapping[str, bytes | None]) -> None:
        """Have these files by their paths be so; None: not there."""
        self._drop()
        self._folder.mkdir(mode=0o700)
        for number, content in enumerate(contents.values()):
            if content is not None:
                write_whole(self._folder / str(number), content, mode=_MODE)
        listed = {path: content is not None for path, content in contents.items()}
        write_whole(self._folder / _LIST, json.encode(listed), mode=_MODE)
        self._carry_out(listed)

    def _carry_out(self, paths: Mapping[str, bool]) -> None:
        for number, (path, is_there) in enumerate(paths.items()):
            target, fresh = self._base / path, self._folder / str(number)
            if not is_there:
                target.unlink(missing_ok=True)
            elif fresh.exists():  # else it was put there already
                target.parent.mkdir(parents=True, exist_ok=True)
                fresh.replace(target)
        self._drop()

    def _drop(self) -> None:
        if self._folder.exists():
            (self._folder / _LIST).unlink(missing_ok=True)  # first, so that half of it is never carried out
            shutil.rmtree(self._folder)
