"""Looks up tasks, code and targets on the search path for a console, with a fault where there is none."""

from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from pathlib import Path

import msgspec

from onika.desk.plan.compile import UNKNOWN, planned_task
from onika.desk.plan.declarations import declared_inputs, declared_ports
from onika.desk.plan.module_code import module_code
from onika.desk.plan.target_inputs import measured_kinds
from onika.model.configuration import Configuration, Placed
from onika.model.syntax import IconType, Syntax
from onika.model.task import Task
from onika.store.remote.library_fetcher import unfetched
from onika.store.site import Site
from onika.store.world_source import sources_of
from onika.wire.plan import Code, PlannedTask
from onika.wire.sheet import PortSheet
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of

Faults = tuple[Fault, ...]
_INSTEAD = Reason.of("words.nothing_changed")


class SiteLibrary:
    """What a site offers; reads anew each time, so that an edited file counts at once. Faults stand at `place`."""

    def __init__(self, site: Site, place: Place) -> None:
        self._site = site
        self._place = place

    @property
    def tasks(self) -> tuple[str, ...]:
        """The names of all tasks, in order."""
        return _names(base.tasks for base in self._site.directories)

    @property
    def configurations(self) -> tuple[str, ...]:
        """The names of all configurations, in order."""
        return _names(base.configurations for base in self._site.directories)

    @property
    def applications(self) -> tuple[str, ...]:
        """The names of all applications, in order."""
        return _names(base.applications for base in self._site.directories)

    def task(self, name: str) -> tuple[Task | None, Faults]:
        """A task by its name."""
        record, faults = self._site.task(name)
        if record is None:
            return None, faults or self._none(Reason.of("desk.a_task"), name, self.tasks)
        return record.task, faults

    def worlds(self, tasks: Iterable[PlannedTask]) -> tuple[tuple[WorldSource, ...], Faults]:
        """The files of the worlds in which tasks have devices, of those that are files."""
        return sources_of(tasks, self._site)

    def configuration(self, name: str) -> tuple[Configuration | None, Faults]:
        """A configuration by its name."""
        configuration, faults = self._site.configuration(name)
        if configuration is None:
            return None, faults or self._none(Reason.of("desk.a_configuration"), name, self.configurations)
        return configuration, faults

    def planned(
        self, name: str, rtpu: str = UNKNOWN, placed: Placed | None = None
    ) -> tuple[PlannedTask | None, Code | None, Faults]:
        """A task as a runtime takes it, and its code; None with the faults where one of them is missing.

        placed    as which a configuration has it
        """
        task, faults = self.task(name)
        home = self._site.home_of_task(name)
        if task is None or home is None or faults:
            return None, None, faults
        file = str(home.task_file(name))
        path = self._site.code_file(task)
        if path is None:
            return None, None, (Fault(Place(file), Reason.of("desk.code_not_on_path", module=task.module), _INSTEAD),)
        faults = (*self._site.bring((path,)), *unfetched((path,)))
        if faults:
            return None, None, faults
        code, faults = self.code(task.module, path)
        if code is None:
            return None, None, faults
        return planned_task(placed.of(task) if placed else task, rtpu, code.digest, file), code, ()

    @property
    def ports(self) -> Iterator[tuple[Task, tuple[PortSheet, ...]]]:
        """The ports of all tasks, as far as their code says them."""
        return ((task, declared_ports(code)) for task, code in self._coded())

    def target_kinds(self, syntax: Syntax) -> list[tuple[IconType, dict[str, str]]]:
        """The types of targets that have data, each with the units of these as the tasks say them that take it."""
        return measured_kinds(syntax, [(task, declared_inputs(code)) for task, code in self._coded()])

    def code(self, module: str, path: Path) -> tuple[Code | None, Faults]:
        """The code of a module as it stands in a file now."""
        try:
            source = path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as wrong:
            return None, (
                Fault(
                    Place(str(path)), Reason.of("desk.source_unreadable", module=module, why=reason_of(wrong)), _INSTEAD
                ),
            )
        return module_code(module, path, source), ()

    def arguments(self, text: str) -> tuple[str, Faults]:
        """An argument line: as it is, or the values of a target where it says `@TARGET`."""
        if not text.startswith("@"):
            return text, ()
        types, faults = self._site.syntax()
        if types is None:
            return "", faults
        onikon, faults = self._site.onikon(text[1:], types)
        if onikon is None:
            names = _names(base.onikons for base in self._site.directories)
            return "", faults or self._none(Reason.of("desk.a_target"), text[1:], names)
        if not onikon.values:
            return "", (Fault(self._place, Reason.of("desk.target_without_values", text=text), _INSTEAD),)
        return onikon.argument_line(types), faults

    def _coded(self) -> Iterator[tuple[Task, Path]]:
        """All tasks that have code."""
        for name in self.tasks:
            record, _ = self._site.task(name)
            path = self._site.code_file(record.task) if record else None
            if record is not None and path is not None:
                yield record.task, path

    def _none(self, what: Reason, name: str, names: tuple[str, ...]) -> Faults:
        near = get_close_matches(name, names, 3)
        if near:
            wanted = Reason.of("desk.near", what=what, names=tuple(near))
        else:
            wanted = Reason.of("desk.there_are", what=what, count=len(names))
        return (Fault(self._place, Reason.of("desk.not_on_search_path", what=wanted, name=name), _INSTEAD),)


def altered(task: PlannedTask, name: str, frequency: float | None) -> PlannedTask:
    """A planned task under another name or at another rate, where they are given."""
    return msgspec.structs.replace(task, name=name or task.name, frequency=frequency or task.frequency)


def _names(several: Iterable[tuple[str, ...]]) -> tuple[str, ...]:
    return tuple(sorted({name for names in several for name in names}))
