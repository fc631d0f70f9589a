"""The difference of two recorded runs: the first event, or the first variable, that is not the same (X05)."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any

import msgspec

from onika.record import topics
from onika.record.black_box_span import SEEN_WITHIN_S, BlackBoxSpan
from onika.record.mismatch import mismatches
from onika.record.reader import Reader
from onika.record.run import is_by_hand
from onika.record.series import Series
from onika.record.tolerance import Tolerance
from onika.words.reason import Reason

SHAPE = "record.shape"
"""The key of what is said of a variable that has another shape in the other run."""

_TIMES = ("at_s", "at_ns", "previous_step_ns", "last_command_ns")
_UNLIKE = (
    *("wall_s", "of", "tasks", "switches_us", "skews_us", "skew_us", "hash", "courses", "runtime_s", "steps"),
    "values",
)
"""What is another in every run, was only looked at (`values`), or is told better by what led to it."""


_TimedEvents = list[tuple[int, dict[str, Any]]]
_BLOCK_NS = 10_000_000_000
"""So much of both is compared at a time: most runs that differ do so early."""


@dataclass(frozen=True, slots=True)
class Difference:
    """When, what it is about, and what each of the two says of it."""

    at_ns: int
    what: Reason
    """A variable, a task, or the runtime."""
    first: Reason
    second: Reason
    variable: str = ""
    """Its address, where it is about one."""

    @property
    def sentence(self) -> Reason:
        """All of it."""
        at_s = self.at_ns * 1e-9
        return Reason.of("record.difference", at_s=at_s, what=self.what, first=self.first, second=self.second)


def first_difference(
    reader: Reader, other: Reader, tolerance: Tolerance, is_wanted: Callable[[], bool] = lambda: True
) -> Difference | None:
    """The earliest; None: none that goes beyond the tolerance, or it is not wanted any more.

    Where one of them was cut short, what the other one says beyond its end is no difference; nor is what a black box
    does not hold. Of subsystems that were held by hand, whatever they are called, the variables that both have are
    compared, as long as both last: their tasks are meant to differ.
    """
    first, last, tolerance = _compared(reader, other, tolerance)
    ours, theirs = Series.all_of(reader), Series.all_of(other)
    if are_by_hand(reader, other):
        theirs = _alike(ours, theirs)
        ours = {name: series for name, series in ours.items() if name in theirs}
        if not ours:
            return _nothing_alike(reader, other)
        differences = list(_unlike(ours, theirs))
        last = min(last, reader.span[1], other.span[1])
    else:
        differences = [
            each for each in (*_events(reader, other, tolerance, first), *_unlike(ours, theirs)) if each.at_ns <= last
        ]
    both = [name for name in ours if name in theirs and str(ours[name].shape) == str(theirs[name].shape)]
    # Of the last instant of one that was cut short not all may be there.
    until = min([last, 1 + max(reader.span[1], other.span[1]), *(each.at_ns for each in differences)])
    for begin in range(first, until, _BLOCK_NS):
        if not is_wanted():
            return None
        end = min(begin + _BLOCK_NS, until)
        some = [each for name in both for each in _strays(name, ours[name], theirs[name], tolerance, begin, end)]
        if some:
            differences += some
            break
    return min(differences, key=lambda each: (each.at_ns, str(each.what)), default=None)


def are_by_hand(reader: Reader, other: Reader) -> bool:
    """Whether both are of a subsystem that was held by hand."""
    return is_by_hand(reader.notes) and is_by_hand(other.notes)


def _alike(ours: dict[str, Series], theirs: dict[str, Series]) -> dict[str, Series]:
    """Theirs that are called as one of ours is, by our addresses: each has one subsystem, whatever its name."""
    by_name = {series.name: series for series in theirs.values()}
    return {address: by_name[series.name] for address, series in ours.items() if series.name in by_name}


def _nothing_alike(reader: Reader, other: Reader) -> Difference:
    """No variable of the one is in the other."""
    first, second = (tuple(series.name for series in Series.all_of(each).values()) for each in (reader, other))
    what = Reason.of("record.the_variables")
    return Difference(0, what, Reason.of("record.are", names=first), Reason.of("record.are", names=second))


def both_hold(reader: Reader, other: Reader) -> tuple[int, int]:
    """From when to when of the run both recordings tell everything, in ns; one that ended by itself tells its end."""
    first, last = 0, 1 << 62
    for each in (reader, other):
        held = BlackBoxSpan.of(each.notes)
        if held is not None:
            first = max(first, held.begin_ns)
        if not each.is_whole or (held is not None and held.goes_on):
            last = min(last, each.span[1])
    return first, last


def _compared(reader: Reader, other: Reader, tolerance: Tolerance) -> tuple[int, int, Tolerance]:
    """From when to when, and within what."""
    if any(BlackBoxSpan.of(each.notes) for each in (reader, other)):
        tolerance = replace(tolerance, seconds=max(tolerance.seconds, SEEN_WITHIN_S))
    return *both_hold(reader, other), tolerance


def _unlike(ours: dict[str, Series], theirs: dict[str, Series]) -> Iterator[Difference]:
    """Variables that only one of them has, or that have another shape."""
    for name in sorted({*ours, *theirs}):
        if name not in ours or name not in theirs:
            there = ours.get(name) or theirs.get(name)
            at = 0 if there is None else next(iter(there.values()), (0, None))[0]
            yield Difference(at, Reason.plain(name), *_presence(name in ours), name)
        elif str(ours[name].shape) != str(theirs[name].shape):
            yield Difference(0, Reason.plain(name), _shape(ours[name]), _shape(theirs[name]), name)


def _shape(series: Series) -> Reason:
    return Reason.of(SHAPE, shape=str(series.shape))


def _presence(is_ours: bool) -> tuple[Reason, Reason]:
    if is_ours:
        return Reason.of("record.there"), Reason.of("record.is_not")
    return Reason.of("record.not_there"), Reason.of("record.is")


# -- events


def _events(reader: Reader, other: Reader, tolerance: Tolerance, first_ns: int) -> Iterator[Difference]:
    """The first event of each subsystem that is another; what is told of different ones has no common order."""
    slack = round(tolerance.seconds * 1e9)
    ours, theirs = _timed_events(reader), _timed_events(other)
    for home in sorted({*ours, *theirs}):
        pair = _since(ours.get(home, []), theirs.get(home, []), first_ns, slack)
        for left, right in zip_longest(*pair):
            apart = 0.0 if left is None or right is None else abs(left[0] - right[0]) * 1e-9
            if left is None or right is None or left[1] != right[1] or apart > tolerance.seconds + 1e-12:
                at = min(each[0] for each in (left, right) if each is not None)
                what = Reason.plain(home) if home else Reason.of("record.the_runtime")
                yield Difference(at, what, _words(left), _words(right))
                break


def _since(ours: _TimedEvents, theirs: _TimedEvents, first_ns: int, slack: int) -> tuple[_TimedEvents, _TimedEvents]:
    """What was told since then; about that time only what both have, as each may have been a little earlier."""
    if not first_ns:
        return ours, theirs
    left, right = ([each for each in some if each[0] > first_ns] for some in (ours, theirs))
    until = first_ns + 2 * slack
    while left and right and left[0][1] != right[0][1] and min(left[0][0], right[0][0]) <= until:
        earlier = left if left[0][0] <= right[0][0] else right
        del earlier[0]
    return left, right


def _timed_events(reader: Reader) -> dict[str, _TimedEvents]:
    events: dict[str, _TimedEvents] = {}
    for at, body in reader.messages(topics.EVENTS):
        message = msgspec.json.decode(body)
        event = message["event"]
        bare = {key: value for key, value in event.items() if key not in _TIMES and key not in _UNLIKE}
        home = message["subsystem"] or (event.get("device", "") if event["type"] == "Drive" else "")
        events.setdefault(f"{home} {event.get('task', '')}".strip(), []).append((at, bare))
    return events


def _words(timed_event: tuple[int, dict[str, Any]] | None) -> Reason:
    if timed_event is None:
        return Reason.of("record.nothing_more")
    at, event = timed_event
    return Reason.of("record.event_at", event=_bare_words(event), at_s=at * 1e-9)


def _bare_words(event: dict[str, Any]) -> Reason:
    match event["type"]:
        case "Began":
            return Reason.of("record.action_begins", action=event["action"])
        case "Done":
            return Reason.of("record.action_done", number=event["index"] + 1)
        case "TaskState":
            return Reason.of("record.task_is", task=event["task"], state=event["state"])
        case "Moved":
            return Reason.of("record.it_is", state=event["state"])
    rest = " ".join(f"{key} {value}" for key, value in event.items() if key != "type" and value not in ("", [], None))
    return Reason.plain(f"{event['type']} {rest}".strip())


# -- variables


def _strays(
    name: str, ours: Series, theirs: Series, tolerance: Tolerance, begin_ns: int, end_ns: int
) -> Iterator[Difference]:
    """The first value that the other one does not take on near that time, of each of the two."""
    for is_swapped, mismatch in enumerate(mismatches(ours, theirs, tolerance, begin_ns, end_ns)):
        if mismatch is not None:
            label = name.rpartition("/")[0] + "/" + ours.labels[mismatch.place]
            value, other = _show(mismatch.value), _show(mismatch.near)
            first, second = (other, value) if is_swapped else (value, other)
            yield Difference(mismatch.at_ns, Reason.plain(label), first, second, name)


def _show(value: Any) -> Reason:
    if value is None:
        return Reason.of("record.nothing_yet")
    return Reason.plain(repr(value))
