"""A variable that is recorded: what was written is taken at each look, and put into words later, many at once."""

from collections.abc import Mapping
from itertools import islice

from msgspec import Struct

from onika.record import topics, value
from onika.record.writer import Writer
from onika.ring.slots import Ring
from onika.runtime.table import Table, TableEntry
from onika.words.shape import Shape

_LONG = 512
"""Bytes of a value that is not kept until there are more of them."""


class VariablePlace(Struct, frozen=True):
    """Where a variable lies in the table of its subsystem."""

    name: str
    shape: str
    unit: str
    offset: int


def places_of(table: Table, first: int, units: Mapping[str, str]) -> tuple[VariablePlace, ...]:
    """The variables of a table from this number on, in the order in which they came."""
    return tuple(place_of(entry, units) for entry in islice(table.entries.values(), first, None))


def place_of(entry: TableEntry, units: Mapping[str, str]) -> VariablePlace:
    """Where an entry of a table lies."""
    return VariablePlace(entry.name, str(entry.shape), units.get(entry.name, ""), entry.offset)


class VariableRecorder:
    """`words[0]` counts what was written."""

    def __init__(
        self, subsystem: str, variable: VariablePlace, memory: memoryview, writer: Writer, *, is_late: bool = False
    ) -> None:
        """Where it is looked at late, of what was written before only the newest value is taken."""
        self.subsystem = subsystem
        self.name = variable.name
        shape = Shape.parse(variable.shape)
        ring = Ring(memory, variable.offset, shape.size)
        about = {"subsystem": subsystem, "name": variable.name, "type": variable.shape, "unit": variable.unit}
        schema = (value.title(shape, variable.unit), value.schema(shape, variable.unit))
        self._channel = writer.channel(topics.variable(subsystem, variable.name), *schema, about)
        self._messages = writer.messages
        self._encoded = value.encoder(shape)
        self._is_long = shape.size > _LONG
        self._since = ring.since
        self._seen = max(ring.count - 1, 0) if is_late else 0
        self._last = b""
        self._times: list[int] = []
        self._values: list[bytes] = []
        self.words = ring.words
        self.missed = 0
        """Values that were written over before anybody looked."""

    def take(self, now: int, before: int) -> None:
        """What was written since the last look, where it has changed; times are shared evenly between the looks."""
        count, values = self._since(self._seen)
        if count - self._seen != len(values):
            if count < self._seen:  # the entry was made anew
                count, values = self._since(0)
            else:
                self.missed += count - self._seen - len(values)
        self._seen = count
        apart = (now - before) // len(values) if before >= 0 and values else 0
        at = now - apart * (len(values) - 1)
        for data in values:
            if data != self._last:
                self._last = data
                self._times.append(at)
                self._values.append(data)
            at += apart
        if self._is_long:
            self.settle()

    def settle(self) -> None:
        """Write down what was taken."""
        if self._values:
            self._messages(self._channel, self._times, self._encoded(self._values))
            self._times, self._values = [], []
