"""Where two recorded runs begin to differ: the first event, or the first variable, that is another (X05)."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import zip_longest
from typing import Any

import msgspec

from onika.record import said
from onika.record.reader import Reader
from onika.record.series import Series

_TIMES = ("at_s", "at_ns", "previous_step_ns", "last_command_ns")
_UNLIKE = ("wall_s", "tasks", "switches_us", "skews_us", "skew_us", "hash", "courses", "runtime_s")
"""What is another in every run, or is told better by what led to it."""


@dataclass(frozen=True, slots=True)
class Tolerance:
    """How far two runs may lie apart: values by an amount, or by a part of themselves; times by seconds."""

    value: float = 0.0
    part: float = 0.0
    seconds: float = 0.0

    def covers(self, one: float, low: float, high: float) -> bool:
        """Whether a number lies near enough to what another took on from `low` to `high`."""
        if math.isnan(one) or math.isnan(low):
            return math.isnan(one) and math.isnan(low)
        if one in (low, high):
            return True
        room = self.value + self.part * max(abs(low), abs(high))
        return max(low - one, one - high) <= room


@dataclass(frozen=True, slots=True)
class Difference:
    """When, what it is about, and what each of the two says of it."""

    at_ns: int
    what: str
    first: str
    second: str

    def __str__(self) -> str:
        return f"at {self.at_ns * 1e-9:.9g} s: {self.what}: {self.first}, in the other {self.second}"


def first_difference(one: Reader, other: Reader, tolerance: Tolerance) -> Difference | None:
    """The earliest; None: none that goes beyond the tolerance."""
    found = [*_events(one, other, tolerance)]
    ours, theirs = Series.all_of(one), Series.all_of(other)
    for name in sorted({*ours, *theirs}):
        until = min((each.at_ns for each in found), default=1 << 62)
        if name not in ours or name not in theirs:
            there = ours.get(name) or theirs.get(name)
            at = 0 if there is None else next(iter(there.values()), (0, None))[0]
            found.append(Difference(at, name, *_presence(name in ours)))
        elif str(ours[name].shape) != str(theirs[name].shape):
            found.append(Difference(0, name, str(ours[name].shape), str(theirs[name].shape)))
        else:
            found += _courses(name, ours[name], theirs[name], tolerance, until)
    return min(found, key=lambda each: (each.at_ns, each.what), default=None)


def _presence(is_ours: bool) -> tuple[str, str]:
    return ("it is there", "it is not") if is_ours else ("it is not there", "it is")


# -- events


def _events(one: Reader, other: Reader, tolerance: Tolerance) -> Iterator[Difference]:
    """The first event of each subsystem that is another; what is told of different ones has no common order."""
    ours, theirs = _told(one), _told(other)
    for home in sorted({*ours, *theirs}):
        for left, right in zip_longest(ours.get(home, []), theirs.get(home, [])):
            apart = 0.0 if left is None or right is None else abs(left[0] - right[0]) * 1e-9
            if left is None or right is None or left[1] != right[1] or apart > tolerance.seconds + 1e-12:
                at = min(each[0] for each in (left, right) if each is not None)
                yield Difference(at, home or "the runtime", _words(left), _words(right))
                break


def _told(reader: Reader) -> dict[str, list[tuple[int, dict[str, Any]]]]:
    found: dict[str, list[tuple[int, dict[str, Any]]]] = {}
    for at, body in reader.messages(said.EVENTS):
        message = msgspec.json.decode(body)
        told = message["event"]
        bare = {key: value for key, value in told.items() if key not in _TIMES and key not in _UNLIKE}
        home = message["subsystem"] or (told.get("device", "") if told["type"] == "Drive" else "")
        found.setdefault(f"{home} {told.get('task', '')}".strip(), []).append((at, bare))
    return found


def _words(told: tuple[int, dict[str, Any]] | None) -> str:
    if told is None:
        return "nothing more"
    at, event = told
    rest = " ".join(f"{key} {value}" for key, value in event.items() if key != "type" and value not in ("", [], None))
    return f"{event['type']} {rest}".strip() + f" at {at * 1e-9:.9g} s"


# -- variables


def _courses(name: str, ours: Series, theirs: Series, tolerance: Tolerance, until_ns: int) -> Iterator[Difference]:
    """The first value that the other one does not take on near that time."""
    for left, right, is_swapped in ((ours, theirs, False), (theirs, ours, True)):
        found = _stray(left, right, tolerance, until_ns)
        if found is not None:
            at, place, value, near = found
            label = name.rpartition("/")[0] + "/" + left.labels[place]
            words = (_show(value), _show(near))
            yield Difference(at, label, *(reversed(words) if is_swapped else words))


def _stray(one: Series, other: Series, tolerance: Tolerance, until_ns: int) -> tuple[int, int, Any, Any] | None:
    """Where a value of `one` is far from every value of `other` within the tolerance of time."""
    slack = round(tolerance.seconds * 1e9)
    window: list[tuple[int, list[Any]]] = []
    coming = other.flat()
    ahead = next(coming, None)
    for at, values in one.flat(0, until_ns):
        while ahead is not None and ahead[0] <= at + slack:
            window.append(ahead)
            ahead = next(coming, None)
        while len(window) > 1 and window[1][0] <= at - slack:
            window.pop(0)
        if not window:
            return at, 0, values[0], None
        for place, value in enumerate(values):
            near = [each[place] for _, each in window]
            if not _fits(value, near, tolerance):
                return at, place, value, near[-1]
    return None


def _fits(value: Any, near: list[Any], tolerance: Tolerance) -> bool:
    if isinstance(value, int | float) and all(isinstance(each, int | float) for each in near):
        return tolerance.covers(value, min(near), max(near))
    return value in near


def _show(value: Any) -> str:
    return "nothing yet" if value is None else repr(value)
