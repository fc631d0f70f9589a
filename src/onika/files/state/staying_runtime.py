"""The runtime that stays on this machine for whoever comes again by ssh: where it listens, and whether it lives (A15).

It says so in a file of the state directory, which it keeps locked as long as it lives: a file that nobody locks is that
of a runtime that is gone.
"""

import fcntl
import os
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import IO

from msgspec import DecodeError, Struct, ValidationError, json

from onika.files.state.state_directory import make_own, state_directory


class StayingRuntime(Struct, frozen=True):
    """Where it listens on this machine, and its process id."""

    port: int
    process: int


def staying_path(environment: Mapping[str, str] = os.environ) -> Path:
    """Where the file lies."""
    return state_directory(environment) / "staying"


class StayingFile:
    """The file of the runtime that this process is; raises BlockingIOError where another one stays already."""

    def __init__(self, path: Path) -> None:
        make_own(path.parent)
        self._file: IO[bytes] = os.fdopen(os.open(path, os.O_RDWR | os.O_CREAT, 0o600), "rb+", buffering=0)
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            self._file.truncate()
        except OSError:
            self._file.close()
            raise

    def say(self, staying: StayingRuntime) -> None:
        """It can be reached now."""
        self._file.write(json.encode(staying) + b"\n")

    def close(self) -> None:
        """It does not stay any longer."""
        with suppress(OSError):
            self._file.truncate(0)
        self._file.close()


def staying_runtime(path: Path) -> StayingRuntime | None:
    """The runtime that stays and can be reached; None: none does. Raises OSError for a file that cannot be read."""
    try:
        file = path.open("rb")
    except FileNotFoundError:
        return None
    with file:
        if not _is_locked(file):
            return None
        text = file.read(4096)
    if not text.endswith(b"\n"):  # it is being written
        return None
    try:
        return json.decode(text, type=StayingRuntime)
    except (DecodeError, ValidationError):
        return None


def _is_locked(file: IO[bytes]) -> bool:
    try:
        fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    return False
