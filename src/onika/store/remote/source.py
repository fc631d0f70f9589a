"""From where the files of a library come: a folder, or a server of the web."""

import os
import stat
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from onika.words.reason import Reason
from onika.words.system_error import system_reason

INDEX = "library"
"""What the signed index is called."""

OBJECTS = "objects"
"""The folder of all that is named by its SHA-256: code, and the indexes of former versions."""


@dataclass(frozen=True, slots=True)
class Wanted:
    """A file to be fetched; more bytes than `most` are refused."""

    path: str
    most: int


class LibrarySource(Protocol):
    """Gives files; what they hold is judged by who asks."""

    def fetch(self, wanted: Iterable[Wanted]) -> Mapping[str, bytes] | Reason:
        """All of these by their paths, or why one of them does not come."""
        ...

    def close(self) -> None:
        """No more is asked for."""
        ...


def object_path(digest: str) -> str:
    """The path of what has this SHA-256 in hexadecimal."""
    return f"{OBJECTS}/{digest}"


@dataclass(frozen=True, slots=True)
class FolderSource:
    """A library in a folder of this machine."""

    folder: Path

    def fetch(self, wanted: Iterable[Wanted]) -> Mapping[str, bytes] | Reason:
        """All of these, or why one of them cannot be read."""
        files: dict[str, bytes] = {}
        for file in wanted:
            try:
                content = _plain(self.folder / file.path, file.most)
            except OSError as error:
                return Reason.of("store.not_fetched", path=file.path, why=system_reason(error))
            if content is None:
                return Reason.of("store.answer_large", path=file.path, most=file.most)
            files[file.path] = content
        return files

    def close(self) -> None:
        """Nothing is open."""


def _plain(path: Path, most: int) -> bytes | None:
    """What a plain file holds; None where it is something else, or too much; a pipe is not waited for."""
    descriptor = os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK | os.O_NOCTTY)
    with os.fdopen(descriptor, "rb") as file:
        status = os.fstat(file.fileno())
        if not stat.S_ISREG(status.st_mode) or status.st_size > most:
            return None
        content = file.read(most + 1)
    return content if len(content) <= most else None
