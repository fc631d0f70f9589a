"""A configuration: tasks assembled on the canvas to do one job (dissertation §5.3, §A.2)."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from onika.model.own_lines import NO_OWN_LINES, OwnLines
from onika.model.task import Task

UNKNOWN_RTPU = "unknown"
"""The RTPU of a task that was never spawned (reading 12)."""


@dataclass(frozen=True, slots=True)
class Placed:
    """A task on the canvas; x and y are pixels of its upper left corner."""

    task: str
    x: int = 0
    y: int = 0
    in_left: bool = True
    """Whether the inputs are on the left side of its icon."""
    frequency: float = 0.0
    """Hz, in place of the rate of the task's own file; 0: not given, or the task is aperiodic."""
    rtpu: str = UNKNOWN_RTPU
    own: OwnLines = NO_OWN_LINES
    """What it says otherwise here than its file does."""
    rmod: str = ""
    """The name of its file, where it stands under another name here."""

    @property
    def file(self) -> str:
        """The name of its `.rmod`, without the ending."""
        return self.rmod or self.task

    @property
    def is_as_filed(self) -> bool:
        """Whether it is what its file says, under the name of its file."""
        return not self.rmod and (self.own is NO_OWN_LINES or self.own == NO_OWN_LINES)

    def of(self, filed: Task) -> Task:
        """The task as it is placed here, made of what its file says."""
        task = self.own.on(filed)
        return task if task.name == self.task else replace(task, name=self.task)


@dataclass(frozen=True, slots=True)
class Locus:
    """Where the lines of one state variable meet: its corner in pixels and the pins that use it.

    An INBOTH counts in `double_in` only, an OUTBOTH in `outconst` only (reading 7).
    """

    svar: str
    x: int = 0
    y: int = 0
    conns: int = 0
    """How many tasks are connected."""
    inconst: int = 0
    outconst: int = 0
    invar: int = 0
    outvar: int = 0
    double_in: int = 0
    show: bool = True
    """Whether its connections are drawn."""


@dataclass(frozen=True, slots=True)
class Group:
    """A supermodule: tasks that are handled as one, in the order in which they are spawned and turned ON (§7, C17)."""

    name: str
    tasks: tuple[str, ...]


@dataclass(frozen=True)  # without slots: what follows from it is asked for again and again, and kept
class Configuration:
    """What a `.conf` file says, in the file's order."""

    name: str
    placed: tuple[Placed, ...] = ()
    loci: tuple[Locus, ...] = ()
    groups: tuple[Group, ...] = ()
    """Every task is in one at most, and every one has a task."""

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names of its tasks, in order."""
        return tuple(placed.task for placed in self.placed)

    @cached_property
    def meaning(self) -> tuple[Mapping[str, tuple[object, ...]], Mapping[str, tuple[str, ...]]]:
        """All of it but its looks: which tasks, how, at which rate, on which unit, and its supermodules."""
        tasks = {placed.task: (placed.frequency, placed.rtpu, placed.own, placed.rmod) for placed in self.placed}
        return tasks, {group.name: group.tasks for group in self.groups}

    @cached_property
    def otherwise(self) -> tuple[Placed, ...]:
        """The tasks that are otherwise here than their files say, or have other names."""
        own = [placed for placed in self.placed if placed.rmod or placed.own is not NO_OWN_LINES]  # nearly always none
        return tuple(placed for placed in own if not placed.is_as_filed)

    def tasks(self, filed: Mapping[str, Task]) -> dict[str, Task]:
        """The tasks as they are placed, by their names here; those whose files are missing in `filed` are left out."""
        return {placed.task: placed.of(filed[placed.file]) for placed in self.placed if placed.file in filed}

    def with_placed(self, placed: Sequence[Placed]) -> "Configuration":
        """With each of its tasks in another form, in their order; the supermodules have them under their new names."""
        names = {old.task: new.task for old, new in zip(self.placed, placed, strict=True)}
        groups = tuple(Group(group.name, tuple(names.get(task, task) for task in group.tasks)) for group in self.groups)
        return replace(self, placed=tuple(placed), groups=groups)

    def group(self, name: str) -> Group | None:
        """The supermodule of that name."""
        return next((group for group in self.groups if group.name == name), None)

    def regrouped(self, groups: Iterable[Group]) -> "Configuration":
        """With these groups as far as their tasks are placed; where one task is in several, the first counts."""
        left = set(self.names)
        kept_groups = []
        for group in groups:
            tasks = tuple(name for name in group.tasks if name in left)
            left.difference_update(tasks)
            if tasks:
                kept_groups.append(group if tasks == group.tasks else Group(group.name, tasks))
        if tuple(kept_groups) == self.groups:
            return self
        return replace(self, groups=tuple(kept_groups))

    def in_group_order(self, names: Iterable[str]) -> list[str]:
        """These tasks, those of a group in its order at the places which they have among the others."""
        ordered = list(names)
        for group in self.groups:
            members = set(group.tasks)
            places = [at for at, name in enumerate(ordered) if name in members]
            present = {ordered[at] for at in places}
            for at, name in zip(places, (task for task in group.tasks if task in present), strict=True):
                ordered[at] = name
        return ordered


def name_within(task: str, configuration: str) -> str:
    """The name of a task in a program in which another configuration says other things of it."""
    return f"{task}-{configuration}"[:200]
