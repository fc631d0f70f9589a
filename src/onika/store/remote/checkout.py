"""A library of others as a base directory: its files below the cache, each as the lock names it (F03).

Whatever else stands there is removed, and what was altered is put right, whenever the search path is opened. Of code
that is not fetched yet there stands a file that says so, so that nobody takes another's module of that name for it.
"""

import os
import shutil
from collections.abc import Set
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from onika.files import rmod
from onika.files.library_index import IndexedFile, LibraryIndex
from onika.files.library_lock import Agreement, LockedFile, LockedLibrary
from onika.files.state.state_directory import make_own
from onika.store.remote.agreement import agreement_of, further, stays_within
from onika.store.remote.checkout_path import checkout_path
from onika.store.remote.index_check import reopened
from onika.store.remote.object_cache import ObjectCache, write_whole
from onika.store.remote.rights import put_word
from onika.words.fault import Fault, Place
from onika.words.reason import Reason
from onika.words.system_error import system_reason

_NOT_FETCHED = b"# This code is not fetched yet: onika library fetch "
_MODE = 0o400
_NOTHING = Agreement()

Faults = tuple[Fault, ...]


@dataclass(frozen=True, slots=True)
class Checkout:
    """Where a library that is locked in `base` stands as files.

    cache   all that was fetched
    """

    base: Path
    locked: LockedLibrary
    cache: ObjectCache

    @property
    def folder(self) -> Path:
        """The base directory; it bears the name of the library, and is of one lock only."""
        return checkout_path(self.cache.folder, self.base, self.locked.name)

    def index(self) -> LibraryIndex | Reason:
        """The index that is locked, from the cache."""
        content = self.cache.get(self.locked.index)
        if content is None and self.cache.is_altered(self.locked.index):
            return Reason.of("store.index_altered", library=self.locked.name)
        if content is None:
            return Reason.of("store.library_not_here", library=self.locked.name)
        found = reopened(content, self.locked)
        return found if isinstance(found, Reason) else found.index

    def put_right(self) -> Faults:
        """Have the files of the library there, and nothing else; what is at fault is left out and told."""
        index = self.index()
        if isinstance(index, Reason):
            with suppress(OSError):
                shutil.rmtree(self.folder)
            return (self._fault(index),)
        faults = []
        wanted = {}
        for path, file in index.files.items():
            fault = self._unlike(path, file)
            if fault is None:
                wanted[path] = file
            else:
                faults.append(fault)
        try:
            folder = self.folder
            put_word(folder, has_all_rights=self.locked.has_all_rights)
            make_own(folder)
            _prune(folder, wanted.keys())
            for path, file in wanted.items():
                if not self._put(folder / path, file) and self.cache.is_altered(file.digest):
                    faults.append(self._altered(path))
        except OSError as error:
            faults.append(self._fault(system_reason(error)))
        return tuple(faults)

    def altered(self) -> tuple[str, ...]:
        """The paths of files that were fetched, and that somebody has changed in the cache since."""
        return tuple(file.path for file in self.lacking() if self.cache.is_altered(file.digest))

    def lacking(self) -> tuple[IndexedFile, ...]:
        """The files that are not fetched yet, or no longer what was fetched."""
        index = self.index()
        if isinstance(index, Reason):
            return ()
        files = (file for file in index.files.values() if file.content is None)
        return tuple(file for file in files if self.cache.get(file.digest) is None)

    def remove(self) -> None:
        """Take the files away; what was fetched stays in the cache."""
        with suppress(OSError):
            put_word(self.folder, has_all_rights=False)
            shutil.rmtree(self.folder)

    def _unlike(self, path: str, file: IndexedFile) -> Fault | None:
        """Why a file is not used: the lock does not name it so, or its task writes more than was agreed to."""
        if self.locked.files.get(path) != LockedFile(file.digest, file.size):
            return self._left_out(path, Reason.of("store.not_as_locked", path=path))
        if not path.endswith(rmod.ENDING) or file.content is None:
            return None
        task = path.rpartition("/")[2].removesuffix(rmod.ENDING)
        if stays_within(file.content, self.locked.agreed.get(task, _NOTHING)):
            return None
        agreement = agreement_of(task, file.content)
        more = further(self.locked.agreed, {task: agreement} if agreement else {}).get(task)
        return None if more is None else self._left_out(path, undeclared(task, more))

    def _left_out(self, path: str, reason: Reason) -> Fault:
        return Fault(Place(str(self.folder / path)), reason, Reason.of("words.file_left_out"), is_note=True)

    def _altered(self, path: str) -> Fault:
        reason = Reason.of("store.kept_altered", path=path)
        instead = Reason.of("store.until_fetched", library=self.locked.name)
        return Fault(Place(str(self.folder / path)), reason, instead, is_note=True)

    def _put(self, target: Path, file: IndexedFile) -> bool:
        """Have a file there; whether it holds what it should, or what it should is not here."""
        content = file.content if file.content is not None else self.cache.get(file.digest)
        is_here = content is not None
        if content is None:
            if target.suffix != ".py":
                target.unlink(missing_ok=True)
                return False
            content = _NOT_FETCHED + self.locked.name.encode() + b"\n"
        try:
            is_there = not target.is_symlink() and target.read_bytes() == content
        except OSError:
            is_there = False
        if not is_there:
            write_whole(target, content, mode=_MODE, is_lasting=False)
        return is_here

    def _fault(self, reason: Reason) -> Fault:
        return Fault(Place(str(self.folder)), reason, Reason.of("words.left_out"), is_note=True)


def is_fetched(code: Path) -> bool:
    """Whether a file of code holds that code, and not only the word that it is to be fetched."""
    try:
        with code.open("rb") as file:
            return file.read(len(_NOT_FETCHED)) != _NOT_FETCHED
    except OSError:
        return True


def undeclared(task: str, more: Agreement) -> Reason:
    """That a task writes or touches what nobody has agreed to."""
    names = tuple(sorted(more.writes | more.touches))
    return Reason.of("store.writes_further", task=task, names=names)


def _prune(folder: Path, paths: Set[str]) -> None:
    """Remove whatever is none of these files; links are removed, never followed."""
    for parent, folders, files in os.walk(folder):
        for name in [*files, *(name for name in folders if Path(parent, name).is_symlink())]:
            path = Path(parent, name)
            if path.is_symlink() or path.relative_to(folder).as_posix() not in paths:
                path.unlink()
        for name in folders:
            path = Path(parent, name)
            if path.is_dir() and path.relative_to(folder).as_posix() in paths:
                shutil.rmtree(path)
