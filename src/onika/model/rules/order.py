"""The order of tasks: who runs first in a cycle and who is spawned first, read off their ports (laws 1 and 10)."""

import heapq
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Protocol, Self

from msgspec import Struct

from onika.words.name import resolve


class PortLists(Protocol):
    """Whatever describes a task by its coded names and aliases."""

    @property
    def name(self) -> str:
        """The task's name."""

    @property
    def aliases(self) -> tuple[tuple[str, str], ...]:
        """Pairs of coded name and state variable."""

    @property
    def inconst(self) -> tuple[str, ...]:
        """Read at initialisation."""

    @property
    def outconst(self) -> tuple[str, ...]:
        """Written at initialisation."""

    @property
    def invar(self) -> tuple[str, ...]:
        """Read before every cycle."""

    @property
    def outvar(self) -> tuple[str, ...]:
        """Written after every cycle."""


class Ports(Struct, frozen=True):
    """The state variables of a task, aliases resolved; an INBOTH stands in two lists, so does an OUTBOTH."""

    name: str
    inconst: tuple[str, ...] = ()
    outconst: tuple[str, ...] = ()
    invar: tuple[str, ...] = ()
    outvar: tuple[str, ...] = ()

    @classmethod
    def of(cls, task: PortLists) -> Self:
        """The ports of a task under the names of the table."""
        aliases = dict(task.aliases)
        lists = (task.inconst, task.outconst, task.invar, task.outvar)
        return cls(task.name, *(resolve(names, aliases) for names in lists))


def rank(tasks: Sequence[Ports], hardware: Collection[str]) -> dict[str, int]:
    """The place of each task in a cycle, 0 first: writers before readers of an INVAR, hardware tasks as sources.

    Every loop is cut at the hardware task, which reads what was written one period ago. Tasks on a loop without
    hardware keep the order of `tasks`, and so do tasks that do not depend on each other (reading 14).
    """
    readers = {task.name: () if task.name in hardware else task.invar for task in tasks}
    groups = _ordered(tasks, _suppliers(readers, {task.name: task.outvar for task in tasks}))
    return {name: place for place, name in enumerate(name for group in groups for name in group)}


def constant_order(tasks: Sequence[Ports]) -> tuple[list[str], list[list[str]]]:
    """The order of spawning, suppliers of constants before their consumers, and the cycles among them.

    INBOTH and OUTBOTH count as constants here. The tasks of a cycle stand together in the order of `tasks`; a
    task that supplies its own constant is a cycle of one. A constant that nobody supplies orders nothing.
    """
    suppliers = _suppliers(
        {task.name: task.inconst for task in tasks}, {task.name: task.outconst for task in tasks}, own=True
    )
    groups = _ordered(tasks, suppliers)
    cycles = [group for group in groups if len(group) > 1 or group[0] in suppliers[group[0]]]
    return [name for group in groups for name in group], cycles


def _suppliers(
    inputs: Mapping[str, tuple[str, ...]], outputs: Mapping[str, tuple[str, ...]], own: bool = False
) -> dict[str, list[str]]:
    """For each task, those that write what it reads; itself only if `own`."""
    writers: dict[str, list[str]] = {}
    for task, names in outputs.items():
        for name in names:
            writers.setdefault(name, []).append(task)
    refusals = {
        task: dict.fromkeys(writer for name in names for writer in writers.get(name, ()))
        for task, names in inputs.items()
    }
    return {task: [writer for writer in writers if own or writer != task] for task, writers in refusals.items()}


def _ordered(tasks: Sequence[Ports], suppliers: Mapping[str, Sequence[str]]) -> list[list[str]]:
    """Groups of tasks, suppliers first; a group is a single task or those that supply each other in a loop."""
    position = {task.name: place for place, task in enumerate(tasks)}
    groups = [sorted(group, key=position.__getitem__) for group in _loops(position, suppliers)]
    waits_for = _waiting(groups, suppliers)
    frees: list[list[int]] = [[] for _ in groups]
    for number, waiting in enumerate(waits_for):
        for supplier in waiting:
            frees[supplier].append(number)
    ready = [(position[group[0]], n) for n, group in enumerate(groups) if not waits_for[n]]
    heapq.heapify(ready)
    ordered = []
    while ready:
        _, number = heapq.heappop(ready)
        ordered.append(groups[number])
        for freed in frees[number]:
            waits_for[freed].discard(number)
            if not waits_for[freed]:
                heapq.heappush(ready, (position[groups[freed][0]], freed))
    return ordered


def _waiting(groups: Sequence[Sequence[str]], suppliers: Mapping[str, Sequence[str]]) -> list[set[int]]:
    """For each group the others that supply it."""
    home = {name: number for number, group in enumerate(groups) for name in group}
    every = ({home[supplier] for name in group for supplier in suppliers[name]} for group in groups)
    return [supplying - {number} for number, supplying in enumerate(every)]


def _loops(names: Iterable[str], suppliers: Mapping[str, Sequence[str]]) -> list[list[str]]:
    """The strongly connected groups (Kosaraju, without recursion)."""
    consumers: dict[str, list[str]] = {name: [] for name in names}
    for name, suppliers_of in suppliers.items():
        for supplier in suppliers_of:
            consumers[supplier].append(name)
    seen: set[str] = set()
    left = [name for start in consumers for name in _walk(start, suppliers, seen)]
    seen = set()
    walks = (list(_walk(start, consumers, seen)) for start in reversed(left))
    return [group for group in walks if group]


def _walk(start: str, onward: Mapping[str, Sequence[str]], seen: set[str]) -> list[str]:
    """All not yet seen names that can be reached, each after those reached through it; adds them to `seen`."""
    if start in seen:
        return []
    seen.add(start)
    left = []
    path = [(start, iter(onward[start]))]
    while path:
        name, rest = path[-1]
        following = next((other for other in rest if other not in seen), None)
        if following is None:
            left.append(name)
            path.pop()
        else:
            seen.add(following)
            path.append((following, iter(onward[following])))
    return left
