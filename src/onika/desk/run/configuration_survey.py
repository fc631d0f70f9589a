"""What is wrong with a configuration whose file can be read: its tasks together, and each by itself (C26, law 9)."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from onika.desk.plan.module_code import module_code
from onika.files import conf, text
from onika.files.line import parse_line
from onika.model.configuration import Configuration
from onika.model.rules import agreement, conflict
from onika.model.task import Task
from onika.store.site import Site
from onika.wire.plan import Code
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

Describe = Callable[[tuple[Code, ...]], Mapping[str, ModuleSheet]]
"""Tells what modules declare, by the digests of their code; what cannot be read is lacking, and told elsewhere."""

_NO_JOB = Reason.of("desk.no_job_of_it")


@dataclass(frozen=True, slots=True)
class SurveyedConfiguration:
    """A configuration, its file, and its tasks as far as there are any."""

    file: Path
    configuration: Configuration
    tasks: Mapping[str, Task]
    code: Mapping[str, Code]
    """By modules."""
    lines: Mapping[str, int]
    """Where each task stands in the file."""

    @classmethod
    def of(cls, file: Path, site: Site) -> "SurveyedConfiguration | None":
        """The one in a file; None where it cannot be read, which is told of the file itself."""
        content, _ = text.load(file, str(file))
        configuration = None if content is None else conf.read(content, file.stem, str(file))[0]
        if content is None or configuration is None:
            return None
        here = site.at(file.absolute().parent.parent)
        records = {placed.file: here.task(placed.file)[0] for placed in configuration.placed}
        filed = {name: record.task for name, record in records.items() if record is not None}
        paths = {task.module: here.code_file(task) for task in filed.values()}
        code = {module: code for module, path in paths.items() if path and (code := _code(module, path))}
        return cls(file, configuration, configuration.tasks(filed), code, _lines(content))

    @property
    def needs_modules(self) -> bool:
        """Whether only the code of its modules tells all: what several tasks take a variable for."""
        return len(self.tasks) > 1 and bool(self.code)

    def faults(self, site: Site, describe: Describe) -> Iterator[Fault]:
        """Tasks that are nowhere, that may not stand together, or that disagree on what they share."""
        here = site.at(self.file.absolute().parent.parent)
        for placed in self.configuration.placed:
            if here.home_of_task(placed.file) is None:
                reason = Reason.of("desk.tasks_not_on_path", name=placed.file)
                yield self._fault(placed.task, reason, Reason.of("words.left_out"))
        for later, _, refusals in conflict.conflicts(list(self.tasks.values())):
            for refusal in refusals:
                yield self._fault(later.name, Reason.of("desk.may_not_stand", task=later.name, why=refusal.reason))
        if self.needs_modules:
            yield from self._disagreements(describe(tuple(self.code.values())))

    def _disagreements(self, sheets: Mapping[str, ModuleSheet]) -> Iterator[Fault]:
        by_module = {module: sheets[code.digest] for module, code in self.code.items() if code.digest in sheets}
        known = {name: task for name, task in self.tasks.items() if task.module in by_module}
        declared = {name: agreement.declared(task, by_module[task.module].ports) for name, task in known.items()}
        for svar, users in agreement.contested(declared).items():
            first, *others = users
            for name in others:
                for refusal in agreement.disagreements(name, svar, users, (first,)):
                    yield self._fault(name, Reason.of("desk.may_not_stand", task=name, why=refusal.reason))
        hardware = (task for task in known.values() if by_module[task.module].hardware)
        for device, (first, *others) in agreement.rivals(hardware).items():
            for name in others:
                for refusal in agreement.claims(name, device, (first,)):
                    yield self._fault(name, Reason.of("desk.may_not_stand", task=name, why=refusal.reason))

    def _fault(self, task: str, reason: Reason, instead: Reason = _NO_JOB) -> Fault:
        return Fault(Place(str(self.file), self.lines.get(task, 0)), reason, instead)


def need_modules(configurations: Iterable[SurveyedConfiguration]) -> bool:
    """Whether only the code of modules tells all that is wrong with some configurations."""
    return any(configuration.needs_modules for configuration in configurations)


def judged(configurations: Iterable[SurveyedConfiguration], site: Site, describe: Describe) -> list[Fault]:
    """All that is wrong with some configurations."""
    return [fault for configuration in configurations for fault in configuration.faults(site, describe)]


def surveyed(files: Sequence[Path], site: Site) -> list[SurveyedConfiguration]:
    """Those among files that can be read."""
    read = (SurveyedConfiguration.of(file, site) for file in files)
    return [configuration for configuration in read if configuration is not None]


def _code(module: str, path: Path) -> Code | None:
    source, _ = text.load(path, str(path))
    return None if source is None else module_code(module, path, source)


def _lines(content: str) -> dict[str, int]:
    """The line of each task, by the name that it has there."""
    lines: dict[str, int] = {}
    head = 0
    for number, raw in enumerate(content.splitlines(), start=1):
        line = parse_line(number, raw)
        if line is not None and line.keyword == "RMODFILE":
            head = number
            lines.setdefault(line.rest, number)
        elif line is not None and line.keyword == "AS":
            lines[line.rest] = head
    return lines
