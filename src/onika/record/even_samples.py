"""Two recorded signals at the same instants, evenly in time: a variable keeps its value until the next one (X05)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from onika.record.frequency_response import LEAST_SAMPLES
from onika.words.reason import Reason

_STRAY = 0.25
_MOST_STRAYS = 10.0
"""Times are even where at most so many of a hundred are further than a quarter of a step from whole steps."""
_MOST_SAMPLES = 20_000_000


@dataclass(frozen=True, slots=True)
class ElementCourse:
    """One number over time, where it changed; times in ns, rising."""

    name: str
    at_ns: NDArray[np.int64]
    values: NDArray[np.float64]

    def held(self, at_ns: NDArray[np.float64]) -> NDArray[np.float64]:
        """The values in force at times that are not before the first one."""
        return self.values[np.searchsorted(self.at_ns, at_ns, side="right") - 1]


@dataclass(frozen=True, slots=True)
class EvenSamples:
    """Both signals at instants that are `step_s` apart."""

    step_s: float
    reference: NDArray[np.float64]
    measured: NDArray[np.float64]


def even_samples(
    reference: ElementCourse, measured: ElementCourse, begin_ns: int, end_ns: int, hertz: float | None = None
) -> EvenSamples:
    """Both from `begin_ns`, or from when both are there, to `end_ns`, at the instants at which the measurement comes.

    `hertz` says how often they are read where that cannot be seen. Raises ValueError with a reason where one of them
    never comes, or the measurement comes unevenly.
    """
    for course in (reference, measured):
        if not len(course.at_ns):
            raise ValueError(Reason.of("record.response_nothing", name=course.name))
    step_ns = _step_ns(measured) if hertz is None else 1e9 / hertz
    first = max(begin_ns, int(reference.at_ns[0]), int(measured.at_ns[0]))
    later = measured.at_ns[measured.at_ns >= first]
    start = int(later[0]) if len(later) else first
    count = int((end_ns - start) / step_ns + 1e-6) + 1 if end_ns >= start else 0
    if count > _MOST_SAMPLES:
        raise ValueError(Reason.of("record.response_long", count=count, most=_MOST_SAMPLES))
    instants = _snapped(start + step_ns * np.arange(count, dtype=np.float64), measured.at_ns, step_ns)
    # A thousandth of a step later: times are whole nanoseconds, steps need not be.
    instants += 1e-3 * step_ns
    return EvenSamples(step_ns * 1e-9, reference.held(instants), measured.held(instants))


def _step_ns(course: ElementCourse) -> float:
    """The time from one value to the next; several where it did not change meanwhile."""
    steps = np.diff(course.at_ns)
    if not len(steps):
        raise ValueError(Reason.of("record.response_short", count=len(course.at_ns), least=LEAST_SAMPLES))
    parts = steps / np.median(steps)
    whole = np.round(parts)
    is_even = (np.abs(parts - whole) <= _STRAY) & (whole > 0.0)
    percent = 100.0 * float(np.mean(~is_even))
    if percent > _MOST_STRAYS:
        raise ValueError(Reason.of("record.response_uneven", name=course.name, percent=percent))
    return float(np.sum(steps[is_even]) / np.sum(whole[is_even]))


def _snapped(instants: NDArray[np.float64], at_ns: NDArray[np.int64], step_ns: float) -> NDArray[np.float64]:
    """Each instant, or the time of the value that came next to it, within half a step."""
    after = np.clip(np.searchsorted(at_ns, instants), 1, len(at_ns) - 1) if len(at_ns) > 1 else np.zeros(0, int)
    if not len(after):
        return instants
    before = after - 1
    nearest = np.where(instants - at_ns[before] <= at_ns[after] - instants, at_ns[before], at_ns[after])
    return np.where(np.abs(nearest - instants) <= 0.5 * step_ns, nearest, instants)
