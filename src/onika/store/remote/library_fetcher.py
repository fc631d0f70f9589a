"""Fetches what a program needs of libraries of others, all at once, before anything of it is read (F03)."""

from collections.abc import Iterable, Sequence, Set
from dataclasses import dataclass, field, replace
from pathlib import Path

from onika.files.library_index import IndexedFile
from onika.store.remote.checkout import Checkout, Faults, is_fetched
from onika.store.remote.checkout_path import is_checked_out
from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.lock_file import LockFile
from onika.store.remote.object_cache import ObjectCache
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason

_CODE = "module/"


@dataclass(frozen=True, slots=True)
class LibraryFetcher:
    """For the libraries of a search path."""

    checkouts: Sequence[Checkout]
    access: LibraryAccess
    brought: set[tuple[Path, frozenset[str]]] = field(default_factory=set, compare=False)
    """What was asked for and is here, so that a program that is read again and again looks once."""

    def bring(self, paths: Iterable[Path]) -> Faults:
        """Have these files here where they are of a library, with its models and nets; what does not come is told."""
        faults = []
        needed = tuple(paths)
        for checkout in self.checkouts:
            wanted = _within(checkout.folder, needed)
            if not wanted or (checkout.folder, wanted) in self.brought:
                continue
            lacking = [file for file in checkout.lacking() if _is_needed(file, wanted)]
            failed = self.access.bring(checkout.locked.address, lacking)
            if lacking:
                checkout.put_right()
            if not failed:
                self.brought.add((checkout.folder, wanted))
            else:
                place = Place(checkout.locked.address)
                faults.append(Fault(place, failed, Reason.of("store.used_as_is"), is_note=True))
        self.access.hang_up()
        return tuple(faults)


def unfetched(code: Iterable[Path]) -> Faults:
    """The files of code that are not here yet: nothing that needs them can be run."""
    return tuple(
        Fault(Place(str(path)), Reason.of("store.code_not_fetched", module=path.stem, library=_library(path)), NOT_RUN)
        for path in sorted(code)
        if is_checked_out(path) and not is_fetched(path)
    )


def checkouts_of(bases: Iterable[Path], cache: ObjectCache) -> tuple[tuple[Checkout, ...], Faults]:
    """The libraries that base directories lock, each once, with their files put right; and what is wrong with them."""
    checkouts: dict[str, Checkout] = {}
    faults: list[Fault] = []
    for base in bases:
        libraries, faults_of_lock = LockFile(base).libraries()
        faults += (replace(fault, is_note=True) for fault in faults_of_lock)  # what needs them says so itself
        for locked in libraries:
            checkout = Checkout(base, locked, cache)
            other = checkouts.setdefault(locked.name, checkout)
            if other is checkout:
                faults += checkout.put_right()
            elif other.locked.index != locked.index:
                reason = Reason.of("store.library_twice", library=locked.name, path=str(other.base))
                place = Place(str(LockFile(base).path))
                faults.append(Fault(place, reason, Reason.of("words.first_used"), is_note=True))
    return tuple(checkouts.values()), tuple(faults)


def _within(folder: Path, paths: Iterable[Path]) -> frozenset[str]:
    """Those of the paths that lie in a folder, as they are called there."""
    return frozenset(path.relative_to(folder).as_posix() for path in paths if path.is_relative_to(folder))


def _is_needed(file: IndexedFile, wanted: Set[str]) -> bool:
    return file.path in wanted or not file.path.startswith(_CODE)


def _library(path: Path) -> str:
    return path.parent.parent.name
