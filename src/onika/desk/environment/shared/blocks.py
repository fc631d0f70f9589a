"""Columns of numbers as bytes that pack well: differences of neighbours, byte by byte.

A block is rows of equal length. Each number is taken as the whole number of its bits; in each row stands what is added
to the one before (beyond the largest it begins at zero again); then come the lowest bytes of all, the next ones, and so
on. Who reads it does the same backwards, and has the same bits.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

_BITS: Mapping[str, type[np.unsignedinteger[Any]]] = {"f8": np.uint64, "f4": np.uint32}


@dataclass(slots=True)
class Blocks:
    """Blocks one after the other, and where each begins."""

    places: list[dict[str, Any]] = field(default_factory=list)
    """Of each: `at` (bytes from the beginning of all), `type` (`f8`, `f4`), `rows` and `columns`."""
    content: bytearray = field(default_factory=bytearray)

    def add(self, numbers: NDArray[Any], kind: str) -> int:
        """Add a block of rows; gives its number."""
        rows = np.atleast_2d(np.ascontiguousarray(numbers, dtype=np.dtype(kind)))
        self.places.append({"at": len(self.content), "type": kind, "rows": rows.shape[0], "columns": rows.shape[1]})
        self.content += packed(rows.view(_BITS[kind]))
        return len(self.places) - 1

    def add_bytes(self, content: bytes) -> int:
        """Add bytes as they are; gives their number."""
        self.places.append({"at": len(self.content), "type": "bytes", "rows": 1, "columns": len(content)})
        self.content += content
        return len(self.places) - 1


def packed(bits: NDArray[Any]) -> bytes:
    """Rows of whole numbers as differences, byte plane by byte plane."""
    steps = bits.copy()
    steps[:, 1:] -= bits[:, :-1]
    flat = steps.reshape(-1)
    planes = flat.view(np.uint8).reshape(len(flat), bits.dtype.itemsize)
    return planes.T.tobytes()
