"""Meshes that a page draws, kept in the state directory by the name of their content: made once, and never changed."""

import gzip
import os
import re
import tempfile
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path

from onika.files.state.state_directory import make_own

MOST_BYTES = 256 * 2**20
"""What all of them may take together; beyond it those that were asked for longest ago go."""

_FOLDER, _ENDING = "meshes", ".gz"
_NAME = re.compile(r"[0-9a-f]{32}", re.ASCII)


class MeshFolder:
    """The folder within a state directory; it need not be there yet."""

    def __init__(self, state: Path) -> None:
        self._path = state / _FOLDER

    def packed(self, name: str) -> bytes | None:
        """A mesh as gzip packs it; None where there is none of this name."""
        if not _NAME.fullmatch(name):
            return None
        path = self._path / (name + _ENDING)
        try:
            content = path.read_bytes()
            os.utime(path)
        except OSError:
            return None
        return content

    def lacking(self, names: Iterable[str]) -> list[str]:
        """Those that are not there, in order; what cannot be a name is left out."""
        proper = (name for name in names if _NAME.fullmatch(name))
        return [name for name in proper if not (self._path / (name + _ENDING)).is_file()]

    def there(self, names: Iterable[str]) -> list[str]:
        """Those that are there, in order."""
        return [name for name in names if _NAME.fullmatch(name) and (self._path / (name + _ENDING)).is_file()]

    def keep(self, meshes: Mapping[str, bytes], most_bytes: int = MOST_BYTES) -> None:
        """Write these, each whole or not at all, for the user's eyes only; raises OSError."""
        make_own(self._path)
        for name, content in meshes.items():
            descriptor, unfinished = tempfile.mkstemp(".unfinished", dir=self._path)
            try:
                with os.fdopen(descriptor, "wb") as file:
                    file.write(gzip.compress(content, 6, mtime=0))
                Path(unfinished).replace(self._path / (name + _ENDING))
            except BaseException:
                Path(unfinished).unlink(missing_ok=True)
                raise
        self._rotate(most_bytes)

    def _rotate(self, most_bytes: int) -> None:
        dated = []
        for path in self._path.glob(f"*{_ENDING}"):
            with suppress(OSError):  # somebody else has thrown it away
                status = path.stat()
                dated.append((status.st_mtime_ns, status.st_size, path))
        size = 0
        for _, one, path in sorted(dated, reverse=True):
            size += one
            if size > most_bytes:
                path.unlink(missing_ok=True)
