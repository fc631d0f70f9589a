"""Files that come with Onika, read once for all environments of the tests: each environment reads several hundred.

A reading is given again where the file is untouched and read in the same way; what stands elsewhere is read anew.
"""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from onika.store.opened_text import Faults, OpenedText, Read, open_file
from onika.store.shipped import shipped

_Opened = tuple[OpenedText[Any] | None, Faults]


class ShippedReadings:
    """In the place of `open_file`: called like it."""

    def __init__(self, open_anew: Callable[[Path, str, Read[Any]], _Opened] = open_file) -> None:
        self._open_anew = open_anew
        self._shipped = f"{shipped()}/"
        self._kept: dict[tuple[object, ...], _Opened] = {}

    def __call__(self, path: Path, name: str, read: Read[Any]) -> _Opened:
        """What `read` makes of the file."""
        if not str(path).startswith(self._shipped):
            return self._open_anew(path, name, read)
        key = (path, name, _stamp(path), *_manner(read))
        if key not in self._kept:
            self._kept[key] = self._open_anew(path, name, read)
        return self._kept[key]


def _stamp(path: Path) -> tuple[int, int] | None:
    """When it was written, and how long it is; None where it cannot be looked at."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size


def _manner(read: Read[Any]) -> tuple[object, ...]:
    """What is equal where a text is read in the same way."""
    return (read.func, *sorted(read.keywords.items())) if isinstance(read, partial) else (read,)
