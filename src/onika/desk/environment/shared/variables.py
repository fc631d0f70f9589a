"""Variables of a recorded run at the instants of a shared file, with the peaks between them."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.shared.blocks import Blocks
from onika.desk.environment.shared.grid import Nanoseconds
from onika.record import downsampled
from onika.record.downsampled import Samples
from onika.record.series import Series

_NAN_BITS = np.uint32(0x7FC00000)


def samples_of(subject: ReviewedRun) -> dict[str, Samples]:
    """All values of the variables that are numbers, by their addresses; raises what reading raises."""
    return {
        address: downsampled.samples(series)
        for address, series in subject.review.series.items()
        if downsampled.is_drawn(series)
    }


def variables(
    subject: ReviewedRun, samples: Mapping[str, Samples], instants: Nanoseconds, blocks: Blocks
) -> dict[str, Any]:
    """What a shared file says of each variable; numbers go into `blocks`, pictures nowhere."""
    held: dict[str, Any] = {}
    for address, series in subject.review.series.items():
        if address in samples:
            held[address] = _numbers(series, samples[address], instants, blocks)
        elif not series.is_picture:
            held[address] = {"changes": _changes(series, instants)}
    return held


def _numbers(series: Series, samples: Samples, instants: Nanoseconds, blocks: Blocks) -> dict[str, Any]:
    first = int(np.searchsorted(instants, samples.at_ns[0])) if len(samples.at_ns) else len(instants)
    later = instants[first:]
    if not len(later):
        return {"first": first}
    places = np.searchsorted(samples.at_ns, later, side="right") - 1
    values = samples.values[places]
    least, most = extremes(samples, later)
    return {
        "first": first,
        "dims": [int(size) for size in series.shape.dims],
        "values": blocks.add(values.T, "f8"),
        "least": blocks.add(apart(least, np.fmin(values, _next(values))).T, "f4"),
        "most": blocks.add(apart(most, np.fmax(values, _next(values))).T, "f4"),
    }


def _next(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The values of the next instants; behind the last one itself."""
    return np.concatenate([values[1:], values[-1:]])


def extremes(samples: Samples, instants: Nanoseconds) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The least and the greatest value from each instant to the next, both with it; behind the last one its own."""
    begins = np.searchsorted(samples.at_ns, instants, side="right") - 1
    ends = np.concatenate([begins[1:] + 1, begins[-1:] + 1])
    padded = np.concatenate([samples.values, samples.values[-1:]])
    bounds = np.stack([begins, ends], axis=1).reshape(-1)
    return np.fmin.reduceat(padded, bounds)[::2], np.fmax.reduceat(padded, bounds)[::2]


def apart(values: NDArray[np.float64], expected: NDArray[np.float64]) -> NDArray[np.float32]:
    """Where values are not what their neighbours let expect, the bits that differ; else nothing at all."""
    bits = _bits(values) ^ _bits(expected)
    return bits.view(np.float32)


def _bits(values: NDArray[np.float64]) -> NDArray[np.uint32]:
    with np.errstate(over="ignore"):
        short = np.ascontiguousarray(values, dtype=np.float32)
    return np.where(np.isnan(short), _NAN_BITS, short.view(np.uint32))


def _changes(series: Series, instants: Nanoseconds) -> list[tuple[int, Any]]:
    """At which instants it became what."""
    changes: list[tuple[int, Any]] = []
    published = list(series.values())
    bounds = [*(int(np.searchsorted(instants, at)) for at, _ in published), len(instants)]
    for (_, value), (place, following) in zip(published, pairwise(bounds), strict=True):
        if place < following and (not changes or changes[-1][1] != value):
            changes.append((place, value))
    return changes
