"""What `onika library` prints of libraries, as sentences."""

from collections.abc import Iterator
from pathlib import Path

from onika.files.library_index import KEY
from onika.files.library_lock import Agreement, LockedLibrary
from onika.store.remote.agreement import declared
from onika.store.remote.contents import LibraryEntry, contents
from onika.store.remote.library_changes import LibraryChanges
from onika.store.remote.publication import Publication
from onika.store.remote.remote_libraries import Offer
from onika.words.reason import Reason

_SHOWN = 20
"""Paths that are shown of each kind."""

_KINDS = {
    "task": Reason.of("cli.library_kind_task"),
    "configuration": Reason.of("cli.library_kind_configuration"),
    "icon": Reason.of("cli.library_kind_icon"),
    "application": Reason.of("cli.library_kind_application"),
    "world": Reason.of("cli.library_kind_world"),
}


def is_fingerprint(text: str) -> bool:
    """Whether a text is the fingerprint of a key."""
    return KEY.match(text) is not None


def published(done: Publication, folder: Path) -> Iterator[Reason]:
    """What was published where, and whose key others have to trust."""
    index = done.index
    yield Reason.of(
        "cli.library_published",
        library=index.name,
        version=index.version,
        folder=str(folder),
        files=len(index.files),
        bytes=done.packed,
        until=index.until.isoformat(),
    )
    yield Reason.of("cli.library_signer", signer=done.signer)
    if done.left_out:
        yield Reason.of("cli.library_left_out", paths=_some(done.left_out))


def offered(offer: Offer) -> Iterator[Reason]:
    """What a library is, who has signed it, and what its tasks write and touch."""
    index, found = offer.index, contents(offer.index)
    yield Reason.of("cli.library_offered", library=index.name, version=index.version, until=index.until.isoformat())
    if index.description:
        yield Reason.plain(index.description)
    counts = (sum(entry.kind == kind for entry in found) for kind in _KINDS)
    yield Reason.of("cli.library_counts", **dict(zip(_KINDS, counts, strict=True)))
    yield Reason.of("cli.library_signer", signer=offer.found.signer)
    every = declared(index).values()
    writes = frozenset[str]().union(*(agreement.writes for agreement in every))
    touches = frozenset[str]().union(*(agreement.touches for agreement in every))
    yield from _does(Agreement(writes, touches))
    yield Reason.of("cli.library_will_compute")


def rights(library: LockedLibrary) -> Reason:
    """What its code may do here."""
    key = "cli.library_has_rights" if library.has_all_rights else "cli.library_computes"
    return Reason.of(key, library=library.name)


def listed(library: LockedLibrary, lacking: int) -> Reason:
    """A library that is used."""
    return Reason.of(
        "cli.library_used_with_rights" if library.has_all_rights else "cli.library_used",
        library=library.name,
        version=library.version,
        until=library.until.isoformat(),
        address=library.address,
        signer=library.signer,
        trusted=library.trusted,
        lacking=lacking,
    )


def changed(name: str, changes: LibraryChanges) -> Iterator[Reason]:
    """What is new, and what tasks would write and touch further."""
    if changes.is_empty:
        yield Reason.of("cli.library_same", library=name, version=changes.version)
        return
    yield Reason.of("cli.library_renewed", library=name, former=changes.former, version=changes.version)
    if changes.added:
        yield Reason.of("cli.library_added_files", paths=_some(changes.added))
    if changes.altered:
        yield Reason.of("cli.library_altered_files", paths=_some(changes.altered))
    if changes.gone:
        yield Reason.of("cli.library_gone_files", paths=_some(changes.gone))
    for task, agreement in sorted((changes.further or {}).items()):
        names = tuple(sorted(agreement.writes | agreement.touches))
        yield Reason.of("cli.library_further", task=task, names=names)


def entry(shown: LibraryEntry) -> Reason:
    """One thing that is offered."""
    kind, name, says = _KINDS[shown.kind], shown.name, shown.description
    if shown.is_new:
        return Reason.of("cli.library_entry_new", kind=kind, name=name, says=says)
    return Reason.of("cli.library_entry", kind=kind, name=name, says=says)


def _does(agreement: Agreement) -> Iterator[Reason]:
    if agreement.writes:
        yield Reason.of("cli.library_writes", names=_some(tuple(sorted(agreement.writes))))
    if agreement.touches:
        yield Reason.of("cli.library_touches", names=_some(tuple(sorted(agreement.touches))))


def _some(names: tuple[str, ...]) -> tuple[str, ...]:
    """The first of them, and how many more there are."""
    more = len(names) - _SHOWN
    return (*names[:_SHOWN], f"(+{more})") if more > 0 else names
