"""With what a session begins: what a replay has to be given, and what it is given by the log (requirement H08)."""

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from onika import __version__
from onika.desk.environment.diary_record import place_names
from onika.desk.environment.file import recovery_record
from onika.desk.environment.state.model import Model
from onika.files import preferences, syntax, text
from onika.store.shipped import FOLDERS, shipped
from onika.store.site import Site

_MOST_FILES = 2000
"""Files of a base directory whose digests are told."""


@dataclass(frozen=True, slots=True)
class SessionStart:
    """The site of a session; None: there is none to be told of."""

    site: Site | None = None

    @property
    def home(self) -> str:
        """The home of the user; empty: there is none."""
        return "" if self.site is None or self.site.home is None else str(self.site.home)

    @property
    def places(self) -> Mapping[str, str]:
        """What stands for the folders of the search path."""
        return {} if self.site is None else place_names(tuple(base.path for base in self.site.directories))

    def facts(self, model: Model) -> Mapping[str, Any]:
        """The version, the settings, the files of the user's own, what was had back, and digests of files."""
        folders = [Path(path) for path in self.places if Path(path) != shipped()]
        return {
            "version": __version__,
            "settings": asdict(model.settings),
            "own": self._own_files(),
            "unsaved": [
                recovery_record.write(recovery_record.rescue_of(file)) for file in model.open_files if file.is_dirty
            ],
            "bases": [{"name": self._name_of(folder), "files": digests(folder)} for folder in folders],
            "own_at": next((number for number, folder in enumerate(folders) if folder == self._own), -1),
        }

    @property
    def _own(self) -> Path | None:
        """The base directory of the user's own."""
        return None if self.site is None else self.site.own

    def _name_of(self, folder: Path) -> str:
        """What a base directory is called; a home has the name of somebody, which is not told."""
        return "home" if str(folder) == self.home else folder.name

    def _own_files(self) -> Mapping[str, str]:
        """The texts of the user's preferences and of his syntax definition, by name; buttons are not told."""
        if not self.home:
            return {}
        paths = (Path(self.home, name) for name in (preferences.NAME, f".{syntax.NAME}", syntax.NAME))
        texts = {path.name: text.load(path, path.name)[0] for path in paths if path.is_file()}
        return {name: content for name, content in texts.items() if content is not None}


def digests(folder: Path) -> Mapping[str, str]:
    """The first digits of the SHA-256 of each file of a base directory, by its path within."""
    return {str(path.relative_to(folder)): _digest(path) for path in _files(folder)}


def _files(folder: Path) -> Iterator[Path]:
    count = 0
    for name in FOLDERS:
        for path in sorted((folder / name).glob("*")):
            if path.is_file() and count < _MOST_FILES:
                count += 1
                yield path


def _digest(path: Path) -> str:
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()[:16]
    except OSError:
        return ""
