"""The history of a run: the last seconds of its variables, in bounded memory (requirement X06).

Every number, vector and small matrix of the tables is looked at on a grid of time, in virtual time as in wall time. It
is woken for that, so it is part of a run; it changes nothing in it. Where nothing has changed for as long as is kept,
it sleeps, lest a virtual clock on which nothing else stands run away; whatever is heard of a task wakes it.
"""

from collections import deque
from collections.abc import Callable, Mapping

from onika.runtime.table import Table, TableEntry, plain, value_of
from onika.wire import event
from onika.words.shape import Shape

MOST_NUMBERS = 64
"""A variable of more is a picture or a map; what it was seconds ago explains nothing and costs much."""


class VariableHistory:
    """Samples the tables of a run, by subsystem, every `every_ns`, and keeps `kept_ns` of that.

    `began_ns` is the instant at which the run began: the times of courses count from there.
    """

    def __init__(
        self, tables: Mapping[str, Table], every_ns: int = 50_000_000, kept_ns: int = 3_000_000_000, began_ns: int = 0
    ) -> None:
        if not 0 < every_ns <= kept_ns:
            raise ValueError(f"expected samples more often than every {kept_ns} ns, found every {every_ns} ns")
        self._tables = dict(tables)
        self._every, self._kept = every_ns, kept_ns // every_ns + 1
        self._began = began_ns
        self._sampled: dict[str, list[_VariableBatch]] = {name: [] for name in tables}
        self._entry_counts = dict.fromkeys(tables, 0)
        self._at: deque[int] = deque(maxlen=self._kept)
        self._next = 0
        self._unchanged_count = self._kept

    def wake_at(self) -> int | None:
        """When `tick` has something to do; None while it sleeps, as it does at first."""
        return None if self._unchanged_count >= self._kept else self._next

    def tick(self, now: int) -> None:
        """Look, if it is time; called more often, or as soon as something is heard of a task, it does no harm."""
        if now >= self._next:
            self._next = (now // self._every + 1) * self._every
            self.look(now)

    def look(self, now: int) -> None:
        """Look at this instant; a second time at the same instant sees what has changed in it."""
        is_new = not self._at or now > self._at[-1]
        if is_new:
            self._at.append(now)
        has_changed = False
        for name, batches in self._sampled.items():
            self._meet(name, batches)
            for batch in batches:
                has_changed |= batch.take(is_new)
        self._unchanged_count = 0 if has_changed else self._unchanged_count + 1

    def course(self, subsystem: str, variable: str, unit: str = "") -> event.Course | None:
        """The last seconds of a variable, oldest first; None where nothing was sampled of it."""
        for batch in self._sampled.get(subsystem, ()):
            values = batch.values(variable)
            if values:
                at = [round((sampled_ns - self._began) * 1e-9, 9) for sampled_ns in self._at]
                return event.Course(variable, unit, tuple(at[-len(values) :]), tuple(values))
        return None

    def _meet(self, name: str, batches: list["_VariableBatch"]) -> None:
        """Take up the variables that have come since; in a run none ever goes."""
        table = self._tables[name]
        if len(table.entries) != self._entry_counts[name]:
            met = {entry.name for batch in batches for entry in batch.entries}
            new = [entry for entry in table.entries.values() if entry.name not in met and _is_sampled(entry.shape)]
            self._entry_counts[name] = len(table.entries)
            if new:
                batches.append(_VariableBatch(table, new, self._kept))


class _VariableBatch:
    """The samples of variables that came together: each sample is a row of memory in which they lie side by side."""

    def __init__(self, table: Table, entries: list[TableEntry], kept: int) -> None:
        self.entries = entries
        self._row = bytearray(sum(entry.shape.size for entry in entries))
        self._rows: deque[bytes] = deque(maxlen=kept)
        self._refresh: list[Callable[[], None]] = []
        self._begins: dict[str, int] = {}
        self._since: dict[str, int] = {}
        self._taken = 0
        at = 0
        view = memoryview(self._row)
        for entry in entries:
            end = at + entry.shape.size
            self._refresh.append(table.ring(entry.name).refresher(view[at:end]))
            self._begins[entry.name] = at
            at = end
        self._unwritten = {entry.name: table.ring(entry.name) for entry in entries}

    def take(self, is_new: bool) -> bool:
        """Take a sample, a new one or in place of the last one; whether it differs from the one before."""
        if is_new or not self._rows:
            self._taken += 1
        else:
            self._rows.pop()
        if self._unwritten:
            self._look_for_first_values()
        for refresh in self._refresh:
            refresh()
        before, sample = self._rows[-1] if self._rows else b"", bytes(self._row)
        differs = sample != before
        self._rows.append(sample if differs else before)
        return differs

    def _look_for_first_values(self) -> None:
        """Before the sample is taken: what is written meanwhile is seen in it or in the next one."""
        for name in [name for name, ring in self._unwritten.items() if ring.count]:
            self._since[name] = self._taken
            del self._unwritten[name]

    def values(self, variable: str) -> list[object]:
        """What was sampled of a variable since it was first written, oldest first."""
        if variable not in self._since:
            return []
        shape = next(entry.shape for entry in self.entries if entry.name == variable)
        at = self._begins[variable]
        first = self._taken - len(self._rows) + 1
        rows = list(self._rows)[max(self._since[variable] - first, 0) :]
        return [plain(value_of(row[at : at + shape.size], shape)) for row in rows]


def _is_sampled(shape: Shape) -> bool:
    return (shape.type.is_real or shape.type.is_whole) and shape.count <= MOST_NUMBERS
