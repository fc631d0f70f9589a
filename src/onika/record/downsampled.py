"""A variable of a recording as arrays: all its values, or the least and the greatest in equal parts of a time (X05).

A variable of a fast task has hundreds of thousands of values in ten minutes: they are read chunk by chunk into arrays.
"""

from dataclasses import dataclass
from typing import Any

import msgspec
import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from onika.record import value
from onika.record.series import Series


class _Vector(Struct):
    value: list[float | None]


class _Scalar(Struct):
    value: float | None


_vectors = msgspec.json.Decoder(list[_Vector]).decode
_scalars = msgspec.json.Decoder(list[_Scalar]).decode


@dataclass(frozen=True, slots=True)
class Samples:
    """The values of a variable: when each came, in ns, and its elements, row by row."""

    at_ns: NDArray[np.int64]
    values: NDArray[np.float64]

    @property
    def bytes(self) -> int:
        """How much memory it takes."""
        return self.at_ns.nbytes + self.values.nbytes

    def between(self, begin_ns: int, end_ns: int) -> "Samples":
        """Those of a stretch of time, its end with it, and the value that was there at its beginning."""
        first, last = np.searchsorted(self.at_ns, [begin_ns, end_ns], side="right")
        first = max(int(first) - 1, 0)
        return Samples(self.at_ns[first:last], self.values[first:last])


@dataclass(frozen=True, slots=True)
class Parts:
    """When each part of a time begins, in s, and in it the least and the greatest value of each element."""

    at_s: NDArray[np.float64]
    least: NDArray[np.float64]
    most: NDArray[np.float64]


def is_drawn(series: Series) -> bool:
    """Whether its values are numbers that a line can show."""
    return (series.shape.type.is_real or series.shape.type.is_whole) and not series.is_picture


def samples(series: Series, begin_ns: int = 0, end_ns: int = 1 << 62) -> Samples:
    """The values of a variable of numbers from a time to another, and the one before."""
    return joined(series, published(series, begin_ns, end_ns))


Told = list[tuple[list[int], list[bytes]]]
"""Chunk by chunk, when something came, and what."""


def published(series: Series, begin_ns: int = 0, end_ns: int = 1 << 62) -> Told:
    """The same as it stands in the file."""
    before = series.reader.newest(series.topic, begin_ns)
    return list(series.reader.bodies(series.topic, begin_ns if before is None else before[0], end_ns + 1))


def joined(series: Series, samples: Told) -> Samples:
    """What was told, as numbers."""
    width = series.shape.count if series.shape.dims else 1
    times = [np.array(at, np.int64) for at, _ in samples]
    rows = [_numbers(bodies, series).reshape(len(bodies), width) for _, bodies in samples]
    return Samples(np.concatenate([np.empty(0, np.int64), *times]), np.concatenate([np.empty((0, width)), *rows]))


def parts(samples: Samples, begin_ns: int, end_ns: int, points: int) -> Parts:
    """So many equal parts of a time at most; those in which nothing came are left out, so that no peak is lost."""
    some = samples.between(begin_ns, end_ns)
    width = max((end_ns - begin_ns) // max(points, 1), 1)
    cells = np.maximum(some.at_ns - begin_ns, 0) // width
    if not len(cells):
        return Parts(cells.astype(np.float64), some.values, some.values)
    starts = np.flatnonzero(np.diff(cells, prepend=-1))
    at_s = np.round((begin_ns + cells[starts] * width) * 1e-9, 9)
    return Parts(at_s, np.fmin.reduceat(some.values, starts), np.fmax.reduceat(some.values, starts))


def _numbers(bodies: list[bytes], series: Series) -> NDArray[np.float64]:
    decode: Any = _vectors if series.shape.dims else _scalars
    try:
        return np.array([row.value for row in decode(b"[" + b",".join(bodies) + b"]")], dtype=np.float64)
    except msgspec.DecodeError:  # a number beyond every double
        return np.array([value.flat(body, series.shape) for body in bodies], dtype=np.float64)
