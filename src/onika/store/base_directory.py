"""A base directory: the libraries and dictionaries of one place, `module/ conf/ dict/ appl/` (requirement B08)."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TypeVar

from onika.files import appl, conf, onk, rmod, text, whole
from onika.files.rmod import RmodText
from onika.model.application import Application
from onika.model.configuration import Configuration
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax
from onika.words.fault import Fault, Place
from onika.words.name import TASK_NAME

_T = TypeVar("_T")
Faults = tuple[Fault, ...]
_Read = Callable[[str, str, str], tuple[_T | None, Faults]]


@dataclass(frozen=True, slots=True)
class BaseDirectory:
    """The files of one base directory, read when asked for; a missing subdirectory holds nothing.

    Reading gives what was found, or None, and all faults; names are file names without their ending.
    """

    path: Path

    @property
    def tasks(self) -> tuple[str, ...]:
        """The names of the `.rmod` files, in order."""
        return self._names("module", rmod.ENDING)

    @property
    def configurations(self) -> tuple[str, ...]:
        """The names of the `.conf` files, in order."""
        return self._names("conf", conf.ENDING)

    @property
    def onikons(self) -> tuple[str, ...]:
        """The names of the `.onk` files, in order."""
        return self._names("dict", onk.ENDING)

    @property
    def applications(self) -> tuple[str, ...]:
        """The names of the `.appl` files, in order."""
        return self._names("appl", appl.ENDING)

    @property
    def misnamed(self) -> Faults:
        """Files whose names are no names of tasks, icons or applications, and which are therefore left out."""
        places = (("module", rmod.ENDING), ("conf", conf.ENDING), ("dict", onk.ENDING), ("appl", appl.ENDING))
        wrong = [path for folder, ending in places for path in self._files(folder, ending) if not _is_name(path.stem)]
        expected = "a name of letters, digits and _ . - that begins with a letter"
        return tuple(Fault(Place(str(path)), expected, repr(path.stem), "the file is left out") for path in wrong)

    def task_file(self, name: str) -> Path:
        """Where the task `name` stands or would stand."""
        return self._file("module", name, rmod.ENDING)

    def configuration_file(self, name: str) -> Path:
        """Where the configuration `name` stands or would stand."""
        return self._file("conf", name, conf.ENDING)

    def onikon_file(self, name: str) -> Path:
        """Where the onikon `name` stands or would stand."""
        return self._file("dict", name, onk.ENDING)

    def application_file(self, name: str) -> Path:
        """Where the application `name` stands or would stand."""
        return self._file("appl", name, appl.ENDING)

    def code_file(self, module: str) -> Path:
        """Where the code of a module stands or would stand: `module/NAME.py`."""
        return self._file("module", module, ".py")

    def task(self, name: str) -> tuple[RmodText | None, Faults]:
        """The task `name` with its text."""
        return _read(self.task_file(name), name, rmod.read)

    def configuration(self, name: str) -> tuple[Configuration | None, Faults]:
        """The configuration `name`."""
        return _read(self.configuration_file(name), name, conf.read)

    def onikon(self, name: str, syntax: Syntax) -> tuple[Onikon | None, Faults]:
        """The onikon `name`."""
        return _read(self.onikon_file(name), name, partial(onk.read, syntax=syntax))

    def application(self, name: str, syntax: Syntax) -> tuple[Application | None, Faults]:
        """The application `name`."""
        return _read(self.application_file(name), name, partial(appl.read, syntax=syntax))

    def save_task(self, record: RmodText) -> None:
        """Write a task, its comments as they were; OSError where that cannot be."""
        _save(self.task_file(record.task.name), rmod.write(record))

    def save_configuration(self, configuration: Configuration) -> None:
        """Write a configuration; comments of the file it replaces are kept. OSError where that cannot be."""
        path = self.configuration_file(configuration.name)
        _save(path, conf.write(configuration, _former(path)))

    def save_onikon(self, onikon: Onikon) -> None:
        """Write an onikon; comments of the file it replaces are kept. OSError where that cannot be."""
        path = self.onikon_file(onikon.name)
        _save(path, onk.write(onikon, _former(path)))

    def save_application(self, application: Application) -> None:
        """Write an application; comments of the file it replaces are kept. OSError where that cannot be."""
        path = self.application_file(application.name)
        _save(path, appl.write(application, _former(path)))

    def _file(self, folder: str, name: str, ending: str) -> Path:
        if not _is_name(name):
            raise ValueError(f"expected a name of letters, digits and _ . - that begins with a letter, found {name!r}")
        return self.path / folder / (name + ending)

    def _files(self, folder: str, ending: str) -> list[Path]:
        """The files with this ending; hidden ones are nobody's, a folder that cannot be read holds none."""
        try:
            found = sorted((self.path / folder).iterdir(), key=lambda path: path.name)
        except OSError:
            return []
        return [path for path in found if path.name.endswith(ending) and not path.name.startswith(".")]

    def _names(self, folder: str, ending: str) -> tuple[str, ...]:
        names = (path.name.removesuffix(ending) for path in self._files(folder, ending))
        return tuple(name for name in names if _is_name(name))


def _is_name(name: str) -> bool:
    return TASK_NAME.match(name) is not None


def _read(path: Path, name: str, read: _Read[_T]) -> tuple[_T | None, Faults]:
    content, faults = text.load(path, str(path))
    return (None, faults) if content is None else read(content, name, str(path))


def _former(path: Path) -> str:
    """The text a file had; "" where there was none to keep comments of."""
    return text.load(path, str(path))[0] or ""


def _save(path: Path, content: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    whole.write(path, content)
