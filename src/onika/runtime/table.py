"""The state-variable table of a subsystem: named entries of fixed type and shape in shared memory (laws 4, 7)."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from msgspec import Struct

from onika.ring.segment import Segment
from onika.ring.slots import Ring
from onika.words import letters
from onika.words.reason import Reason
from onika.words.shape import Shape
from onika.words.value import ValueType

SIZE = 1 << 26
"""Bytes reserved for a table; untouched ones cost nothing."""


class TableEntry(Struct, frozen=True):
    """Where a variable lies in its table, and its resolved shape."""

    name: str
    shape: Shape
    offset: int


HEAD = 64
"""Bytes before the first entry: the first word is the time until which inputs of hardware are watched (law 33)."""


class Table:
    """One writer of the directory (the runner); variables are read and written wherever the segment is shared."""

    def __init__(self, segment: Segment) -> None:
        self.segment = segment
        self.entries: dict[str, TableEntry] = {}
        self.changes = 0
        """How often an entry was made, dropped or put back."""
        self._rings: dict[str, Ring] = {}
        self._end = HEAD
        self._free: dict[int, list[int]] = {}

    def entry(self, name: str, shape: Shape) -> TableEntry:
        """The entry of a variable, made zeroed at first; raises ValueError where the shape differs from the entry's."""
        entry = self.entries.get(name)
        if entry is not None:
            if entry.shape != shape:
                raise ValueError(Reason.of("runtime.shape_here", name=name, shape=str(entry.shape), given=str(shape)))
            return entry
        entry = TableEntry(name, shape, self._room(name, shape))
        self.entries[name] = entry
        self.changes += 1
        self._rings[name] = Ring(self.segment.view, entry.offset, shape.size)
        self._rings[name].arm()
        return entry

    def close(self) -> None:
        """Give the memory back at once, not only when nobody happens to refer to this table any more."""
        for ring in self._rings.values():
            ring.release()
        self._rings.clear()
        self.entries.clear()
        self.segment.close()

    def drop(self, name: str) -> TableEntry:
        """Forget a variable; its memory stays as it is until it is freed, for tasks that are bound to it still."""
        del self._rings[name]
        self.changes += 1
        return self.entries.pop(name)

    def put_back(self, entry: TableEntry) -> None:
        """Know a dropped variable again, whose memory was not freed."""
        self.entries[entry.name] = entry
        self.changes += 1
        self._rings[entry.name] = Ring(self.segment.view, entry.offset, entry.shape.size)

    def free(self, entry: TableEntry) -> None:
        """Give the memory of a dropped entry back, zeroed; nobody is bound to it any more."""
        need = Ring.footprint(entry.shape.size)
        self.segment.view[entry.offset : entry.offset + need] = bytes(need)
        self._free.setdefault(need, []).append(entry.offset)

    def ring(self, name: str) -> Ring:
        """The ring of a known variable."""
        return self._rings[name]

    def value(self, name: str) -> Any:
        """A copy of a variable as module authors see it; raises KeyError if unknown."""
        return value_of(self._rings[name].read(), self.entries[name].shape)

    def values(self, names: Iterable[str]) -> dict[str, Any]:
        """Copies of those variables that are there."""
        return {name: self.value(name) for name in names if name in self.entries}

    def _room(self, name: str, shape: Shape) -> int:
        need = Ring.footprint(shape.size)
        if self._free.get(need):
            return self._free[need].pop()
        if self._end + need > self.segment.size:
            raise ValueError(Reason.of("runtime.table_full", size=self.segment.size, name=name, shape=str(shape)))
        self._end += need
        return self._end - need

    @property
    def end(self) -> int:
        """Where the memory begins that no entry has taken yet."""
        return self._end

    @property
    def is_zeroed(self) -> bool:
        """Whether nothing was ever written."""
        return all(ring.count == 0 for ring in self._rings.values())


def value_of(data: bytes, shape: Shape) -> Any:
    """The bytes of an entry as number, str, list of str or array."""
    if shape.type.is_text or shape.type is ValueType.CHAR:
        return letters.decode(data, shape.type, bool(shape.dims))
    array = np.frombuffer(data, dtype=shape.type.code)
    if not shape.dims:
        return array[0].item()
    return array.reshape(shape.dims)


def plain(value: Any) -> Any:
    """A value that travels: arrays as lists."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    return value
