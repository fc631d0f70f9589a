"""The lock of a base directory as a file: read when asked for, saved where it is still what was read."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from onika.files import library_lock
from onika.files.library_lock import LockedLibrary
from onika.store.opened_text import Faults, OpenedText, open_file, save
from onika.words.fault import Refusal


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
        return (opened.value if opened else ()), faults

    def opened(self) -> tuple[OpenedText[tuple[LockedLibrary, ...]] | None, Faults]:
        """The libraries, to be saved again; None where there is no lock, or it is at fault."""
        if not self.path.exists():
            return None, ()
        return open_file(self.path, library_lock.NAME, library_lock.read)

    def saved(
        self, libraries: Iterable[LockedLibrary], former: OpenedText[tuple[LockedLibrary, ...]] | None
    ) -> Refusal | None:
        """Write the libraries in place of the former ones; refused where somebody else has written meanwhile."""
        saved = save(self.path, tuple(libraries), library_lock.write, former, overwrites=False)
        return saved if isinstance(saved, Refusal) else None
