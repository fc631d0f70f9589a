"""A site: the search path of base directories and one user's own files, in which names are looked up (reading 11)."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from onika.files import appl, buttons, picture, preferences, syntax, text, whole
from onika.files.rmod import RmodText
from onika.model.application import Application
from onika.model.button import Button
from onika.model.configuration import Configuration
from onika.model.onikon import Onikon
from onika.model.picture import Picture, blank
from onika.model.preferences import Preferences
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults, OpenedText, open_file, put, save
from onika.store.remote.checkout import Checkout
from onika.store.remote.library_fetcher import LibraryFetcher, checkouts_of
from onika.store.remote.object_cache import ObjectCache, cache_directory
from onika.store.shipped import FOLDERS, shipped, shipped_directories
from onika.words.fault import Fault, Place, Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

OWN = "onika"
"""What the base directory of a user's own is called, in the home directory."""


@dataclass(frozen=True, slots=True)
class Site:
    """Names are found in `directories` in order; `home` holds the user's own files, `prefs` the installation's.

    Reading gives what was found, or None, and all faults.
    """

    directories: Sequence[BaseDirectory]
    prefs: Path
    home: Path | None = None
    checkouts: tuple[Checkout, ...] = ()
    """The libraries of others among the directories."""
    faults_of_checkouts: Faults = ()
    """What is wrong with libraries of others; those that are at fault are not among the directories."""
    fetcher: LibraryFetcher | None = None
    """Fetches what a program needs of them; None: what is here is all there is."""

    def at(self, own: Path) -> "Site":
        """The same site with one base directory before all others."""
        others = tuple(base for base in self.directories if base.path.resolve() != own.resolve())
        return replace(self, directories=(BaseDirectory(own), *others))

    @property
    def own(self) -> Path | None:
        """The base directory of the user's own, whether it is there already or not."""
        return None if self.home is None else self.home / OWN

    # -- the user's and the installation's files

    @property
    def syntax_files(self) -> tuple[Path, ...]:
        """Where the syntax may be defined, the user's own first."""
        own = () if self.home is None else (self.home / f".{syntax.NAME}", self.home / syntax.NAME)
        return (*own, self.prefs / syntax.NAME)

    def syntax(self) -> tuple[Syntax | None, Faults]:
        """The user's own syntax definition, else the shipped one; whole, never merged (reading 39).

        A faulty one is reported and the next is taken; None only where the shipped one is at fault.
        """
        faults_of_files: list[Fault] = []
        for path in self.syntax_files:
            if path != self.syntax_files[-1] and not path.exists():
                continue
            content, faults = text.load(path, str(path))
            faults_of_files += faults
            if content is not None:
                read, faults = syntax.read(content, path.name, str(path))
                faults_of_files += faults
                if read is not None:
                    return read, tuple(faults_of_files)
        return None, tuple(faults_of_files)

    def preferences(self) -> tuple[Preferences, Faults]:
        """The user's preferences; defaults for what is missing or wrong (requirement B12)."""
        content, faults = self._own(preferences.NAME)
        if content is None:
            return Preferences(), faults
        return preferences.read(content, preferences.NAME, str(self._own_path(preferences.NAME)))

    def keep_preferences(self, preferred: Preferences) -> Refusal | None:
        """Write the preferences at the end of a session where the user has no file of them yet (requirement B12)."""
        path = self._own_path(preferences.NAME)
        if path is None or os.path.lexists(path):
            return None
        saved = put(path, preferred, preferences.write(preferred), whole.ABSENT)
        return saved if isinstance(saved, Refusal) else None

    def open_preferences(self) -> tuple[OpenedText[Preferences] | None, Faults]:
        """The preferences to be edited and saved again; None where the user has no file of them that can be read."""
        path = self._own_path(preferences.NAME)
        if path and path.exists():
            return open_file(path, preferences.NAME, preferences.read)
        return (None, ())

    def save_preferences(
        self, preferred: Preferences, former: OpenedText[Preferences] | None = None, *, overwrites: bool = False
    ) -> OpenedText[Preferences] | Refusal:
        """Save preferences opened as `former`, or new ones; see `opened.save`."""
        path = self._own_path(preferences.NAME)
        if path is None:
            return Refusal(Reason.of("store.no_home_for_preferences"))
        return save(path, preferred, preferences.write, former, overwrites=overwrites)

    def buttons(self) -> tuple[tuple[Button, ...], Faults]:
        """The user's buttons; none where the file is missing or at fault."""
        content, faults = self._own(buttons.NAME)
        if content is None:
            return (), faults
        read, faults = buttons.read(content, buttons.NAME, str(self._own_path(buttons.NAME)))
        return read or (), faults

    def open_buttons(self) -> tuple[OpenedText[tuple[Button, ...]] | None, Faults]:
        """The buttons to be edited and saved again; None where the user has no file of them that can be read."""
        path = self._own_path(buttons.NAME)
        if path and path.exists():
            return open_file(path, buttons.NAME, buttons.read)
        return (None, ())

    def save_buttons(
        self,
        made: tuple[Button, ...],
        former: OpenedText[tuple[Button, ...]] | None = None,
        *,
        overwrites: bool = False,
    ) -> OpenedText[tuple[Button, ...]] | Refusal:
        """Save buttons opened as `former`, or new ones; see `opened.save`."""
        path = self._own_path(buttons.NAME)
        if path is None:
            return Refusal(Reason.of("store.no_home_for_buttons"))
        return save(path, made, buttons.write, former, overwrites=overwrites)

    def flow_pictures(self) -> tuple[tuple[Picture, Picture], Faults]:
        """The pictures of the start and stop icons; the shipped ones where they are missing or at fault (§A.8)."""
        start, of_start = self._flow_picture("OnikaStart.dta")
        stop, of_stop = self._flow_picture("OnikaStop.dta")
        return (start, stop), of_start + of_stop

    # -- finding

    def home_of_task(self, name: str) -> BaseDirectory | None:
        """The first base directory that holds the task `name`."""
        return self._first(name, BaseDirectory.task_file)

    def code_file(self, task: Task) -> Path | None:
        """The code of a task's module: beside the task's own file, else the first on the search path."""
        home = self.home_of_task(task.name)
        bases = (*((home,) if home else ()), *self.directories)
        return next((path for base in bases if (path := base.code_file(task.module)).is_file()), None)

    def configuration_file(self, name: str) -> Path | None:
        """The file of the configuration `name`, in the first base directory that holds it."""
        base = self._first(name, BaseDirectory.configuration_file)
        return base.configuration_file(name) if base else None

    def application_file(self, name_or_path: str) -> Path | None:
        """The file of an application given by its name, or by a path where that ends with `.appl` or holds a `/`."""
        if name_or_path.endswith(appl.ENDING) or os.sep in name_or_path:
            path = Path(name_or_path)
            return path if path.is_file() else None
        base = self._first(name_or_path, BaseDirectory.application_file)
        if base:
            return base.application_file(name_or_path)
        return None

    def bring(self, paths: Iterable[Path]) -> Faults:
        """Have these files here, as far as they are of libraries of others; what does not come is told."""
        return () if self.fetcher is None else self.fetcher.bring(paths)

    # -- reading by name

    def task(self, name: str) -> tuple[RmodText | None, Faults]:
        """The task `name`, from the first base directory that holds it."""
        base = self.home_of_task(name)
        return base.task(name) if base else (None, ())

    def configuration(self, name: str) -> tuple[Configuration | None, Faults]:
        """The configuration `name`, from the first base directory that holds it."""
        base = self._first(name, BaseDirectory.configuration_file)
        return base.configuration(name) if base else (None, ())

    def onikon(self, name: str, types: Syntax) -> tuple[Onikon | None, Faults]:
        """The onikon `name`, from the first base directory that holds it."""
        base = self._first(name, BaseDirectory.onikon_file)
        return base.onikon(name, types) if base else (None, ())

    def application(self, name: str, types: Syntax) -> tuple[Application | None, Faults]:
        """The application `name`, from the first base directory that holds it."""
        base = self._first(name, BaseDirectory.application_file)
        if base:
            return base.application(name, types)
        return (None, ())

    def duplicates(self) -> Faults:
        """Names found in several base directories: the first one counts, each later one is reported (D15, B08)."""
        kinds: tuple[Callable[[BaseDirectory], tuple[str, ...]], ...] = (
            lambda base: base.tasks,
            lambda base: base.configurations,
            lambda base: base.onikons,
            lambda base: base.applications,
        )
        return tuple(fault for kind, names in zip(FOLDERS, kinds, strict=True) for fault in self._twice(kind, names))

    def absent(self) -> Faults:
        """Directories of the search path that are none, as notes (requirement C20); the user's own may be absent.

        With them what is wrong with libraries of others.
        """
        none = tuple(
            Fault(
                Place(str(base.path)),
                Reason.of("store.path_without_base_directory"),
                Reason.of("store.passed_over"),
                is_note=True,
            )
            for base in self.directories
            if not base.path.is_dir() and base.path != self.own
        )
        return (*none, *self.faults_of_checkouts)

    def _twice(self, folder: str, names: Callable[[BaseDirectory], tuple[str, ...]]) -> Iterator[Fault]:
        first: dict[str, BaseDirectory] = {}
        for base in self.directories:
            for name in names(base):
                winner = first.setdefault(name, base)
                if winner is not base:
                    place = Place(str(base.path / folder / name))
                    yield Fault(
                        place,
                        Reason.of("store.name_twice", name=name, path=str(winner.path / folder)),
                        Reason.of("words.first_used"),
                        is_note=True,
                    )

    def _first(self, name: str, file: Callable[[BaseDirectory, str], Path]) -> BaseDirectory | None:
        if not TASK_NAME.match(name):
            return None
        return next((base for base in self.directories if file(base, name).is_file()), None)

    def _flow_picture(self, name: str) -> tuple[Picture, Faults]:
        faults: Faults = ()
        for path in dict.fromkeys((self.prefs / name, shipped() / "prefs" / name)):
            opened, faults_of_file = open_file(path, name, picture.read)
            faults += faults_of_file
            if opened:
                return opened.value, faults
        return blank(), faults

    def _own_path(self, name: str) -> Path | None:
        return None if self.home is None else self.home / name

    def _own(self, name: str) -> tuple[str | None, Faults]:
        """The text of one of the user's own files, which are all optional."""
        path = self._own_path(name)
        if path and path.exists():
            return text.load(path, str(path))
        return (None, ())


def open_site(local: Iterable[Path], environment: Mapping[str, str], home: Path | None) -> Site:
    """The site of a session: the directories `local`, those of ONIKA_LOCAL, the user's own, the shipped laboratories.

    Behind them come the libraries of others that the directories lock: no foreign name ever takes the place of one
    that is here.

    The user's own is among them before it is there: what is saved in it first is found at once.
    ONIKA_LOCAL is a list parted like PATH; ONIKA_DIR names a directory whose `prefs` stand for the shipped ones.
    """
    named = [Path(part) for part in environment.get("ONIKA_LOCAL", "").split(os.pathsep) if part]
    own = [] if home is None else [home / OWN]
    users = dict.fromkeys(path.absolute() for path in (*local, *named, *own))
    checkouts, faults = checkouts_of(users, ObjectCache(cache_directory(environment)))
    shipped_paths = (path.absolute() for path in shipped_directories())
    paths = dict.fromkeys((*users, *shipped_paths, *(checkout.folder for checkout in checkouts)))
    root = environment.get("ONIKA_DIR")
    prefs = Path(root) / "prefs" if root else shipped() / "prefs"
    return Site(tuple(BaseDirectory(path) for path in paths), prefs, home, checkouts, faults)
