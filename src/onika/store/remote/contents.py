"""What a library offers, as it is shown to somebody who looks for something: names, descriptions, pictures (F06)."""

import re
from collections.abc import Iterator, Mapping, Set
from dataclasses import dataclass

from onika.files.library_index import LibraryIndex
from onika.files.library_lock import Agreement
from onika.model.picture import is_square
from onika.store.remote.agreement import declared

KINDS: Mapping[str, str] = {".rmod": "task", ".conf": "configuration", ".onk": "icon", ".appl": "application"}
"""What files are, by the endings of their names; of a world it is its text."""

_WORLD = ".world"
_LONGEST = 300
_ROW = re.compile(r"PICT +([0-8]{1,64})\Z")
_NOTHING = Agreement()


@dataclass(frozen=True, slots=True)
class LibraryEntry:
    """One thing that a library offers."""

    path: str
    kind: str
    """`task`, `configuration`, `icon`, `application` or `world`."""
    name: str
    description: str = ""
    rows: tuple[str, ...] = ()
    """The rows of its picture; none where it has none."""
    writes: tuple[str, ...] = ()
    """Of a task: the state variables that it may write."""
    touches: tuple[str, ...] = ()
    """Of a task: its devices."""
    is_new: bool = False
    """Whether it came, or changed, since the version that is used."""


def contents(index: LibraryIndex, new: Set[str] = frozenset()) -> tuple[LibraryEntry, ...]:
    """Everything that can be chosen, by kinds and names; what belongs to it, as code and models, is not named apart."""
    agreements = declared(index)
    pictures = {entry.name: entry for entry in _entries(index, agreements, new) if entry.kind == "icon"}
    return tuple(_pictured(entry, pictures) for entry in _entries(index, agreements, new))


def matching(entries: tuple[LibraryEntry, ...], words: str) -> tuple[LibraryEntry, ...]:
    """Those that have all of these words in their names, descriptions or variables."""
    wanted = words.casefold().split()
    return tuple(entry for entry in entries if all(word in _text(entry) for word in wanted))


def _entries(index: LibraryIndex, agreements: Mapping[str, Agreement], new: Set[str]) -> Iterator[LibraryEntry]:
    for path, file in sorted(index.files.items()):
        folder, _, filename = path.partition("/")
        stem, dot, ending = filename.rpartition(".")
        kind = "world" if folder == "world" and dot + ending == _WORLD else KINDS.get(dot + ending)
        if kind is None:
            continue
        lines = (file.content or b"").decode("utf-8", "replace").splitlines()
        agreement = agreements.get(stem, _NOTHING) if kind == "task" else _NOTHING
        writes, touches = tuple(sorted(agreement.writes)), tuple(sorted(agreement.touches))
        rows = _rows(lines) if kind == "icon" else ()
        description = "" if kind == "application" else _description(lines)  # there it is that of its first icon
        yield LibraryEntry(path, kind, stem, description, rows, writes, touches, path in new)


def _pictured(entry: LibraryEntry, icons: Mapping[str, LibraryEntry]) -> LibraryEntry:
    """A configuration or an application with the picture and the words of its icon."""
    icon = icons.get(entry.name)
    if icon is None or entry.kind not in ("configuration", "application"):
        return entry
    return LibraryEntry(
        entry.path, entry.kind, entry.name, entry.description or icon.description, icon.rows, is_new=entry.is_new
    )


def _description(lines: list[str]) -> str:
    line = next((line for line in lines[:40] if line.startswith("DESC ")), "")
    return " ".join(line.removeprefix("DESC ").split())[:_LONGEST]


def _rows(lines: list[str]) -> tuple[str, ...]:
    rows = tuple(match[1] for line in lines[:400] if (match := _ROW.match(line.strip())))
    return rows if is_square(rows) else ()


def _text(entry: LibraryEntry) -> str:
    return " ".join((entry.name, entry.kind, entry.description, *entry.writes, *entry.touches)).casefold()
