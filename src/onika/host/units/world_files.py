"""The source files of open worlds: what an editor has changed since they were loaded is told, and nothing restarts."""

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from hashlib import sha256
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import find_spec
from pathlib import Path

from onika.host.units.world_registry import module_of
from onika.wire import event
from onika.words.reason import Reason

_LOOKED_EVERY_NS = 1_000_000_000
_ENDINGS = (".py", ".xml", ".urdf")
"""Of what lies beside a world in its package: code, and descriptions of what it consists of."""

Mark = tuple[int, int, int]
"""When a file was written, its size, and which one it is."""


@dataclass(slots=True)
class _LoadedFile:
    """A file as it was when its world was loaded, and as it was at the last look."""

    digest: str
    mark: Mark | None
    is_changed: bool = False


class WorldFiles:
    """Looks once a second, by the wall clock. `sources` gives the files of a world."""

    def __init__(self, sources: Callable[[str], Collection[Path]] | None = None) -> None:
        self._sources = sources or (lambda world: source_files(module_of(world)))
        self._worlds: dict[str, dict[Path, _LoadedFile]] = {}
        self._changed: dict[str, Path | None] = {}
        self._due_ns = 0

    def look(self, worlds: Collection[str], wall_ns: int, at_s: float) -> tuple[event.Outdated, ...]:
        """What is to be told of the worlds that are open."""
        for world in worlds:
            if world not in self._worlds:
                self._worlds[world] = {path: _loaded(path) for path in self._sources(world)}
        if wall_ns < self._due_ns:
            return ()
        self._due_ns = wall_ns + _LOOKED_EVERY_NS
        return tuple(self._differences(at_s))

    def _differences(self, at_s: float) -> Iterator[event.Outdated]:
        """Each world once when it is outdated, and once when its files are again as it was loaded."""
        for world, files in self._worlds.items():
            path = _first_changed(files)
            if (path is None) != (self._changed.get(world) is None):
                yield _outdated(world, path, at_s)
            self._changed[world] = path


def source_files(module: str) -> tuple[Path, ...]:
    """The file of a module, and what lies beside it in its package; no code of it is executed for that."""
    top, *inner = module.split(".")
    try:
        spec = find_spec(top)
    except (ImportError, ValueError):
        return ()
    for part in inner:
        spec = _within(spec, part)
    if spec is None or spec.origin is None or not spec.has_location:
        return ()
    file = Path(spec.origin)
    if "." not in spec.name and spec.submodule_search_locations is None:
        return (file,)  # a module of no package: what lies beside it belongs to others
    try:
        return tuple(sorted(path for path in file.parent.iterdir() if path.suffix in _ENDINGS))
    except OSError:
        return (file,)


def _within(spec: ModuleSpec | None, part: str) -> ModuleSpec | None:
    if spec is None or spec.submodule_search_locations is None:
        return None
    return PathFinder.find_spec(f"{spec.name}.{part}", list(spec.submodule_search_locations))


def _outdated(world: str, path: Path | None, at_s: float) -> event.Outdated:
    if path is None:
        return event.Outdated(world, False, Reason.of("host.world_as_loaded", world=world), at_s)
    return event.Outdated(world, True, Reason.of("host.world_outdated", world=world, path=str(path)), at_s)


def _loaded(path: Path) -> _LoadedFile:
    mark = _mark(path)  # first: what is written meanwhile has another one at the next look
    return _LoadedFile(_digest(path), mark)


def _first_changed(files: Mapping[Path, _LoadedFile]) -> Path | None:
    """A file that says something else; one that was written anew with the same text has not changed."""
    for path, file in files.items():
        mark = _mark(path)
        if mark != file.mark:
            file.mark, file.is_changed = mark, _digest(path) != file.digest
    return next((path for path, file in files.items() if file.is_changed), None)


def _mark(path: Path) -> Mark | None:
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino


def _digest(path: Path) -> str:
    """Of what it says; empty where it is gone or cannot be read."""
    try:
        return sha256(path.read_bytes()).hexdigest()
    except OSError:
        return ""
