"""The first mismatch of a variable in two recordings: a value that the other does not take on near that time (X05)."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from onika.record.downsampled import Samples, Told, is_drawn, joined, published
from onika.record.series import Series
from onika.record.tolerance import Tolerance
from onika.record.value import flat

_EXACT = 4
"""Bytes of the widest whole number that a double holds exactly whatever it is."""


@dataclass(frozen=True, slots=True)
class Mismatch:
    """When, which element, its value, and what the other one has there: None, nothing yet."""

    at_ns: int
    place: int
    value: Any
    near: Any

    def whole(self) -> "Mismatch":
        """The same of whole numbers."""
        return replace(self, value=int(self.value), near=None if self.near is None else int(self.near))


def mismatches(
    series: Series, other: Series, tolerance: Tolerance, begin_ns: int, end_ns: int
) -> tuple[Mismatch | None, Mismatch | None]:
    """Of each of two, the first value from a time to before another that is far from all of the other about that time.

    What is the same in both files is not looked into.
    """
    left_out = tolerance.leaves_out(series.unit, series.shape.count)
    if all(left_out):
        return None, None
    slack = round(tolerance.seconds * 1e9)
    first, last = begin_ns - slack, end_ns + slack
    ours, theirs = published(series, first, last), published(other, first, last)
    if _is_same(ours, theirs):
        return None, None
    if is_drawn(series) and (series.shape.type.is_real or series.shape.type.size <= _EXACT):
        left, right = joined(series, ours), joined(other, theirs)
        mismatches = (
            _first(_between(each, begin_ns, end_ns), near, tolerance, slack, np.array(left_out))
            for each, near in ((left, right), (right, left))
        )
        mine, its = (each if series.shape.type.is_real or each is None else each.whole() for each in mismatches)
        return mine, its
    words, others = (_words(each, series) for each, series in ((ours, series), (theirs, other)))
    return _first_word(words, others, slack, begin_ns, end_ns), _first_word(others, words, slack, begin_ns, end_ns)


def _is_same(ours: Told, theirs: Told) -> bool:
    flat_ours, flat_theirs = (
        ([at for times, _ in each for at in times], [body for _, bodies in each for body in bodies])
        for each in (ours, theirs)
    )
    return flat_ours == flat_theirs


# -- numbers


def _between(some: Samples, begin_ns: int, end_ns: int) -> Samples:
    first, last = np.searchsorted(some.at_ns, [begin_ns, end_ns], side="left")
    return Samples(some.at_ns[first:last], some.values[first:last])


def _first(
    ours: Samples, theirs: Samples, tolerance: Tolerance, slack: int, left_out: NDArray[np.bool_]
) -> Mismatch | None:
    if not len(ours.at_ns):
        return None
    last = np.searchsorted(theirs.at_ns, ours.at_ns + slack, side="right") - 1
    first = _first_in_force(theirs.at_ns, ours.at_ns - slack)
    is_there = last >= 0
    bad = np.zeros(ours.values.shape, dtype=bool)
    bad[~is_there, 0] = True
    if is_there.any():
        runs = first[is_there], last[is_there]
        low, high = _bounds(theirs.values, *runs)
        values = ours.values[is_there]
        fits = _fits(values, low, high, tolerance)
        if np.isnan(values).any():  # what is no number is only like itself
            fits |= np.isnan(values) & (_bounds(np.isnan(theirs.values).astype(np.float64), *runs)[1] > 0)
        bad[is_there] = ~fits & ~left_out
    rows = bad.any(axis=1)
    if not rows.any():
        return None
    row = int(rows.argmax())
    place = int(bad[row].argmax())
    near = float(theirs.values[last[row], place]) if is_there[row] else None
    return Mismatch(int(ours.at_ns[row]), place, float(ours.values[row, place]), near)


def _first_in_force(times: NDArray[np.int64], at_ns: NDArray[np.int64]) -> NDArray[np.intp]:
    """Of each time the first value that is written then, or else the last one before: several may be in one instant."""
    before = np.searchsorted(times, at_ns, side="left")
    is_written = np.searchsorted(times, at_ns, side="right") > before
    places: NDArray[np.intp] = np.maximum(np.where(is_written, before, before - 1), 0)
    return places


def _bounds(
    values: NDArray[np.float64], first: NDArray[np.intp], last: NDArray[np.intp]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The least and the greatest of each of many runs of rows; nan only where one has no number.

    A run is covered by two of the same power of two, so that long ones cost no more than short ones.
    """
    low = np.empty((len(first), values.shape[1]))
    high = np.empty_like(low)
    power = np.log2(last - first + 1).astype(np.intp)
    least, most = values, values
    for k in range(int(power.max()) + 1):
        some = power == k
        begin, end = first[some], last[some] - (1 << k) + 1
        low[some] = np.fmin(least[begin], least[end])
        high[some] = np.fmax(most[begin], most[end])
        half = 1 << k
        least, most = np.fmin(least[:-half], least[half:]), np.fmax(most[:-half], most[half:])
    return low, high


def _fits(
    values: NDArray[np.float64], low: NDArray[np.float64], high: NDArray[np.float64], tolerance: Tolerance
) -> NDArray[np.bool_]:
    with np.errstate(invalid="ignore"):  # of two infinities
        room = tolerance.value + tolerance.part * np.maximum(np.abs(low), np.abs(high))
        near = np.maximum(low - values, values - high) <= room
    fits: NDArray[np.bool_] = near | ((low <= values) & (values <= high))
    return fits


# -- words, and whole numbers that no double holds


_Words = list[tuple[int, list[Any]]]


def _words(some: Told, series: Series) -> _Words:
    return [(at, flat(body, series.shape)) for times, bodies in some for at, body in zip(times, bodies, strict=True)]


def _first_word(ours: _Words, theirs: _Words, slack: int, begin_ns: int, end_ns: int) -> Mismatch | None:
    first = last = 0
    for at, values in ours:
        while last < len(theirs) and theirs[last][0] <= at + slack:
            last += 1
        while first + 1 < last and theirs[first][0] < at - slack >= theirs[first + 1][0]:
            first += 1
        if not begin_ns <= at < end_ns:
            continue
        if first >= last:
            return Mismatch(at, 0, values[0], None)
        for place, value in enumerate(values):
            if value not in [each[place] for _, each in theirs[first:last]]:
                return Mismatch(at, place, value, theirs[last - 1][1][place])
    return None
