"""The audit trail as it is written: a line for each command and each change of holder, never taken back (X12).

A line is with the system as soon as it is noted, so that it outlives the runtime; what weighs (a stop, a change of
holder, code) is brought to the disk at once by a thread of its own, for a slow disk must not keep the runtime.
"""

import contextlib
import fcntl
import os
from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from pathlib import Path
from threading import Event, Lock, Thread

from onika.files.state.state_directory import make_own
from onika.files.trail import head_of, line, torn_hash, usual_path
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

OFF = "off"
"""In place of a file: there is to be no trail."""
LIMIT = 4 * 1024 * 1024
"""Bytes of a file before the next one begins."""
KEPT = 8
"""Older files that are kept."""
_TAIL = 64 * 1024
_LONGEST = 400
_SAME = 32
"""How many runtimes of one user write trails of their own beside each other."""


def open_for(named: str) -> "AuditTrail":
    """The trail in this file; where none is named the usual one, or one beside it. Raises OSError."""
    try:
        if named:
            return AuditTrail(Path(named))
        return open_free(usual_path(os.environ))
    except BlockingIOError:
        raise OSError(Reason.of("store.audit_taken", path=named)) from None


def open_free(path: Path) -> "AuditTrail":
    """The trail at a path, or beside it (`audit-2.log`) where another runtime writes it; raises OSError."""
    for number in range(1, _SAME):
        try:
            return AuditTrail(_numbered(path, number))
        except BlockingIOError:
            continue
    return AuditTrail(_numbered(path, _SAME))


def _numbered(path: Path, number: int) -> Path:
    return path if number == 1 else path.with_stem(f"{path.stem}-{number}")


class AuditTrail:
    """One file, written by one runtime at a time; raises BlockingIOError where another one writes it, and OSError."""

    def __init__(
        self,
        path: Path,
        clock: Callable[[], datetime] = lambda: datetime.now(UTC),
        limit: int = LIMIT,
        kept: int = KEPT,
    ) -> None:
        self.path = path
        self.head = ""
        self.trouble = NOTHING
        """Why a line could not be written, as long as that is so."""
        self._clock = clock
        self._limit, self._kept = limit, kept
        make_own(path.parent)
        self._lock = os.open(path.with_name(f".{path.name}.lock"), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            self._file, self._size = _open(path)
        except OSError:
            os.close(self._lock)
            raise
        self._torn = self._go_on()
        self._mutex, self._wanted, self._is_over = Lock(), Event(), False
        self._keeper = Thread(target=self._keep, name="audit", daemon=True)
        self._keeper.start()

    def note(self, what: str, weighs: bool = False, **about: object) -> None:
        """Write a line; with `weighs` it goes to the disk at once. It never raises and never waits for the disk."""
        try:
            if self._size >= self._limit:
                self._next_file()
            self._write(what, about)
            self.trouble = NOTHING
        except OSError as wrong:
            self.trouble = system_reason(wrong)
        if weighs:
            self._wanted.set()

    def close(self) -> None:
        """Bring everything to the disk and let go."""
        self._is_over = True
        self._wanted.set()
        self._keeper.join()
        os.close(self._file)
        os.close(self._lock)

    def _go_on(self) -> bytes:
        """Find the head of what is there, and what a crash has torn."""
        if not self._size:
            return b""
        self.head, torn = head_of(os.pread(self._file, _TAIL, max(0, self._size - _TAIL)))
        if torn and not torn.endswith(b"\n"):
            self._size += os.write(self._file, b"\n")
        return torn

    def _write(self, what: str, about: Mapping[str, object]) -> None:
        at = self._clock().isoformat(timespec="milliseconds")
        record: dict[str, object] = {"at": at, "what": _short(what)}
        record |= {key: _short(one) if isinstance(one, str) else one for key, one in about.items() if one}
        if not self._size:
            record["before"] = self.head
        if self._torn:
            record["torn"] = torn_hash(self._torn)
        text, head = line(self.head, record)
        written = os.write(self._file, text)
        self._size += written
        if written < len(text):  # the disk is full: what is there is a torn line, as after a crash
            self._torn = text[:written]
            self._size += os.write(self._file, b"\n")
            raise OSError(Reason.of("store.audit_no_room"))
        self.head, self._torn = head, b""

    def _next_file(self) -> None:
        """The file becomes `FILE.1`, those before it move on, and the oldest is no more."""
        with self._mutex:
            os.fdatasync(self._file)
            for number in range(self._kept, 0, -1):
                older = self.path if number == 1 else self.path.with_name(f"{self.path.name}.{number - 1}")
                with contextlib.suppress(FileNotFoundError):
                    older.replace(self.path.with_name(f"{self.path.name}.{number}"))
            former = self._file
            self._file, self._size = _open(self.path)
            os.close(former)

    def _keep(self) -> None:
        """In a thread of its own: bring what is written to the disk whenever that is wanted."""
        while not self._is_over:
            self._wanted.wait()
            self._wanted.clear()
            with self._mutex, contextlib.suppress(OSError):
                os.fdatasync(self._file)


def _open(path: Path) -> tuple[int, int]:
    """The file to add to, and its size."""
    file = os.open(path, os.O_RDWR | os.O_APPEND | os.O_CREAT | os.O_CLOEXEC, 0o600)
    return file, os.fstat(file).st_size


def _short(text: str) -> str:
    if len(text) <= _LONGEST:
        return text
    return text[: _LONGEST - 1] + "…"
