"""The libraries that are open, with what was changed of their tasks in this session (requirements C01, C04)."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from onika.desk.environment.state import task_edit
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Placed
from onika.model.own_lines import OwnLines
from onika.model.preferences import Preferences
from onika.model.rules import agreement
from onika.model.rules.box import TaskBox, box_of
from onika.model.rules.placement import PlacedNeighbours
from onika.model.task import Task
from onika.store.library import Library
from onika.wire.sheet import ModuleSheet
from onika.words.reason import Reason

_SEEN = 32
"""Ways in which configurations see one and the same libraries that are kept."""


@dataclass(frozen=True)
class OpenLibraries:
    """Tasks by name, from the libraries in search order; the first of a name counts (reading 11)."""

    libraries: tuple[Library, ...] = ()
    edits: Mapping[str, Task] = field(default_factory=dict)
    """Tasks that are no longer as their files say."""
    rates: Mapping[str, float] = field(default_factory=dict)
    """Rates for later placements of this session, in Hz (reading 10)."""
    sheets: Mapping[str, ModuleSheet] = field(default_factory=dict)
    """What classes of modules declare, by the modules' names, as far as a runtime has read them."""
    digests: Mapping[str, str] = field(default_factory=dict)
    """By the modules' names: which code the sheet is of."""
    unread: Mapping[str, Reason] = field(default_factory=dict)
    """Why modules cannot be read, as a runtime says."""
    preferences: Preferences = field(default_factory=Preferences)
    files: Mapping[str, str] = field(default_factory=dict)
    """The names of the files of tasks that a configuration has under other names."""

    @cached_property
    def records(self) -> Mapping[str, RmodText]:
        """Every task with the text of its file."""
        texts: dict[str, RmodText] = {}
        for library in self.libraries:
            for name, record in library.tasks.items():
                texts.setdefault(name, record)
        return texts

    @cached_property
    def tasks(self) -> Mapping[str, Task]:
        """Every task as it is now."""
        return {name: self.edits.get(name, record.task) for name, record in self.records.items()}

    @cached_property
    def homes(self) -> Mapping[str, Library]:
        """The library of every task."""
        libraries: dict[str, Library] = {}
        for library in self.libraries:
            for name in library.tasks:
                libraries.setdefault(name, library)
        return libraries

    @cached_property
    def company(self) -> PlacedNeighbours:
        """The tasks by what may speak between them and a placed one."""
        return PlacedNeighbours(self.tasks.values())

    def within(self, configuration: Configuration) -> "OpenLibraries":
        """As a configuration sees them: with the lines and names of its own; the same object where it has none."""
        own = tuple(placed for placed in configuration.otherwise if placed.file in self.records)
        if not own:
            return self
        seen: dict[tuple[tuple[str, str, OwnLines], ...], OpenLibraries] = self.__dict__.setdefault("_seen", {})
        key = tuple((placed.task, placed.rmod, placed.own) for placed in own)
        if key not in seen:
            while len(seen) >= _SEEN:
                del seen[next(iter(seen))]
            seen[key] = self._with(own)
        return seen[key]

    def as_seen(self, configuration: Configuration) -> Configuration:
        """A configuration that says itself what was changed of its tasks here and stands in none of their files."""
        placed = tuple(self._as_seen(placed) for placed in configuration.placed)
        return configuration if placed == configuration.placed else replace(configuration, placed=placed)

    def task_file(self, name: str) -> Path:
        """The file of a task."""
        return self.homes[name].base.task_file(self.files.get(name, name))

    def code_file(self, name: str) -> Path | None:
        """The code of a task's module: beside its own file, else in the first library that has it; None: nowhere."""
        module, home = self.tasks[name].module, self.homes[name]
        library = next((library for library in (home, *self.libraries) if module in library.modules), None)
        return library.base.code_file(module) if library else None

    @cached_property
    def _boxes(self) -> dict[str, TaskBox]:
        return {}

    @cached_property
    def contested(self) -> Mapping[str, agreement.Users]:
        """The variables about which tasks disagree, as far as their modules are read."""
        read = {name: task for name, task in self.tasks.items() if task.module in self.sheets}
        return agreement.contested(
            {name: agreement.declared(task, self.sheets[task.module].ports) for name, task in read.items()}
        )

    @cached_property
    def rivals(self) -> Mapping[str, tuple[str, ...]]:
        """The devices that several tasks would move, as far as their modules are read."""
        sheets = self.sheets
        return agreement.rivals(
            task for task in self.tasks.values() if task.module in sheets and sheets[task.module].hardware
        )

    def box(self, name: str) -> TaskBox | None:
        """The icon of a task; None for one that no open library knows."""
        task = self.tasks.get(name)
        if task is None:
            return None
        if name not in self._boxes:
            self._boxes[name] = box_of(task, self.preferences)
        return self._boxes[name]

    def boxes(self, names: tuple[str, ...]) -> dict[str, TaskBox]:
        """The icons of those tasks that are known."""
        return {name: box for name in names if (box := self.box(name)) is not None}

    def edited(self, edits: Mapping[str, Task | None]) -> "OpenLibraries":
        """With tasks changed, or as their files say again where there is None."""
        wished = {name: self._onto(name, task) for name, task in edits.items()}
        kept = {name: task for name, task in {**self.edits, **wished}.items() if task is not None}
        forgotten = replace(self, edits={name: task for name, task in kept.items() if task != self.filed(name)})
        return forgotten._knowing(self, edits)

    def rated(self, rates: Mapping[str, float | None]) -> "OpenLibraries":
        """With rates for later placements, or those of their files again where there is None."""
        kept = {**self.rates, **rates}
        rated = replace(self, rates={name: hz for name, hz in kept.items() if hz is not None})._knowing(self, ())
        attributes = self.__dict__
        rated.__dict__.update({name: attributes[name] for name in ("tasks", "company") if name in attributes})
        return rated

    def filed(self, name: str) -> Task | None:
        """A task as its file says; None where there is none."""
        if name in self.records:
            return self.records[name].task
        return None

    def _as_seen(self, placed: Placed) -> Placed:
        filed = self.filed(placed.file)
        if filed is None or placed.file not in self.edits:
            return placed
        return replace(placed, own=OwnLines.between(filed, placed.of(self.edits[placed.file])))

    def _with(self, placed: Collection[Placed]) -> "OpenLibraries":
        """With these tasks as a configuration has them; what they differ in from their files is of it alone."""
        tasks = {each.task: each.of(self.tasks[each.file]) for each in placed}
        renamed = {each.task: each.file for each in placed if each.rmod}
        seen = replace(self, edits={**self.edits, **tasks}, files=renamed)._knowing(self, tasks)
        records = {
            name: RmodText(replace(self.records[file].task, name=name), self.records[file].text)
            for name, file in renamed.items()
        }
        seen.__dict__["records"] = {**self.records, **records}
        seen.__dict__["homes"] = {**self.homes, **{name: self.homes[file] for name, file in renamed.items()}}
        return seen

    def _onto(self, name: str, wished: Task | None) -> Task | None:
        """What the user changed of a task, put on its file as that is now: it may have changed meanwhile."""
        filed = self.filed(name)
        if wished is None or filed is None:
            return wished
        return task_edit.carried(wished, filed)

    def _knowing(self, former: "OpenLibraries", changed: Collection[str]) -> "OpenLibraries":
        """With what `former` has found out about the same libraries already."""
        attributes = former.__dict__
        self.__dict__.update({name: attributes[name] for name in ("records", "homes") if name in attributes})
        boxes = {name: box for name, box in attributes.get("_boxes", {}).items() if name not in changed}
        self.__dict__["_boxes"] = boxes
        return self
