"""The values of a variable at every cycle, put together of what a runtime answers (requirements C14, C27)."""

from dataclasses import dataclass, field
from itertools import product

from onika.wire.samples import SampleTrace
from onika.words.shape import Shape


@dataclass(slots=True)
class SampleSeries:
    """Times in ns, and of each the elements of the value, row by row."""

    variable: str
    shape: Shape | None = None
    times: list[int] = field(default_factory=list)
    rows: list[list[float]] = field(default_factory=list)
    last: int = 0
    """The number of the last value that came."""
    missed: int = 0
    """How many values between the first and the last never came."""

    def take(self, trace: SampleTrace) -> bool:
        """Append what came; False: nothing."""
        if not trace.stretches:
            return False
        import numpy as np  # within: it takes long to load, and consoles rarely sample

        shape = self.shape = Shape.parse(trace.type)
        values = np.frombuffer(trace.values, dtype=shape.type.code).reshape(-1, shape.count)
        self.rows += values.astype(float).tolist()
        for stretch in trace.stretches:
            if 0 < self.last < stretch.first:  # else they are counted anew
                self.missed += stretch.first - self.last - 1
            self.last = stretch.first + stretch.count - 1
            self.times += [stretch.begin_ns + place * stretch.step_ns for place in range(stretch.count)]
        return True

    def cut(self, begin_ns: int, end_ns: int) -> None:
        """Keep what came within these times, both included."""
        kept = [place for place, at in enumerate(self.times) if begin_ns <= at <= end_ns]
        self.times, self.rows = [self.times[place] for place in kept], [self.rows[place] for place in kept]


def columns(name: str, shape: Shape | None) -> list[str]:
    """What stands above the elements of a variable: `NAME`, `NAME[2]`, `NAME[1,2]`."""
    if shape is None:
        return []
    if not shape.dims:
        return [name]
    return [f"{name}[{','.join(map(str, place))}]" for place in product(*(range(int(count)) for count in shape.dims))]


def csv(series: list[SampleSeries], origin_ns: int = 0) -> str:
    """A line for each instant at which anything was written, from `origin_ns` on; what was not written then is empty.

    As RFC 4180 wants it; times in seconds to the microsecond.
    """
    heads = [columns(one.variable, one.shape) for one in series]
    moments: dict[int, dict[int, list[float]]] = {}
    for place, one in enumerate(series):
        for at, row in zip(one.times, one.rows, strict=True):
            moments.setdefault(round((at - origin_ns) / 1000), {})[place] = row
    lines = [",".join(["t_s", *(_quoted(head) for one in heads for head in one)])]
    for moment in sorted(moments):
        rows = moments[moment]
        cells = [repr(value) for place, head in enumerate(heads) for value in rows.get(place, [None] * len(head))]
        lines.append(",".join([f"{moment / 1e6:.6f}", *("" if cell == "None" else cell for cell in cells)]))
    return "".join(line + "\r\n" for line in lines)


def _quoted(head: str) -> str:
    return f'"{head}"' if "," in head else head
