"""A look at the files that others may change meanwhile: which ones are no longer what they were at the last look."""

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Protocol

from onika.desk.environment.state.model import Model
from onika.files import appl, arrangement, conf, onk, rmod
from onika.store.site import Site

_FOLDERS = {
    "module": (rmod.ENDING, ".py", arrangement.NAME),
    "conf": (conf.ENDING,),
    "dict": (onk.ENDING, arrangement.NAME),
    "appl": (appl.ENDING,),
}

Mark = tuple[int, int, int]
"""When a file was written, its size, and which one it is: a file that is exchanged is another one."""


class DiskWatch:
    """Knows the files of every base directory as they were when it looked last; of one thread at a time."""

    def __init__(self, site: Site) -> None:
        self._site = site
        self._folders: dict[str, dict[str, Mark]] = _look(_paths(base.path for base in site.directories), {})
        self._single = _single(site, {})

    def changed(self, model: Model) -> set[Path]:
        """The files that were written, made or removed since the last look.

        Of a base directory that was not looked at before these are all: nobody knows since when they are so.
        """
        former, single = self._folders, self._single
        self._folders = _look(_paths(bases(self._site, model)), former)
        self._single = _single(self._site, single)
        changed = {
            Path(folder, name)
            for folder, marks in self._folders.items()
            for name in _different(former.get(folder, {}), marks)
        }
        return changed | {Path(path) for path in _different(single, self._single)}


def bases(site: Site, model: Model) -> Iterable[Path]:
    """The base directories that matter: of the search path and of what is open."""
    yield from (base.path for base in site.directories)
    yield from (library.base.path for library in model.libraries.libraries)
    yield from (dictionary.base.path for dictionary in model.dictionaries)
    yield from (document.base for document in model.documents.values() if document.base is not None)
    yield from (application.base for application in model.applications.values() if application.base is not None)


def _paths(paths: Iterable[Path]) -> dict[str, tuple[str, ...]]:
    """The folders to be looked at, and the endings that count there."""
    return {str(base / folder): endings for base in paths for folder, endings in _FOLDERS.items()}


def _look(folders: Mapping[str, tuple[str, ...]], former: Mapping[str, dict[str, Mark]]) -> dict[str, dict[str, Mark]]:
    return {folder: _marks(folder, endings, former.get(folder, {})) for folder, endings in folders.items()}


def _marks(folder: str, endings: tuple[str, ...], former: dict[str, Mark]) -> dict[str, Mark]:
    """What stands in a folder; one that cannot be looked into for now has not changed."""
    marks: dict[str, Mark] = {}
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.name.endswith(endings) and not entry.name.startswith("."):
                    mark = _mark(entry, former.get(entry.name))
                    if mark is not None:
                        marks[entry.name] = mark
    except (FileNotFoundError, NotADirectoryError):
        return {}
    except OSError:
        return former
    return marks


def _single(site: Site, former: Mapping[str, Mark]) -> dict[str, Mark]:
    """The files that stand in no base directory: those that may define the syntax."""
    marks = {str(path): _mark(path, former.get(str(path))) for path in site.syntax_files}
    return {path: mark for path, mark in marks.items() if mark is not None}


class _File(Protocol):
    def stat(self) -> os.stat_result: ...


def _mark(entry: _File, former: Mark | None) -> Mark | None:
    """A link is what it leads to; one that leads nowhere, or a file removed just now, is none."""
    try:
        status = entry.stat()
    except FileNotFoundError:
        return None
    except OSError:
        return former
    return status.st_mtime_ns, status.st_size, status.st_ino


def _different(former: Mapping[str, Mark], now: Mapping[str, Mark]) -> Iterable[str]:
    yield from (name for name, mark in now.items() if former.get(name) != mark)
    yield from former.keys() - now.keys()
