"""An oracle of what stands in a shared file: read as decision 63 says it, number by number.

film = FilmReader.of_page(html)
film.head["tree"], film.at_s, film.value("flow0/A", 3), film.extremes("flow0/A")
"""

import base64
import gzip
import json
import re
import struct
from typing import Any

import numpy as np

SIZES = {"f8": 8, "f4": 4}


class FilmReader:
    """The document of a recorded run, unpacked."""

    def __init__(self, packed: bytes) -> None:
        whole = gzip.decompress(packed)
        (length,) = struct.unpack_from("<Q", whole)
        self.head: dict[str, Any] = json.loads(whole[8 : 8 + length])
        self._content = whole[8 + length :]
        self.at_s: list[float] = self.block(self.head["instants"])[0]

    @classmethod
    def of_page(cls, html: str) -> "FilmReader":
        """Out of the file that a browser opens."""
        match = re.search(r'<script type="text/plain" id="run">([^<]*)</script>', html)
        if match is None:
            raise AssertionError("expected a recorded run in the page, found none")
        return cls(base64.b64decode(match[1]))

    def block(self, number: int) -> list[list[float]]:
        """The rows of a block."""
        place = self.head["blocks"][number]
        size, columns = SIZES[place["type"]], place["columns"]
        count = place["rows"] * columns
        planes = self._content[place["at"] : place["at"] + count * size]
        rows, bits = [], 0
        for row in range(place["rows"]):
            numbers: list[float] = []
            bits = 0
            for k in range(row * columns, (row + 1) * columns):
                step = sum(planes[byte * count + k] << 8 * byte for byte in range(size))
                bits = (bits + step) % (1 << 8 * size)
                code = "<d" if size == 8 else "<f"
                numbers.append(struct.unpack(code, bits.to_bytes(size, "little"))[0])
            rows.append(numbers)
        return rows

    def value(self, address: str, place: int) -> Any:
        """A variable at an instant, as a flat list; None before the first value."""
        about = self.head["variables"][address]
        if "changes" in about:
            known = [value for at, value in about["changes"] if at <= place]
            return known[-1] if known else None
        if "values" not in about or place < about["first"]:
            return None
        return [row[place - about["first"]] for row in self.block(about["values"])]

    def extremes(self, address: str) -> tuple[list[list[float]], list[list[float]]]:
        """The least and the greatest value from each instant to the next."""
        about = self.head["variables"][address]
        values = np.array(self.block(about["values"]))
        following = np.concatenate([values[:, 1:], values[:, -1:]], axis=1)
        return (
            _apart(np.fmin(values, following), np.array(self.block(about["least"]), np.float32)),
            _apart(np.fmax(values, following), np.array(self.block(about["most"]), np.float32)),
        )


def _apart(expected: Any, bits: Any) -> list[list[float]]:
    short = expected.astype(np.float32)
    known = np.where(np.isnan(short), np.uint32(0x7FC00000), short.view(np.uint32))
    rows: list[list[float]] = (known ^ bits.view(np.uint32)).view(np.float32).tolist()
    return rows
