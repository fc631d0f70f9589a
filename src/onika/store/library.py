"""A library: all tasks of a base directory, read at once; what is at fault is left out and told (C01, §5.2.1)."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from onika.files.rmod import RmodText
from onika.store.base_directory import BaseDirectory
from onika.store.opened import Faults
from onika.words.fault import Fault, Place


@dataclass(frozen=True, slots=True)
class Library:
    """The tasks of one base directory by name, in order, with everything there is to tell of its files."""

    base: BaseDirectory
    tasks: Mapping[str, RmodText]
    faults: Faults
    """Notes among them; of a file that is left out there is at least one that is none."""

    @property
    def left_out(self) -> tuple[str, ...]:
        """The files and folders that gave no task for a fault, in order."""
        return tuple(sorted({fault.place.file for fault in self.faults if not fault.is_note}))


def open_libraries(bases: Iterable[BaseDirectory]) -> tuple[Library, ...]:
    """The libraries of a search path, in order; a task whose name an earlier one has is noted and not added."""
    owners: dict[str, BaseDirectory] = {}
    opened = []
    for base in bases:
        names = [name for name in base.tasks if owners.setdefault(name, base) is base]
        faults = [_again(base, name, owners[name]) for name in base.tasks if owners[name] is not base]
        opened.append(_open(base, names, faults))
    return tuple(opened)


def open_library(base: BaseDirectory) -> Library:
    """The library of one base directory."""
    return _open(base, base.tasks, [])


def _open(base: BaseDirectory, names: Iterable[str], faults: list[Fault]) -> Library:
    tasks: dict[str, RmodText] = {}
    faults += [*base.unreadable, *(one for one in base.misnamed if Path(one.place.file).parent.name == "module")]
    for name in names:
        record, found = base.task(name)
        faults += found
        if record is not None:
            tasks[name] = record
    faults += _alike(base, tasks)
    return Library(base, tasks, tuple(sorted(faults)))


def _again(base: BaseDirectory, name: str, owner: BaseDirectory) -> Fault:
    found = f"it again, first in {owner.path / 'module'}"
    expected = f"the name {name} once on the search path"
    return Fault(Place(str(base.task_file(name))), expected, found, "the first one is used", is_note=True)


def _alike(base: BaseDirectory, names: Iterable[str]) -> list[Fault]:
    """Names that are one on a disk that does not tell small letters from large ones."""
    first: dict[str, str] = {}
    return [
        Fault(
            Place(str(base.task_file(name))),
            "names that differ in more than small and large letters",
            f"{name} beside {first[name.lower()]}",
            "both are used",
            is_note=True,
        )
        for name in names
        if first.setdefault(name.lower(), name) != name
    ]
