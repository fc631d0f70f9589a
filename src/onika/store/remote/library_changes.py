"""What is new in a library: files that came, changed or went, and what its tasks write further."""

from collections.abc import Mapping
from dataclasses import dataclass

from onika.files.library_index import LibraryIndex
from onika.files.library_lock import Agreement, LockedFile, LockedLibrary
from onika.store.remote.agreement import declared, further
from onika.store.remote.index_check import SignedIndex


@dataclass(frozen=True, slots=True)
class LibraryChanges:
    """From what is locked to what is offered; the paths in order."""

    former: int
    """The version that is locked."""
    version: int
    added: tuple[str, ...] = ()
    altered: tuple[str, ...] = ()
    gone: tuple[str, ...] = ()
    further: Mapping[str, Agreement] | None = None
    """What tasks write and touch beyond what was agreed to; new ones, beyond what any task of it was allowed."""

    @property
    def is_empty(self) -> bool:
        """Whether nothing is new."""
        return not (self.added or self.altered or self.gone)


def changes(locked: LockedLibrary, index: LibraryIndex) -> LibraryChanges:
    """What an index has that the lock does not."""
    now = files_of(index)
    came = tuple(sorted(now.keys() - locked.files.keys()))
    went = tuple(sorted(locked.files.keys() - now.keys()))
    altered = tuple(sorted(path for path in now.keys() & locked.files.keys() if now[path] != locked.files[path]))
    tasks = declared(index)
    agreed = {**dict.fromkeys(tasks, _together(locked.agreed)), **locked.agreed}
    return LibraryChanges(locked.version, index.version, came, altered, went, further(agreed, tasks))


def _together(agreed: Mapping[str, Agreement]) -> Agreement:
    """What a task may write and touch that is new here: what the library's tasks were allowed, taken together."""
    of_all = agreed.values()
    return Agreement(
        frozenset(svar for agreement in of_all for svar in agreement.writes),
        frozenset(device for agreement in of_all for device in agreement.touches),
    )


def files_of(index: LibraryIndex) -> Mapping[str, LockedFile]:
    """The files of an index as a lock names them."""
    return {path: LockedFile(file.digest, file.size) for path, file in index.files.items()}


def locked_as(found: SignedIndex, address: str, trusted: str) -> LockedLibrary:
    """What a lock says of a library whose index was judged, and all of whose tasks were agreed to."""
    index = found.index
    return LockedLibrary(
        index.name,
        address,
        found.signer,
        trusted,
        index.version,
        found.digest,
        index.until,
        index.next_key,
        files_of(index),
        declared(index),
    )
