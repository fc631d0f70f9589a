"""How the explanation of a stop is told to people: a short block of lines, for any width from 60 columns (X06)."""

import math
from collections.abc import Iterator, Sequence
from textwrap import wrap
from typing import Any

from onika.wire import event

_LABEL = 13
"""Columns before the text: the time of the first line, the labels of the others."""
_STANDS = 5e-4
"""A value that moves by less than this share of itself stands: its noise would look like a storm."""
_BARS = "▁▂▃▄▅▆▇█"
_NUMBERS = 34
"""Columns of first, last, lowest and highest value."""


def lines(one: event.Explained, width: int = 80) -> Iterator[str]:
    """The block: what, suspect, chain, places, who waits, the last seconds, the choices."""
    who = "/".join(part for part in (one.subsystem, one.task) if part)
    head = f"{'STOP' if one.choices else 'END'} {who}: " if who else f"{'STOP' if one.choices else 'END'}: "
    yield from _filled(f"{one.at_s:8.2f} s  ", f"{head}{one.text}", width)
    if one.suspect:
        yield from _labelled("suspect", one.suspect, width)
    yield from _labelled("chain", _chain(one), width)
    yield from _labelled("where", _where(one), width)
    if one.courses:
        span = _span(one.courses)
        yield from _rows(f"last {span:.{1 if span >= 1 else 2}f} s", _table(one.courses, width))
    yield from _choices(one.choices, width)


def _chain(one: event.Explained) -> str:
    """Task, job, flow, who waits; nothing where there is but one link."""
    action = f"action {one.index + 1}, {one.action}" if one.action else ""
    waits = [f"{flow} waits" + (f" at {tag}" if tag else "") for flow, tag in one.waiting]
    links = [link for link in (one.task, action, one.subsystem, *waits) if link]
    return " > ".join(links) if len(links) > 1 else ""


def _where(one: event.Explained) -> str:
    code = f"{one.path}:{one.line}" if one.path and one.line else one.path
    return ", ".join(part for part in (code, one.place) if part)


def _choices(choices: Sequence[tuple[str, str]], width: int) -> Iterator[str]:
    column = max((len(command) for command, _ in choices), default=0) + 2
    label = "you can"
    for command, meaning in choices:
        yield from _filled(f"{_label(label)}{command:<{column}}", meaning, width)
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
    times = [at for one in courses for at in one.at_s]
    return max(times) - min(times) if times else 0.0


def _table(courses: Sequence[event.Course], width: int) -> list[str]:
    """Of each variable the element that says most, as a curve and in numbers."""
    found = [(one, *_element(one.values)) for one in courses]
    names = max(len(_name(one, index)) for one, index, _ in found)
    columns = min(max(width - _LABEL - names - _NUMBERS - 2, 8), 40)
    room = width - _LABEL - names - columns - 2
    rows = []
    for one, index, values in found:
        numbers = _numbers(values, _unit(one.unit, index), room)
        rows.append(f"{_name(one, index):<{names}} {_curve(values, columns)} {numbers}")
    return rows


def _name(one: event.Course, index: Sequence[int]) -> str:
    return one.variable + (f"[{','.join(map(str, index))}]" if index else "")


def _unit(unit: str, index: Sequence[int]) -> str:
    """The unit of an element, where each has its own; empty for a bare number."""
    units = unit.split(",")
    found = units[index[0]] if index and index[0] < len(units) > 1 else unit
    return "" if found == "-" else found


def _element(samples: Sequence[Any]) -> tuple[tuple[int, ...], list[float]]:
    """Of a vector the element that has become no number, else the one that has moved most; with its index."""
    elements = [_leaves(one) for one in samples]
    of_each = {index: [float(one[index]) for one in elements if index in one] for index in elements[-1]}
    index = max(of_each, key=lambda one: _interest(of_each[one]))
    return index, of_each[index]


def _interest(values: Sequence[float]) -> float:
    finite = [one for one in values if math.isfinite(one)]
    return math.inf if len(finite) < len(values) else max(finite) - min(finite)


def _leaves(value: Any, index: tuple[int, ...] = ()) -> dict[tuple[int, ...], Any]:
    if not isinstance(value, list):
        return {index: value}
    return {k: v for number, one in enumerate(value) for k, v in _leaves(one, (*index, number)).items()}


def _curve(values: Sequence[float], columns: int) -> str:
    """The values as bars, at most one for each, newest at the right; × is no number."""
    bars, last = min(len(values), columns), len(values) - 1
    shown = [values[round(last * one / max(bars - 1, 1))] for one in range(bars)]
    finite = [one for one in shown if math.isfinite(one)]
    low, high = (min(finite), max(finite)) if finite else (0.0, 0.0)
    return "".join(_bar(one, low, high) for one in shown).ljust(columns)


def _bar(value: float, low: float, high: float) -> str:
    if not math.isfinite(value):
        return "×"
    half = high / 2 - low / 2  # the whole may be too great for a number
    if half <= _STANDS * max(abs(high), abs(low)):
        return "─"
    return _BARS[min(int((value / 2 - low / 2) / half * len(_BARS)), len(_BARS) - 1)]


def _numbers(values: Sequence[float], unit: str, room: int) -> str:
    """First and last, and between which values it went if it was beyond them and there is room for that."""
    first, last = f"{values[0]:.4g}", f"{values[-1]:.4g}"
    ends = first if first == last else f"{first} to {last}"
    finite = [one for one in values if math.isfinite(one)]
    low, high = (f"{min(finite):.4g}", f"{max(finite):.4g}") if finite else (first, last)
    whole = ends if {low, high} <= {first, last} else f"{ends} ({low}..{high})"
    return f"{whole if len(whole) + len(unit) < room else ends} {unit}".rstrip()
