"""A base directory: the libraries and dictionaries of one place, `module/ conf/ dict/ appl/` (requirement B08)."""

import os
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TypeVar

from onika.files import appl, conf, onk, rmod, whole
from onika.files.puzzles import puzzle
from onika.files.rmod import RmodText
from onika.model.application import Application
from onika.model.configuration import Configuration
from onika.model.onikon import Onikon
from onika.model.puzzle import Puzzle
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.opened_text import Faults, OpenedText, Read, open_file, put, save
from onika.words.fault import Fault, Place, Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason
from onika.words.system_error import system_reason

_T = TypeVar("_T")


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
    def puzzles(self) -> tuple[str, ...]:
        """The names of the `.puzzle` files, in order."""
        return self._names("puzzle", puzzle.ENDING)

    @property
    def modules(self) -> tuple[str, ...]:
        """The names of the modules whose code lies here, in order."""
        return self._names("module", ".py")

    @property
    def catalogue_files(self) -> tuple[Path, ...]:
        """The catalogues that may lie beside the code of modules, `module/NAME.LANGUAGE.toml`, in order."""
        return tuple(self._files("module", ".toml"))

    @property
    def misnamed(self) -> Faults:
        """Files whose names are no names of tasks, icons or applications, and which are therefore left out."""
        places = (("module", rmod.ENDING), ("conf", conf.ENDING), ("dict", onk.ENDING), ("appl", appl.ENDING))
        wrong = [path for folder, ending in places for path in self._files(folder, ending) if not _is_name(path.stem)]
        return tuple(
            Fault(
                Place(str(path)), Reason.of("store.name_form", stem=repr(path.stem)), Reason.of("words.file_left_out")
            )
            for path in wrong
        )

    @property
    def unreadable(self) -> Faults:
        """This directory where there is none, and its folders that cannot be looked into; absent ones are empty."""
        names = []
        if not self.path.is_dir():
            names.append(
                Fault(Place(str(self.path)), Reason.of("store.no_base_directory"), Reason.of("words.left_out"))
            )
        for folder in ("module", "conf", "dict", "appl"):
            try:
                os.listdir(self.path / folder)  # noqa: PTH208 - iterdir waits until it is asked
            except FileNotFoundError:
                continue
            except OSError as error:
                place = Place(str(self.path / folder))
                names.append(
                    Fault(
                        place,
                        Reason.of("store.unreadable_folder", why=system_reason(error)),
                        Reason.of("store.files_left_out"),
                    )
                )
        return tuple(names)

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

    def puzzle_file(self, name: str) -> Path:
        """Where the puzzle `name` stands or would stand."""
        return self._file("puzzle", name, puzzle.ENDING)

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

    def puzzle(self, name: str) -> tuple[Puzzle | None, Faults]:
        """The puzzle `name`."""
        return _read(self.puzzle_file(name), name, puzzle.read)

    # -- to edit: opened with the text of the file, saved where that text still is

    def open_configuration(self, name: str) -> tuple[OpenedText[Configuration] | None, Faults]:
        """The configuration `name`, to be saved again."""
        return open_file(self.configuration_file(name), name, conf.read)

    def open_onikon(self, name: str, syntax: Syntax) -> tuple[OpenedText[Onikon] | None, Faults]:
        """The onikon `name`, to be saved again."""
        return open_file(self.onikon_file(name), name, partial(onk.read, syntax=syntax))

    def open_application(self, name: str, syntax: Syntax) -> tuple[OpenedText[Application] | None, Faults]:
        """The application `name`, to be saved again."""
        return open_file(self.application_file(name), name, partial(appl.read, syntax=syntax))

    def salvage_application(self, name: str, syntax: Syntax) -> tuple[OpenedText[Application] | None, Faults]:
        """The application `name` as far as its file can be read, also where that is at fault."""
        return open_file(self.application_file(name), name, partial(appl.salvage, syntax=syntax))

    def save_task(self, record: RmodText, task: Task | None = None, *, overwrites: bool = False) -> RmodText | Refusal:
        """Save a task with what `task` changes in it; a new record, and one under another name, is a new file.

        Refused where the file is no longer the record's text, unless the user `overwrites` it. Gives what was saved.
        """
        task = task or record.task
        is_new = not record.text or task.name != record.task.name
        expected = whole.ABSENT if is_new else whole.stamp(record.text)
        content = rmod.write(record, task)
        saved = put(self.task_file(task.name), task, content, whole.ANYTHING if overwrites else expected)
        if isinstance(saved, Refusal):
            return saved
        return RmodText(task, content)

    def save_configuration(
        self, configuration: Configuration, former: OpenedText[Configuration] | None = None, *, overwrites: bool = False
    ) -> OpenedText[Configuration] | Refusal:
        """Save a configuration opened as `former`, or a new one; see `opened.save`."""
        path = self.configuration_file(configuration.name)
        return save(path, configuration, conf.write, former, overwrites=overwrites)

    def save_onikon(
        self, onikon: Onikon, former: OpenedText[Onikon] | None = None, *, overwrites: bool = False
    ) -> OpenedText[Onikon] | Refusal:
        """Save an onikon opened as `former`, or a new one; see `opened.save`.

        A configuration and an application of one name would share it: whose icon it is first keeps it (reading 34).
        """
        path, name = self.onikon_file(onikon.name), onikon.name
        saved = save(path, onikon, onk.write, former, overwrites=overwrites)
        both = self.configuration_file(name).exists() and self.application_file(name).exists()
        if former is None and both and isinstance(saved, Refusal):
            rename = Reason.of("store.rename_either", name=name)
            return Refusal(Reason.of("store.icon_shared", reason=saved.reason, name=name), (rename, *saved.remedies))
        return saved

    def save_application(
        self, application: Application, former: OpenedText[Application] | None = None, *, overwrites: bool = False
    ) -> OpenedText[Application] | Refusal:
        """Save an application opened as `former`, or a new one; see `opened.save`."""
        path = self.application_file(application.name)
        return save(path, application, appl.write, former, overwrites=overwrites)

    def _file(self, folder: str, name: str, ending: str) -> Path:
        if not _is_name(name):
            raise ValueError(Reason.of("store.name_form", stem=repr(name)))
        return self.path / folder / (name + ending)

    def _files(self, folder: str, ending: str) -> list[Path]:
        """The files with this ending; hidden ones are nobody's, a folder that cannot be read holds none."""
        inside = self.path / folder
        try:
            names = os.listdir(inside)  # noqa: PTH208 - most files of a large folder have another ending
        except OSError:
            return []
        return [inside / name for name in sorted(names) if name.endswith(ending) and name[0] != "."]

    def _names(self, folder: str, ending: str) -> tuple[str, ...]:
        names = (path.name.removesuffix(ending) for path in self._files(folder, ending))
        return tuple(name for name in names if _is_name(name))


def _is_name(name: str) -> bool:
    return TASK_NAME.match(name) is not None


def _read(path: Path, name: str, read: Read[_T]) -> tuple[_T | None, Faults]:
    opened, faults = open_file(path, name, read)
    return (opened.value if opened else None), faults
