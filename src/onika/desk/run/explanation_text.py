"""Shows the explanation of a stop as a short block of lines, for any width from 60 columns (requirement X06)."""

import math
from collections.abc import Callable, Iterator, Sequence
from textwrap import wrap
from typing import Any

from onika.wire import event
from onika.words.reason import NOTHING, Reason

_LABEL = 13
"""Columns before the text: the time of the first line, the labels of the others."""
_STANDS = 5e-4
"""A value that moves by less than this share of itself stands: its noise would look like a storm."""
_BARS = "▁▂▃▄▅▆▇█"
_NUMBERS = 34
"""Columns of first, last, lowest and highest value."""


Say = Callable[[Reason], str]
"""Makes the words of a reason."""


def lines(explained: event.Explained, width: int = 80, say: Say = str) -> Iterator[str]:
    """The block: what, suspect, chain, places, who waits, the last seconds, the choices."""
    yield from _filled(f"{explained.at_s:8.2f} s  ", f"{_head(explained, say)}: {say(explained.text)}", width)
    if explained.suspect:
        yield from _labelled(say(Reason.of("desk.block_suspect")), explained.suspect, width)
    yield from _labelled(say(Reason.of("desk.block_chain")), _chain(explained, say), width)
    yield from _labelled(say(Reason.of("desk.block_where")), _where(explained, say), width)
    if explained.courses:
        label = Reason.of("desk.block_last", seconds=_seconds(_span(explained.courses)))
        yield from _rows(say(label), _table(explained.courses, width, say))
    yield from _choices(explained.choices, width, say)


def _head(explained: event.Explained, say: Say) -> str:
    """Whether it can go on, and whose flow and task it is."""
    kind = Reason.of("desk.block_stop") if explained.choices else Reason.of("desk.block_end")
    words = (say(kind), "/".join(filter(None, (explained.subsystem, explained.task))))
    return " ".join(filter(None, words))


def _seconds(span: float) -> str:
    if span >= 1:
        return f"{span:.1f}"
    return f"{span:.2f}"


def _chain(explained: event.Explained, say: Say) -> str:
    """Task, job, flow, who waits; nothing where there is but one link."""
    action = NOTHING
    if explained.action:
        action = Reason.of("desk.block_action", number=explained.index + 1, action=explained.action)
    waits = [_waits(flow, tag) for flow, tag in explained.waiting]
    links = [explained.task, say(action), explained.subsystem, *map(say, waits)]
    shown = [link for link in links if link]
    if len(shown) > 1:
        return " > ".join(shown)
    return ""


def _waits(flow: str, tag: str) -> Reason:
    if tag:
        return Reason.of("desk.flow_waits_at", flow=flow, tag=tag)
    return Reason.of("desk.flow_waits", flow=flow)


def _where(explained: event.Explained, say: Say) -> str:
    code = explained.path
    if explained.path and explained.line:
        code = f"{explained.path}:{explained.line}"
    return ", ".join(filter(None, (code, explained.place)))


def _choices(choices: Sequence[tuple[str, Reason]], width: int, say: Say) -> Iterator[str]:
    column = max((len(command) for command, _ in choices), default=0) + 2
    label = say(Reason.of("desk.block_choices"))
    for command, meaning in choices:
        yield from _filled(f"{_label(label)}{command:<{column}}", say(meaning), width)
        label = ""


def _label(label: str) -> str:
    return f" {label:<{_LABEL - 2}} "


def _labelled(label: str, text: str, width: int) -> Iterator[str]:
    if text:
        yield from _filled(_label(label), text, width)


def _rows(label: str, rows: Sequence[str]) -> Iterator[str]:
    for row in rows:
        yield f"{_label(label)}{row}"
        label = ""


