"""What a user's own copies of a library's files change in it, and with what each of them was begun (F03)."""

from collections.abc import Iterable
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from onika.files.library_index import LARGEST_FILE, is_path
from onika.files.library_lock import LockedLibrary
from onika.store.remote.checkout import Checkout
from onika.words.reason import Reason
from onika.words.system_error import system_reason


@dataclass(frozen=True, slots=True)
class OwnChange:
    """A file of the user's own that stands before one of a library, or is to be a new one there.

    base    the SHA-256 of what it was begun with; empty: there was none
    before  that itself; None where there was none, or it is no more to be had
    """

    path: str
    base: str
    content: bytes
    before: bytes | None = None


def own_changes(checkout: Checkout) -> tuple[OwnChange, ...]:
    """All own copies that are not what they were begun with, in the order of their paths."""
    paths = sorted({*checkout.locked.files, *checkout.locked.bases})
    changes = (own_change(checkout, path) for path in paths)
    return tuple(change for change in changes if isinstance(change, OwnChange))


def named_changes(checkout: Checkout, paths: Iterable[str]) -> tuple[OwnChange, ...] | Reason:
    """Those of these paths, new files among them; why not, where one of them is none."""
    changes = []
    for path in dict.fromkeys(paths):
        change = own_change(checkout, path)
        if isinstance(change, Reason):
            return change
        changes.append(change)
    return tuple(changes)


def own_change(checkout: Checkout, path: str) -> OwnChange | Reason:
    """What the user's own file of this path changes; why there is nothing of that."""
    if not is_path(path):
        return Reason.of("files.index_path", path=path[:200])
    own = checkout.base / path
    try:
        if not own.is_file():
            return Reason.of("store.no_own_file", path=str(own))
        if own.stat().st_size > LARGEST_FILE:
            return Reason.of("files.index_file_large", path=path, size=own.stat().st_size, most=LARGEST_FILE)
        content = own.read_bytes()
    except OSError as error:
        return Reason.of("store.not_fetched", path=str(own), why=system_reason(error))
    base = base_of(checkout.locked, path)
    if sha256(content).hexdigest() == base:
        return Reason.of("store.own_unchanged", path=str(own))
    return OwnChange(path, base, content, _before(checkout, path, base))


def base_of(library: LockedLibrary, path: str) -> str:
    """The SHA-256 of what an own copy was begun with; empty: of nothing."""
    locked = library.files.get(path)
    return library.bases.get(path, locked.digest if locked else "")


def bases_after(checkout: Checkout, files: Iterable[tuple[str, str]]) -> dict[str, str]:
    """What own copies were begun with, once the library has these files (path, SHA-256), where that is another.

    What they were begun with is kept, for only so can it be told later who has changed what. Raises OSError.
    """
    now = dict(files)
    bases = {}
    for path in {*checkout.locked.files, *checkout.locked.bases}:
        base = base_of(checkout.locked, path)
        if base != now.get(path, "") and (checkout.base / path).is_file():
            bases[path] = base
            before = _before(checkout, path, base)
            if before is not None:
                checkout.cache.put(before)
    return bases


def _before(checkout: Checkout, path: str, base: str) -> bytes | None:
    if not base:
        return None
    index = checkout.index()
    file = None if isinstance(index, Reason) else index.files.get(path)
    if file is not None and file.digest == base and file.content is not None:
        return file.content
    return checkout.cache.get(base)


def conflict_folder(base: Path, library: str, version: int) -> Path:
    """Where both versions of files lie that contradict each other; it is none of a base directory's folders."""
    return base / "conflicts" / f"{library}-{version}"
