"""A library: all tasks of a base directory, read at once, with the faults of the rest (requirement C01, §5.2.1)."""

from collections.abc import Iterable, Mapping, Set
from dataclasses import dataclass, field, replace
from pathlib import Path

from onika.files import text
from onika.files.rmod import RmodText
from onika.store.base_directory import BaseDirectory
from onika.store.module_catalogue import Catalogue, reopen_catalogues
from onika.store.opened_text import Faults
from onika.store.shipped import is_shipped
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

Found = tuple[RmodText | None, Faults]
"""What one file gave."""


@dataclass(frozen=True, slots=True)
class Library:
    """The tasks of one base directory by name, in order, with everything there is to tell of its files."""

    base: BaseDirectory
    tasks: Mapping[str, RmodText]
    faults: Faults
    """Notes among them; of a file that is left out there is at least one that is none."""
    records: Mapping[str, Found] = field(default_factory=dict)
    """What every file gave that was read, also where that is no task, by the names of the files."""
    modules: frozenset[str] = frozenset()
    """The modules whose code lies here."""
    catalogues: Mapping[str, Catalogue] = field(default_factory=dict)
    """What modules here say in other languages, by their names."""
    hidden: frozenset[str] = frozenset()
    """The names of tasks here before which those of earlier libraries stand."""
    is_shipped: bool = False

    @property
    def left_out(self) -> tuple[str, ...]:
        """The files and folders that gave no task for a fault, in order."""
        return tuple(sorted({fault.place.file for fault in self.faults if not fault.is_note}))


def open_libraries(bases: Iterable[BaseDirectory]) -> tuple[Library, ...]:
    """The libraries of a search path, in order; a task whose name an earlier one has is noted and not added."""
    return reopen_libraries(bases, (), frozenset())


def reopen_libraries(
    bases: Iterable[BaseDirectory], former: Iterable[Library], changed: Set[Path]
) -> tuple[Library, ...]:
    """The libraries of a search path, of which some were open; of their files only those in `changed` are read again.

    What is as it was is the same object.
    """
    former_by_base = {library.base: library for library in former}
    owners: dict[str, BaseDirectory] = {}
    opened = []
    for base in bases:
        tasks = base.tasks
        names = [name for name in tasks if owners.setdefault(name, base) is base]
        hidden = [name for name in tasks if owners[name] is not base]
        faults = [_again(base, name, owners[name]) for name in hidden if not _is_copied(base, owners[name])]
        before = former_by_base.get(base)
        library = replace(_open(base, names, faults, before, changed), hidden=frozenset(hidden))
        opened.append(before if before == library else library)
    return tuple(opened)


def open_library(base: BaseDirectory) -> Library:
    """The library of one base directory."""
    return _open(base, base.tasks, [], None, frozenset())


def _open(
    base: BaseDirectory, names: Iterable[str], faults: list[Fault], former: Library | None, changed: Set[Path]
) -> Library:
    former_records = former.records if former else {}
    read = {name: _read(base, name, former_records.get(name), changed) for name in names}
    tasks = {name: record for name, (record, _) in read.items() if record is not None}
    faults += [*base.unreadable, *(fault for fault in base.misnamed if Path(fault.place.file).parent.name == "module")]
    faults += [fault for _, faults_of_task in read.values() for fault in faults_of_task]
    faults += _alike(base, tasks)
    catalogues = reopen_catalogues(base, former.catalogues if former else {}, changed)
    modules, comes_with_onika = frozenset(base.modules), is_shipped(base.path)
    return Library(base, tasks, tuple(sorted(faults)), read, modules, catalogues, is_shipped=comes_with_onika)


def _read(base: BaseDirectory, name: str, former_record: Found | None, changed: Set[Path]) -> Found:
    """A file, or what is known of it where it has not changed."""
    if former_record is None:
        return base.task(name)
    file = base.task_file(name)
    if file not in changed or (former_record[0] is not None and text.load(file, str(file))[0] == former_record[0].text):
        return former_record
    return base.task(name)


def _is_copied(base: BaseDirectory, owner: BaseDirectory) -> bool:
    """Whether what stands before a file is the user's own and the file a shipped one: that is meant."""
    return is_shipped(base.path) and not is_shipped(owner.path)


def _again(base: BaseDirectory, name: str, owner: BaseDirectory) -> Fault:
    path = str(owner.path / "module")
    return Fault(
        Place(str(base.task_file(name))),
        Reason.of("store.name_twice", name=name, path=path),
        Reason.of("words.first_used"),
        is_note=True,
    )


def _alike(base: BaseDirectory, names: Iterable[str]) -> list[Fault]:
    """Names that are one on a disk that does not tell small letters from large ones."""
    first: dict[str, str] = {}
    return [
        Fault(
            Place(str(base.task_file(name))),
            Reason.of("store.names_alike", name=name, first=first[name.lower()]),
            Reason.of("store.both_used"),
            is_note=True,
        )
        for name in names
        if first.setdefault(name.lower(), name) != name
    ]
