"""Variables of a recording as a table for other programs: one row for each time at which one of them changed."""

import csv
from collections.abc import Iterator, Sequence
from heapq import merge
from typing import Any, TextIO

from onika.record.series import Series


def write(stream: TextIO, series: Sequence[Series]) -> int:
    """Write CSV: the time in seconds, then every element of each variable as it was at that time; how many rows.

    A cell is empty before the first value of its variable.
    """
    table = csv.writer(stream)
    labels = [f"{variable.subsystem}/{label}" for variable in series for label in variable.labels]
    table.writerow(["time_s", *labels])
    begins, width = [], 0
    for variable in series:
        begins.append(width)
        width += len(variable.labels)
    row: list[Any] = [""] * width
    rows, last = 0, None
    courses = [_course(k, variable) for k, variable in enumerate(series)]
    for at, k, values in merge(*courses, key=lambda sample: sample[:2]):
        if last is not None and at != last:
            table.writerow([_seconds(last), *row])
            rows += 1
        row[begins[k] : begins[k] + len(values)] = values
        last = at
    if last is not None:
        table.writerow([_seconds(last), *row])
        rows += 1
    return rows


def _course(number: int, series: Series) -> Iterator[tuple[int, int, list[Any]]]:
    for at, values in series.flat():
        yield at, number, values


def _seconds(at_ns: int) -> str:
    return f"{at_ns // 1_000_000_000}.{at_ns % 1_000_000_000:09d}"
