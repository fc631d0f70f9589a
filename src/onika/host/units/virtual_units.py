"""The units of a runtime in virtual time: one executive carries out the tasks of all, and its news is told by unit."""

from collections import deque
from collections.abc import Callable, Mapping, Sequence

from msgspec import structs

from onika.host.sandbox.sandbox_end import SandboxEnd
from onika.host.sandbox.sandboxes import Sandboxes
from onika.runtime import command, news
from onika.runtime.execution.executive import Executive

_OF_UNITS = (news.Statuses, news.Loads)

Heard = Callable[[str, news.News], None]
"""Takes what a unit says."""


class VirtualUnits:
    """So that at one instant the order of law 1 holds among all tasks, whichever unit they are on."""

    def __init__(self, names: Sequence[str], views: Mapping[str, memoryview], watch: Callable[[str], None]) -> None:
        self.names = frozenset(names)
        self._begun = Sandboxes()
        self.executive = Executive("", views, watch)
        self.homes: dict[tuple[str, str], str] = {}
        """The unit of each task."""
        self._commands: deque[tuple[str, command.Command]] = deque()
        self._statuses: dict[str, news.Statuses] = {}

    @property
    def has_commands(self) -> bool:
        """Whether there are some that have not been carried out."""
        return bool(self._commands)

    def add(self, name: str) -> None:
        """One more unit."""
        self.names |= {name}

    def send(self, name: str, order: command.Command) -> None:
        """Give a unit a command; it is carried out when they are delivered.

        Raises ValueError where a task needs a sandbox and there is none.
        """
        spawn = order.spawn if isinstance(order, command.Swap) else order
        if isinstance(spawn, command.Spawn) and spawn.is_sandboxed:
            begun = self._begun.begin(spawn)
            sandbox = SandboxEnd(begun.post, begun.memory, begun.process)
            self.executive.give_sandbox((spawn.subsystem, spawn.task), sandbox)
        if isinstance(order, command.Spawn):
            order = structs.replace(order, cost_ns=0)  # it takes no virtual time
        elif isinstance(order, command.Swap):
            order = command.Swap(structs.replace(order.spawn, cost_ns=0))
        self._commands.append((name, order))

    def close(self) -> None:
        """End what was begun for tasks."""
        self._begun.close()

    def send_all(self, order: command.Command) -> None:
        """Give it to each unit."""
        for name in sorted(self.names):
            self.send(name, order)

    def deliver(self, now: int, heard: Heard) -> None:
        """Carry out commands until none is left, also those to which they lead."""
        while self._commands:
            name, order = self._commands.popleft()
            if isinstance(order, command.Spawn):
                self.homes[order.subsystem, order.task] = name
            if isinstance(order, command.Report):
                heard(name, self._statuses_of(name, now))
            else:
                self.tell(self.executive.handle(order, now), heard)

    def tell(self, newses: Sequence[news.News], heard: Heard) -> None:
        """Each of them as what the unit says that it is of."""
        for one in newses:
            if isinstance(one, _OF_UNITS):
                heard(one.rtpu, one)
            else:
                heard(self.homes.get((getattr(one, "subsystem", ""), getattr(one, "task", "")), ""), one)

    def _statuses_of(self, name: str, now: int) -> news.Statuses:
        """One unit's share of the statuses, which are taken of all units at once."""
        if name not in self._statuses:
            for one in self.executive.handle(command.Report(), now):
                if isinstance(one, news.Statuses):
                    self._statuses = {unit: self._share(one, unit) for unit in self.names}
        return self._statuses.pop(name)

    def _share(self, statuses: news.Statuses, name: str) -> news.Statuses:
        own = tuple(task for task in statuses.tasks if self.homes.get((task.subsystem, task.task)) == name)
        return news.Statuses(name, statuses.load, own)
