"""A log as a table of rows."""

import os
from pathlib import Path

import numpy as np

from onika.module import InConst, InVar, Local, Module, off


class CsvLog(Module):
    """Writes joint positions, whatever they are called, into a file of rows that any spreadsheet reads.

    Rows are kept until the task goes off; then the file is written whole, or not at all. Where cycles must not be late
    at that moment, the task stands on a processing unit of its own. In a forecast nothing is written.

    Kind     passive, periodic, 1..1000 Hz
    Ports    INCONST  NDOF  int           -    number of elements
             INVAR    Y     double[NDOF]  rad  what is written down
    Local    FILE           line          -    the file; one without a folder lies in that of the runtime
             ROWS           int           -    how many rows are kept at most
    Errors   no file   FILE names none: warns and goes off
             full      ROWS are kept: warns and goes off, what is kept is written
             no place  the file cannot be written: warns
    Get/Set  rows, how many are kept / -
    """

    passive = True

    NDOF = InConst("int", "-", "number of elements")
    Y = InVar("double[NDOF]", "rad", "what is written down")

    FILE = Local("line", "-", "the file; one without a folder lies in that of the runtime", default="")
    ROWS = Local("int", "-", "how many rows are kept at most", default=100_000, low=1, high=10_000_000)

    def init(self):
        self._table, self._times = np.empty((0, self.NDOF)), []

    def on(self, inputs):
        self._table, self._times = np.empty((min(self.ROWS, 1024), self.NDOF)), []

    def cycle(self):
        if not self.FILE:
            self.warn("FILE names no file: nothing is written down")
            return off()
        if len(self._times) == self.ROWS:
            self.warn("{rows} rows are kept: nothing more is written down", rows=self.ROWS)
            return off()
        if len(self._times) == len(self._table):
            self._table = np.resize(self._table, (min(2 * len(self._table), self.ROWS), self.NDOF))
        self._table[len(self._times)] = self.Y
        self._times.append(self.now)
        return None

    def off(self):
        if self._times:
            self._write()

    def kill(self):
        self.off()

    def get(self, name):
        return len(self._times) if name == "rows" else super().get(name)

    def _write(self):
        head = ",".join(["t", *(f"y{k}" for k in range(1, self.NDOF + 1))])
        rows = (
            f"{t:.9g}," + ",".join(map("{:.9g}".format, row)) for t, row in zip(self._times, self._table, strict=False)
        )
        self._times, text = [], "\n".join([head, *rows, ""])
        place = Path(self.FILE)
        beside = place.with_name(f".{place.name}.{os.getpid()}")
        try:
            beside.write_text(text, encoding="utf-8")
            beside.replace(place)
        except OSError as wrong:
            self.warn("{file} cannot be written: {why}", file=self.FILE, why=wrong.strerror or "")
