"""Loads an application with everything it needs from a site (§5.9.2)."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from onika.files import appl, text
from onika.model.application import Application, actions, every_flow
from onika.model.configuration import Configuration, Placed, name_within
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.opened_text import Faults
from onika.store.remote.library_fetcher import unfetched
from onika.store.site import Site
from onika.words.fault import Fault


@dataclass(frozen=True, slots=True)
class ApplicationProgram:
    """What a run needs, by name; what was not found is lacking. `faults` are those of the files read."""

    application: Application
    configurations: Mapping[str, Configuration]
    tasks: Mapping[str, Task]
    code: Mapping[str, Path]
    """The code file of every module of `tasks`, as far as there is one."""
    applications: Mapping[str, Application]
    """Those that nested icons run."""
    faults: Faults
    unread: frozenset[str] = frozenset()
    """Configurations, tasks and nested applications that were found and are at fault."""
    files: Mapping[str, str] = field(default_factory=dict)
    """The files of the nested applications."""
    task_files: Mapping[str, str] = field(default_factory=dict)
    """The names of the `.rmod` files of tasks that have other names in their configurations, or here."""


def load(path: Path, site: Site, syntax: Syntax) -> tuple[ApplicationProgram | None, Faults]:
    """The application in the file `path` with the configurations, tasks and code it needs; nothing else is read.

    The base directory of the file, if it lies in an `appl/`, comes before the search path (reading 35). None with
    the faults where the application itself cannot be read.
    """
    content, faults = text.load(path, str(path))
    if content is None:
        return None, faults
    application, faults = appl.read(content, path.name.removesuffix(appl.ENDING), str(path), syntax)
    if application is None:
        return None, faults
    program = gather(application, home_of(path, site), syntax, faults)
    return program, program.faults


def gather(application: Application, site: Site, syntax: Syntax, faults: Faults = ()) -> ApplicationProgram:
    """An application with the configurations, tasks and code it needs; `faults` are those of its own file."""
    return _Gathering(site, syntax).program(application, faults)


def joined(program: ApplicationProgram, names: Iterable[str], site: Site) -> ApplicationProgram:
    """A program with further tasks that may live in it, and their code; those that are nowhere are left out."""
    tasks, code, faults = dict(program.tasks), dict(program.code), list(program.faults)
    for name in names:
        record, faults_of_task = site.task(name) if name not in tasks else (None, ())
        faults += faults_of_task
        if record is None:
            continue
        tasks[name] = record.task
        path = site.code_file(record.task)
        if path is not None:
            code.setdefault(record.task.module, path)
    return replace(program, tasks=tasks, code=code, faults=tuple(faults))


def home_of(path: Path, site: Site) -> Site:
    """The site as the application in the file `path` sees it: its own base directory comes first (reading 35)."""
    folder = path.absolute().parent
    if folder.name == "appl":
        return site.at(folder.parent)
    return site


class _Gathering:
    """Reads what an application needs, every file once."""

    def __init__(self, site: Site, syntax: Syntax) -> None:
        self._site = site
        self._syntax = syntax
        self._configurations: dict[str, Configuration] = {}
        self._applications: dict[str, Application] = {}
        self._tasks: dict[str, Task] = {}
        self._seen: set[tuple[str, str]] = set()
        self._faults: list[Fault] = []
        self._unread: set[str] = set()
        self._files: dict[str, str] = {}
        self._filed: dict[str, Task] = {}
        self._task_files: dict[str, str] = {}

    def program(self, application: Application, faults: Faults) -> ApplicationProgram:
        self._faults += faults
        self._enter(application)
        paths = {task.module: self._site.code_file(task) for task in self._filed.values()}
        code = {module: path for module, path in paths.items() if path}
        self._faults += self._site.bring((*code.values(), *self._configuration_files()))
        self._faults += unfetched(code.values())
        faults_of_files = tuple(self._faults)
        unread = frozenset(self._unread)
        return ApplicationProgram(
            application,
            self._configurations,
            self._tasks,
            code,
            self._applications,
            faults_of_files,
            unread,
            self._files,
            self._task_files,
        )

    def _configuration_files(self) -> Iterator[Path]:
        for name in self._configurations:
            path = self._site.configuration_file(name)
            if path is not None:
                yield path

    def _enter(self, application: Application) -> None:
        """Read what an application needs, and what those nested in it do, however deep."""
        waiting = [application]
        while waiting:
            for _, flow in every_flow(waiting.pop()):
                for _, icon, _ in actions(flow, self._syntax):
                    kind = self._syntax.acting(icon.onikon.type)
                    if kind and kind.is_job:
                        self._configuration(icon.onikon.name)
                    elif kind and kind.is_application:
                        waiting += self._application(icon.onikon.name)

    def _configuration(self, name: str) -> None:
        if self._is_new("conf", name):
            configuration, faults = self._site.configuration(name)
            self._faults += faults
            if configuration:
                placed = [self._placed(placed, name) for placed in configuration.placed]
                self._configurations[name] = configuration.with_placed(placed)
            elif faults:
                self._unread.add(name)

    def _application(self, name: str) -> tuple[Application, ...]:
        """The application `name`, the first time it is asked for and as far as it can be read."""
        if not self._is_new("appl", name):
            return ()
        application, faults = self._site.application(name, self._syntax)
        self._faults += faults
        if application is None:
            self._unread |= {name} if faults else set()
            return ()
        self._applications[name] = application
        self._files[name] = str(self._site.application_file(name))
        return (application,)

    def _placed(self, placed: Placed, configuration: str) -> Placed:
        """A placed task under a name by which the program has what it is there.

        Where configurations say different things of one task, each has its own: two of them in one flow are a fault
        like any module that stands there twice.
        """
        filed = self._task(placed.file)
        if filed is None:
            self._unread |= {placed.task} if placed.file in self._unread else set()
            return placed
        task = placed.of(filed)
        name = placed.task
        if self._tasks.setdefault(name, task) != task:
            name = name_within(name, configuration)
            self._tasks[name] = replace(task, name=name)
        if name != placed.file:
            self._task_files[name] = placed.file
        return placed if name == placed.task else replace(placed, task=name, rmod=placed.file)

    def _task(self, file: str) -> Task | None:
        """A task as its file says; each file is read once."""
        if self._is_new("module", file):
            record, faults = self._site.task(file)
            self._faults += faults
            if record:
                self._filed[file] = record.task
            elif faults:
                self._unread.add(file)
        return self._filed.get(file)

    def _is_new(self, folder: str, name: str) -> bool:
        is_new = (folder, name) not in self._seen
        self._seen.add((folder, name))
        return is_new
