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
"""Bytes of a value that is not kept until there are more of them; its entry keeps three."""


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


_Piece = tuple[int, int, int, bytes]
"""What came between two looks: their times, so many values, and the slots in which they lay."""


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
        self.is_long = shape.size > _LONG
        self._stretch, self._stride, self._size = ring.stretch, ring.stride, shape.size
        self._seen = max(ring.count - 1, 0) if is_late else 0
        self._last = b""
        self._pieces: list[_Piece] = []
        self.words = ring.words
        self.missed = 0
        """Values that were written over before anybody looked."""

    @property
    def is_short_lived(self) -> bool:
        """Whether its entry keeps few values, and it is more than a constant that was written once."""
        return self.is_long and self.words[0] != 1

    def take(self, now: int, before: int) -> None:
        """What was written since the last look, as it lies in memory: it is taken apart later, many at once."""
        count, number, slots = self._stretch(self._seen)
        if count < self._seen:  # the entry was made anew
            count, number, slots = self._stretch(0)
        else:
            self.missed += count - self._seen - number
        self._seen = count
        self._pieces.append((before, now, number, slots))
        if self.is_long:
            self.settle()

    def settle(self) -> None:
        """Write down what was taken, where it has changed; times are shared evenly between two looks."""
        if not self._pieces:
            return
        times: list[int] = []
        values: list[bytes] = []
        last, size, stride = self._last, self._size, self._stride
        for before, now, number, slots in self._pieces:
            apart = (now - before) // number if before >= 0 and number else 0
            at = now - apart * (number - 1)
            for begin in range(0, len(slots), stride):
                data = slots[begin : begin + size]
                if data != last:
                    last = data
                    times.append(at)
                    values.append(data)
                at += apart
        self._last, self._pieces = last, []
        if values:
            self._messages(self._channel, times, self._encoded(values))
