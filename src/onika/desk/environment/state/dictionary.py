"""An open dictionary: the icons of one base directory, and what is wrong with its files (requirements D01, D15)."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from onika.files import text
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults, OpenedText
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

Found = tuple[OpenedText[Onikon] | None, Faults]
"""What one file gave."""


@dataclass(frozen=True, slots=True)
class Dictionary:
    """What one base directory has; a name that an earlier open dictionary has already is not in it."""

    base: BaseDirectory
    onikons: Mapping[str, OpenedText[Onikon]]
    """By their names, grouped by type in the order of the syntax."""
    faults: Faults = ()
    readings: Mapping[str, Found] = field(default_factory=dict)
    """What every file gave that was read, also where that is no icon, by the names of the files."""


def open_dictionaries(
    bases: Iterable[BaseDirectory],
    syntax: Syntax,
    former: Iterable[Dictionary] = (),
    changed: frozenset[Path] = frozenset(),
) -> tuple[Dictionary, ...]:
    """The dictionaries of base directories, in order; of those in `former` only files among `changed` are read again.

    A later icon of a name is not added and is told. What is as it was is the same object.
    """
    former_by_base = {dictionary.base: dictionary for dictionary in former}
    owners: dict[str, BaseDirectory] = {}
    opened = []
    for base in bases:
        names = base.onikons
        first = [name for name in names if owners.setdefault(name, base) is base]
        again = [_again(base, name, owners[name]) for name in names if owners[name] is not base]
        before = former_by_base.get(base)
        made = _open(base, first, again, syntax, before, changed)
        opened.append(before if before == made else made)
    return tuple(opened)


def has_dictionary(base: BaseDirectory) -> bool:
    """Whether a base directory has a place for icons."""
    return (base.path / "dict").is_dir()


def find(dictionaries: Iterable[Dictionary], name: str) -> OpenedText[Onikon] | None:
    """The icon of a name among open dictionaries."""
    return next((dictionary.onikons[name] for dictionary in dictionaries if name in dictionary.onikons), None)


def home_of(dictionaries: Iterable[Dictionary], name: str) -> Dictionary | None:
    """The dictionary that has an icon."""
    return next((dictionary for dictionary in dictionaries if name in dictionary.onikons), None)


def _open(
    base: BaseDirectory,
    names: Iterable[str],
    faults: list[Fault],
    syntax: Syntax,
    former: Dictionary | None,
    changed: frozenset[Path],
) -> Dictionary:
    former_readings = former.readings if former else {}
    readings = {name: _read(base, name, syntax, former_readings.get(name), changed) for name in names}
    ranks = {kind.name: place for place, kind in enumerate(syntax.types)}

    def rank(opened: OpenedText[Onikon]) -> tuple[int, str, str]:
        return ranks.get(opened.value.type, len(ranks)), opened.value.type, opened.value.name

    icons = sorted((opened for opened, _ in readings.values() if opened is not None), key=rank)
    faults += [fault for fault in (*base.unreadable, *base.misnamed) if _is_of(base, fault)]
    faults += [fault for _, wrong in readings.values() for fault in wrong]
    return Dictionary(base, {icon.value.name: icon for icon in icons}, tuple(sorted(faults)), readings)


def _read(base: BaseDirectory, name: str, syntax: Syntax, reading: Found | None, changed: frozenset[Path]) -> Found:
    """A file, or what is known of it where it has not changed."""
    if reading is not None:
        file = base.onikon_file(name)
        if file not in changed or (reading[0] is not None and text.load(file, str(file))[0] == reading[0].text):
            return reading
    return base.open_onikon(name, syntax)


def _is_of(base: BaseDirectory, fault: Fault) -> bool:
    """Whether a fault of a base directory is one of its dictionary."""
    folder, file = base.path / "dict", Path(fault.place.file)
    return folder in (file, file.parent)


def _again(base: BaseDirectory, name: str, owner: BaseDirectory) -> Fault:
    path = str(owner.path / "dict")
    return Fault(
        Place(str(base.onikon_file(name))),
        Reason.of("desk.icon_twice", name=name, path=path),
        Reason.of("words.first_used"),
        is_note=True,
    )
