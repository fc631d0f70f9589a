"""Other shapes for variables whose dimensions have changed, while their tasks live (law 12, requirement A03)."""

from onika.runtime.command import BoundPort
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import Table, TableEntry
from onika.words.shape import Shape


class Reshaping:
    """New entries in a table; the old ones are freed when every task is bound to the new ones."""

    def __init__(self, table: Table) -> None:
        self._table = table
        self._stale: list[TableEntry] = []

    @property
    def has_changed(self) -> bool:
        """Whether any variable has another shape since the last `end`."""
        return bool(self._stale)

    def ports(self, subsystem: RunningSubsystem, task: str) -> tuple[BoundPort, ...]:
        """All ports of a task as its constants shape them now, if one of them has changed; else none."""
        bound = []
        for port in subsystem.members[task].wired.ports:
            shape = port.shape.resolve({name: subsystem.dimension(name) for name in port.shape.names})
            entry = self._entry(port.svar, shape)
            bound.append(BoundPort(port.port, port.svar, str(entry.shape), entry.offset))
        changed = {entry.name for entry in self._stale}
        if any(bound_port.svar in changed for bound_port in bound):
            return tuple(bound)
        return ()

    def end(self) -> None:
        """Give back the memory of the old entries: nobody is bound to them any more."""
        for entry in self._stale:
            self._table.free(entry)
        self._stale.clear()

    def undo(self) -> None:
        """As it was: nobody who lives on has been bound anew, so the old entries count again, with their values."""
        for entry in reversed(self._stale):
            if entry.name in self._table.entries:
                self._table.free(self._table.drop(entry.name))
            self._table.put_back(entry)
        self._stale.clear()

    def _entry(self, svar: str, shape: Shape) -> TableEntry:
        entry = self._table.entries.get(svar)
        if entry is not None and entry.shape != shape:
            self._stale.append(self._table.drop(svar))
        return self._table.entry(svar, shape)