def _filled(before: str, text: str, width: int) -> Iterator[str]:
    """A text behind `before`, broken where it is too long, its further lines below its beginning.

    A path is never broken: it is to be clicked on, or copied.
    """
    room = max(width - len(before), 30)
    for part in wrap(text, room, break_long_words=False, break_on_hyphens=False) or [""]:
        yield f"{before}{part}".rstrip()
        before = " " * len(before)


# The last seconds


def _span(courses: Sequence[event.Course]) -> float:
    times = [at for series in courses for at in series.at_s]
    return max(times, default=0.0) - min(times, default=0.0)


def _table(courses: Sequence[event.Course], width: int, say: Say) -> list[str]:
    """Of each variable the element that says most, as a curve and in numbers."""
    elements = [(series, *_element(series.values)) for series in courses]
    names = max(len(_name(series, index)) for series, index, _ in elements)
    columns = min(max(width - _LABEL - names - _NUMBERS - 2, 8), 40)
    room = width - _LABEL - names - columns - 2
    rows = []
    for series, index, values in elements:
        numbers = _numbers(values, _unit(series.unit, index), room, say)
        rows.append(f"{_name(series, index):<{names}} {_curve(values, columns)} {numbers}")
    return rows


def _name(series: event.Course, index: Sequence[int]) -> str:
    if index:
        return f"{series.variable}[{','.join(map(str, index))}]"
    return series.variable


def _unit(unit: str, index: Sequence[int]) -> str:
    """The unit of an element, where each has its own; empty for a bare number."""
    units = unit.split(",")
    if index and index[0] < len(units) > 1:
        unit = units[index[0]]
    if unit == "-":
        return ""
    return unit


def _element(samples: Sequence[Any]) -> tuple[tuple[int, ...], list[float]]:
    """Of a vector the element that has become no number, else the one that has moved most; with its index."""
    elements = [_leaves(sample) for sample in samples]
    of_each = {index: [float(element[index]) for element in elements if index in element] for index in elements[-1]}
    index = max(of_each, key=lambda key: _interest(of_each[key]))
    return index, of_each[index]


def _interest(values: Sequence[float]) -> float:
    finite = [value for value in values if math.isfinite(value)]
    if len(finite) < len(values):
        return math.inf
    return max(finite) - min(finite)


def _leaves(value: Any, index: tuple[int, ...] = ()) -> dict[tuple[int, ...], Any]:
    if not isinstance(value, list):
        return {index: value}
    return {k: v for number, element in enumerate(value) for k, v in _leaves(element, (*index, number)).items()}


def _curve(values: Sequence[float], columns: int) -> str:
    """The values as bars, at most one for each, newest at the right; × is no number."""
    bars, last = min(len(values), columns), len(values) - 1
    shown = [values[round(last * bar / max(bars - 1, 1))] for bar in range(bars)]
    finite = [number for number in shown if math.isfinite(number)]
    low, high = min(finite, default=0.0), max(finite, default=0.0)
    return "".join(_bar(number, low, high) for number in shown).ljust(columns)


def _bar(value: float, low: float, high: float) -> str:
    if not math.isfinite(value):
        return "×"
    half = high / 2 - low / 2  # the whole may be too great for a number
    if half <= _STANDS * max(abs(high), abs(low)):
        return "─"
    return _BARS[min(int((value / 2 - low / 2) / half * len(_BARS)), len(_BARS) - 1)]


def _numbers(values: Sequence[float], unit: str, room: int, say: Say) -> str:
    """First and last, and between which values it went if it was beyond them and there is room for that."""
    first, last = f"{values[0]:.4g}", f"{values[-1]:.4g}"
    ends = first if first == last else say(Reason.of("desk.block_from_to", first=first, last=last))
    finite = [value for value in values if math.isfinite(value)]
    low, high = (f"{min(finite):.4g}", f"{max(finite):.4g}") if finite else (first, last)
    whole = ends if {low, high} <= {first, last} else f"{ends} ({low}..{high})"
    return f"{whole if len(whole) + len(unit) < room else ends} {unit}".rstrip()
