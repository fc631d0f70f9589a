"""A site that caches what it has read, and reads a file again only when it has changed."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from onika.files.rmod import RmodText
from onika.model.application import Application
from onika.model.configuration import Configuration
from onika.model.syntax import Syntax
from onika.store.opened_text import Faults
from onika.store.site import Site

Stamp = tuple[int, int] | None
"""When a file was written last, in ns, and its length; None: there is none."""


@dataclass(frozen=True, slots=True)
class RememberingSite(Site):
    """Used by one thread at a time. What is not asked for any more is kept, for it may be asked for again."""

    memory: dict[tuple[str, Path], tuple[Stamp, Any]] = field(default_factory=dict, compare=False, repr=False)

    @classmethod
    def of(cls, site: Site) -> "RememberingSite":
        """The same site, with nothing read yet."""
        return cls(site.directories, site.prefs, site.home, site.checkouts, site.faults_of_checkouts)

    def task(self, name: str) -> tuple[RmodText | None, Faults]:
        """The task `name`, from the first base directory that holds it."""
        read = super(RememberingSite, self).task  # `super()` alone does not know a class with slots
        home = self.home_of_task(name)
        return self._once("task", home.task_file(name), lambda: read(name)) if home else (None, ())

    def configuration(self, name: str) -> tuple[Configuration | None, Faults]:
        """The configuration `name`, from the first base directory that holds it."""
        read = super(RememberingSite, self).configuration
        file = self.configuration_file(name)
        return self._once("configuration", file, lambda: read(name)) if file else (None, ())

    def application(self, name: str, types: Syntax) -> tuple[Application | None, Faults]:
        """The application `name`, from the first base directory that holds it."""
        read = super(RememberingSite, self).application
        file = self.application_file(name)
        return self._once(f"application {id(types)}", file, lambda: read(name, types)) if file else (None, ())

    def stamps(self, files: Iterable[Path | None]) -> tuple[Stamp, ...]:
        """What tells whether files have changed."""
        return tuple(None if file is None else _stamp(file) for file in files)

    def _once(self, kind: str, path: Path, read: Callable[[], Any]) -> Any:
        stamp = _stamp(path)
        entry = self.memory.get((kind, path))
        if entry is not None and entry[0] == stamp:
            return entry[1]
        value = read()
        self.memory[kind, path] = (stamp, value)
        return value


def _stamp(path: Path) -> Stamp:
    try:
        stat = path.stat()
    except OSError:
        return None
    return stat.st_mtime_ns, stat.st_size
