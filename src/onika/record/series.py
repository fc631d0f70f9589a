"""One variable of a recording over time: each time at which it changed, with its value (X05)."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from onika.record import value
from onika.record.reader import Reader
from onika.words.shape import Shape


@dataclass(frozen=True, slots=True)
class Series:
    """A variable of a recording; it keeps a value until the next one."""

    reader: Reader
    topic: str
    subsystem: str
    name: str
    unit: str
    shape: Shape

    @classmethod
    def all_of(cls, reader: Reader) -> "dict[str, Series]":
        """Every variable, by `subsystem/NAME`."""
        series = {}
        for topic, channel in reader.channels.items():
            about = channel.metadata
            if "type" in about and "name" in about:
                home, name = about.get("subsystem", ""), about["name"]
                shape = Shape.parse(about["type"])
                series[f"{home}/{name}"] = cls(reader, topic, home, name, about.get("unit", ""), shape)
        return dict(sorted(series.items()))

    def at(self, at_ns: int) -> Any:
        """Its value at a time; None before the first one."""
        newest = self.reader.newest(self.topic, at_ns)
        if newest is None:
            return None
        return value.decode(newest[1], self.shape)

    def values(self, begin_ns: int = 0, end_ns: int = 1 << 63) -> Iterator[tuple[int, Any]]:
        """Its values from a time to before another, as they came."""
        for at, body in self.reader.messages(self.topic, begin_ns, end_ns):
            yield at, value.decode(body, self.shape)

    def flat(self, begin_ns: int = 0, end_ns: int = 1 << 63) -> Iterator[tuple[int, list[Any]]]:
        """The same, each value as the list of its elements, row by row."""
        for at, body in self.reader.messages(self.topic, begin_ns, end_ns):
            yield at, value.flat(body, self.shape)

    @property
    def is_picture(self) -> bool:
        """Whether it is a picture, of more bytes than anybody reads one by one."""
        return value.is_picture(self.shape)

    @property
    def labels(self) -> list[str]:
        """What its elements are called: NAME, NAME[0] …, NAME[1,2] …"""
        dims = [int(dim) for dim in self.shape.dims]
        if not dims:
            return [self.name]
        places = [""]
        for size in dims:
            places = [f"{place},{i}" if place else str(i) for place in places for i in range(size)]
        return [f"{self.name}[{place}]" for place in places]
