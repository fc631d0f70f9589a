"""The lock of a base directory as a file: read when asked for, saved where it is still what was read."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from onika.files import library_lock, text as texts, whole
from onika.files.library_lock import LockedLibrary
from onika.store.remote.checkout import Faults
from onika.words.fault import Refusal
from onika.words.reason import Reason
from onika.words.system_error import system_reason


@dataclass(frozen=True, slots=True)
class OpenedLock:
    """What a lock says, and what stood in the file then."""

    libraries: tuple[LockedLibrary, ...]
    text: str


@dataclass(frozen=True, slots=True)
class LockFile:
    """The file `onika.lock` of a base directory, whether it is there already or not."""

    base: Path

    @property
    def path(self) -> Path:
        """Where it stands."""
        return self.base / library_lock.NAME

    def libraries(self) -> tuple[tuple[LockedLibrary, ...], Faults]:
        """The libraries of others that are used here; none where there is no lock, or it is at fault."""
        opened, faults = self.opened()
        return (opened.libraries if opened else ()), faults

    def opened(self) -> tuple[OpenedLock | None, Faults]:
        """The libraries, to be saved again; None where there is no lock, or it is at fault."""
        if not self.path.exists():
            return None, ()
        content, faults = texts.load(self.path, str(self.path))
        if content is None:
            return None, faults
        libraries, faults = library_lock.read(content, library_lock.NAME, str(self.path))
        return (None if libraries is None else OpenedLock(libraries, content)), faults

    def saved(self, libraries: Iterable[LockedLibrary], former: OpenedLock | None) -> Refusal | None:
        """Write the libraries in place of the former ones; refused where somebody else has written meanwhile."""
        expected = whole.ABSENT if former is None else whole.stamp(former.text)
        try:
            self.base.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            reason = Reason.of("files.not_savable", path=str(self.path), why=system_reason(error))
            return Refusal(reason, (whole.ELSEWHERE,))
        written = whole.write(self.path, library_lock.write(libraries), expected)
        return written if isinstance(written, Refusal) else None
