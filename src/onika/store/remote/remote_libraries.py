"""The libraries of others that a base directory uses: they come, are trusted, renewed and go (F03, F06, X16).

Nothing that is fetched is run by any of this, and nothing is used before its signer was trusted and what its tasks
write was agreed to.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from datetime import date

from onika.files.library_index import LibraryIndex
from onika.files.library_lock import LockedLibrary
from onika.store.remote.checkout import Checkout, Faults
from onika.store.remote.index_check import SignedIndex, opened, overdue, refusal
from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.library_changes import LibraryChanges, changes, locked_as
from onika.store.remote.lock_file import LockFile
from onika.store.remote.own_changes import bases_after
from onika.words.fault import Refusal
from onika.words.reason import Reason
from onika.words.system_error import system_reason


@dataclass(frozen=True, slots=True)
class Offer:
    """A library as its place has it now, whose signature is good; nobody has trusted its signer by that."""

    address: str
    found: SignedIndex
    content: bytes
    """The signed bytes."""

    @property
    def index(self) -> LibraryIndex:
        """What it offers."""
        return self.found.index


@dataclass(frozen=True, slots=True)
class NewerVersion:
    """What would follow a locked library, and what is new in it."""

    offer: Offer
    changes: LibraryChanges


@dataclass(frozen=True, slots=True)
class RemoteLibraries:
    """Those of one lock. Used by one thread at a time; two programs that write a lock do not overwrite each other."""

    lock: LockFile
    access: LibraryAccess

    def listed(self) -> tuple[tuple[LockedLibrary, ...], Faults]:
        """The libraries that are locked."""
        return self.lock.libraries()

    def find(self, name: str) -> LockedLibrary | None:
        """The locked library of this name."""
        return next((library for library in self.lock.libraries()[0] if library.name == name), None)

    def checkout(self, library: LockedLibrary) -> Checkout:
        """Its files."""
        return Checkout(self.lock.base, library, self.access.cache)

    def offer(self, address: str, today: date) -> Offer | Reason:
        """Look at a library; nothing is kept of it."""
        content = self.access.index(address)
        if isinstance(content, Reason):
            return content
        found = opened(content)
        if isinstance(found, Reason):
            return found
        return overdue(found.index, today) or Offer(address, found, content)

    def add(self, offer: Offer, trusted: str) -> LockedLibrary | Refusal:
        """Use a library whose signer the user trusts (`trusted`: since when, who) and whose tasks may do what they say.

        Refused where a library of that name is used already: from elsewhere it is another one.
        """
        known = self.find(offer.index.name)
        if known is not None:
            return Refusal(Reason.of("store.library_known", library=known.name, address=known.address))
        library = locked_as(offer.found, offer.address, trusted)
        return self._kept(library, offer.content)

    def renewal(self, library: LockedLibrary, today: date) -> NewerVersion | Reason:
        """What its place offers now; a reason where that may not follow what is locked."""
        content = self.access.index(library.address)
        if isinstance(content, Reason):
            return content
        found = opened(content)
        if isinstance(found, Reason):
            return found
        why_not = refusal(found, library, today)
        if why_not:
            return why_not
        return NewerVersion(Offer(library.address, found, content), changes(library, found.index))

    def renew(self, library: LockedLibrary, renewal: NewerVersion) -> LockedLibrary | Refusal:
        """Use the newer version; whoever asks for it has agreed to what its tasks write.

        Of files before which own copies stand it is kept with what these were begun.
        """
        newer = locked_as(renewal.offer.found, library.address, library.trusted)
        newer = replace(newer, has_all_rights=library.has_all_rights)
        now = ((path, file.digest) for path, file in newer.files.items())
        try:
            bases = bases_after(self.checkout(library), now)
        except OSError as error:
            return self._not_kept(error)
        return self._kept(replace(newer, bases=bases), renewal.offer.content)

    def begun_with(
        self, library: LockedLibrary, bases: Mapping[str, str], contents: Iterable[bytes]
    ) -> LockedLibrary | Refusal:
        """Have own copies, by paths, count as begun with these contents, which have these SHA-256."""
        try:
            self.access.cache.put_all(contents)
        except OSError as error:
            return self._not_kept(error)
        return self._saved(replace(library, bases={**library.bases, **bases}))

    def trust(self, library: LockedLibrary, signer: str, trusted: str) -> LockedLibrary | Refusal:
        """Trust another key from now on: what it signs may follow; what is locked stays as it is."""
        return self._saved(replace(library, signer=signer, trusted=trusted, next_key=""))

    def give_rights(self, library: LockedLibrary, *, has_all_rights: bool) -> LockedLibrary | Refusal:
        """Let its code do what its user may, or compute only; what runs already goes on as it was begun."""
        return self._saved(replace(library, has_all_rights=has_all_rights))

    def remove(self, name: str) -> Refusal | None:
        """Use a library no longer."""
        former, faults = self.lock.opened()
        libraries = former.libraries if former else ()
        library = next((library for library in libraries if library.name == name), None)
        if library is None:
            return Refusal(faults[0].reason if faults else Reason.of("store.library_unknown", library=name))
        left = tuple(other for other in libraries if other is not library)
        refused = self.lock.saved(left, former)
        if refused is None:
            self.checkout(library).remove()
        return refused

    def fetch(self, library: LockedLibrary) -> Reason:
        """Have all its files here, for work without a network; why not, where that is not possible."""
        missing = self.access.pinned_index(library.address, library.index)
        if missing:
            return missing
        checkout = self.checkout(library)
        index = checkout.index()
        failed = self.access.bring(library.address, checkout.lacking(), None if isinstance(index, Reason) else index)
        checkout.put_right()
        return failed

    def _kept(self, library: LockedLibrary, content: bytes) -> LockedLibrary | Refusal:
        try:
            self.access.cache.put(content)
        except OSError as error:
            return self._not_kept(error)
        return self._saved(library)

    def _not_kept(self, error: OSError) -> Refusal:
        folder = str(self.access.cache.folder)
        return Refusal(Reason.of("files.not_savable", path=folder, why=system_reason(error)))

    def _saved(self, library: LockedLibrary) -> LockedLibrary | Refusal:
        former, faults = self.lock.opened()
        if faults:
            return Refusal(faults[0].reason)
        others = tuple(other for other in (former.libraries if former else ()) if other.name != library.name)
        refused = self.lock.saved((*others, library), former)
        if refused is not None:
            return refused
        self.checkout(library).put_right()
        return library
