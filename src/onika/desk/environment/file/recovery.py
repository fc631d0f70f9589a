"""What was not saved when an environment ended by force: kept in a folder of each, taken over when that one is dead.

Below the state directory every environment has a folder of its own under `recovery/`, with a lock that the system lets
go when its process ends. Whoever gets the lock of another folder takes over what is in it.
"""

import fcntl
import os
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.file import recovery_record as records
from onika.desk.environment.file.autosave import UnsavedChange
from onika.desk.environment.file.recovery_record import RecoveryRecord, application_of, document_of, rescue_of
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.files import appl, text, whole
from onika.files.state.state_directory import make_own
from onika.wire import page
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason, reason_of

_LOCK = ".lock"
_ENDING = ".json"
_UNREADABLE = ".broken"
_MOST_UNREADABLE = 20


class Recovery:
    """The folder of this environment; raises OSError where there can be none."""

    def __init__(self, state: Path) -> None:
        self._all = state / "recovery"
        make_own(self._all)
        with _alone(self._all):
            self.folder = Path(tempfile.mkdtemp(dir=self._all))
            self._lock = _held(self.folder)
        self._taken: dict[Path, int] = {}

    def recovered(self) -> tuple[RecoveryRecord, ...]:
        """What those left that are dead; it stays on the disk until it is kept here by `carry_out`, or let go."""
        with _alone(self._all):
            for folder in sorted(path for path in self._all.iterdir() if path.is_dir() and path != self.folder):
                lock = _held(folder) if folder not in self._taken else None
                if lock is not None:
                    self._taken[folder] = lock
        return tuple(record for folder in self._taken for record in _read(folder))

    def carry_out(self, changes: Sequence[UnsavedChange]) -> Reason:
        """Write and remove files; why not, if so. May take as long as a disk does."""
        for change in changes:
            path = self.folder / f"{change.doc}{_ENDING}"
            if change.document is None:
                path.unlink(missing_ok=True)
                continue
            done = whole.write(path, records.write(rescue_of(change.document)), whole.ANYTHING)
            if isinstance(done, Refusal):
                return done.reason
        if changes:
            self._let_go()
        return NOTHING

    def leave(self, *, keeps: bool = False) -> None:
        """At the end: nothing is kept, or `keeps` what is not saved for the next time."""
        if not keeps:
            self._let_go()
        if not keeps or not any(self.folder.glob(f"*{_ENDING}")):
            shutil.rmtree(self.folder, ignore_errors=True)
        for lock in (self._lock, *self._taken.values()):
            if lock is not None:
                os.close(lock)
        self._lock, self._taken = None, {}

    def _let_go(self) -> None:
        """What was taken over is kept here now, or was not wanted."""
        for folder, lock in self._taken.items():
            shutil.rmtree(folder, ignore_errors=True)
            os.close(lock)
        self._taken = {}


def reopened(model: Model, recovered: Sequence[RecoveryRecord]) -> Done:
    """With the documents that were not saved, as unsaved as they were; each is told."""
    says = []
    for record in recovered:
        number = model.opened + 1
        names = {file.name for file in model.open_files}
        name = model.blank_name() if not record.path and record.name in names else ""
        try:
            document = _of(model, record, number, name)
        except ValueError as wrong:
            lost = Reason.of("run.not_had_back", name=record.name, why=reason_of(wrong))
            says.append(page.Say("warning", lost))
            continue
        model = replace(model.with_file(document), opened=number)
        sentence = Reason.of("run.had_back", name=document.name)
        says.append(page.Say("info", sentence, document.id))
    return Done(model, says=tuple(says))


def _of(model: Model, record: RecoveryRecord, number: int, name: str) -> Document | OpenApplication:
    """What was rescued, under the next id; raises ValueError."""
    if record.kind != appl.ENDING:
        return document_of(record, DocumentKind.CONFIGURATION.id(number), name)
    if model.syntax is None:
        raise ValueError(Reason.of("run.icon_types_missing"))
    return application_of(record, DocumentKind.APPLICATION.id(number), model.syntax, name)


def _read(folder: Path) -> Iterator[RecoveryRecord]:
    """What is in a folder; what cannot be read is put aside, and nobody looks at it again."""
    for path in sorted(folder.glob(f"*{_ENDING}")):
        content, _ = text.load(path, str(path))
        try:
            yield from records.read(content or "").every
        except ValueError:
            with suppress(OSError):
                path.rename(folder.parent / f"{folder.name}-{path.stem}{_UNREADABLE}")
                _forget_oldest(folder.parent)


def _forget_oldest(folder: Path) -> None:
    """Of what cannot be read only the newest is kept, for whoever wants to look why."""
    unreadable = sorted(folder.glob(f"*{_UNREADABLE}"), key=lambda path: (path.stat().st_mtime, path.name))
    for path in unreadable[:-_MOST_UNREADABLE]:
        path.unlink()


def _held(folder: Path) -> int | None:
    """The lock of a folder; None where another holds it, or the disk has no locks."""
    descriptor = os.open(folder / _LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(descriptor)
        return None
    return descriptor


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Nobody else makes or takes over a folder meanwhile; where the disk has no locks, without."""
    descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        with suppress(OSError):
            fcntl.flock(descriptor, fcntl.LOCK_EX)
        yield
    finally:
        os.close(descriptor)
