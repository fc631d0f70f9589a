"""The variables of a table that a black box has met: which have come since, and which are gone (requirement X05)."""

from collections.abc import Mapping

from onika.host.recording.last_seconds import TracedVariables
from onika.host.recording.recorded_variable import place_of
from onika.ring.segment import Segment
from onika.runtime.table import Table, TableEntry


class MetVariables:
    """Of one subsystem. Where tasks come and go, so do variables, and others may lie where they lay."""

    def __init__(self, subsystem: str, table: Table) -> None:
        self._subsystem = subsystem
        self._table = table
        self._met: dict[str, TableEntry] = {}
        self._changes = 0

    @property
    def memory(self) -> Segment:
        """Where they lie."""
        return self._table.segment

    def news(self, units: Mapping[str, str]) -> TracedVariables | None:
        """What has come and what is gone since the last call; None: nothing, which is told at once."""
        table = self._table
        if table.changes == self._changes:
            return None
        self._changes = table.changes
        gone = tuple(name for name, entry in self._met.items() if table.entries.get(name) is not entry)
        new = [entry for name, entry in table.entries.items() if self._met.get(name) is not entry]
        self._met = dict(table.entries)
        return TracedVariables(self._subsystem, tuple(place_of(entry, units) for entry in new), gone)
