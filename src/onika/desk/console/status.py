"""The status of tasks by columns: each name that STATINFO knows, and what stands under it (§A.5, requirement A11)."""

from collections.abc import Callable

from onika.desk.run import text_table
from onika.model.preferences import STATUS_COLUMNS
from onika.wire.live import TaskFigure

UNITS = {
    "ref-F": "Hz", "mez-F": "Hz", "ref-T": "ms", "mez-T": "ms", "ptime": "s", "tot-C": "ms", "tick": "ms",
    "min-U": "%", "max-U": "%", "avg-U": "%", "min-C": "ms", "max-C": "ms", "avg-C": "ms",
}  # fmt: skip
"""The unit of each column that has one."""


def overview(figures: list[TaskFigure], columns: tuple[str, ...]) -> list[str]:
    """One row for each task, the chosen columns; the subsystem only where there are several."""
    several = len({one.subsystem for one in figures}) > 1
    names = ("subsystem",) * several + ("task", *columns)
    heads = [f"{name}/{UNITS[name]}" if name in UNITS else name for name in names]
    rows = [[one.subsystem] * several + [one.task, *(cell(one, name) for name in columns)] for one in figures]
    return text_table.lines(heads, rows)


def whole(figure: TaskFigure) -> list[str]:
    """Every column of one task, one line each."""
    rows = [(name, cell(figure, name), UNITS.get(name, "")) for name in STATUS_COLUMNS]
    width = max(len(text) for _, text, _ in rows)
    return [
        f"{figure.subsystem}/{figure.task}",
        *(f"  {name:<6}  {text:>{width}}  {unit}".rstrip() for name, text, unit in rows),
    ]


def cell(figure: TaskFigure, column: str) -> str:
    """What stands under a column; raises KeyError for a name that STATINFO does not know."""
    return _CELLS[column](figure)


def _number(value: float, digits: int) -> str:
    return f"{value:.{digits}f}"


def _period(hz: float) -> str:
    """Of a frequency, in ms; `-` where there is none."""
    return _number(1e3 / hz, 3) if hz > 0 else "-"


def _rate(hz: float) -> str:
    return _number(hz, 1) if hz > 0 else "-"


_CELLS: dict[str, Callable[[TaskFigure], str]] = {
    "rmod": lambda one: one.rmod,
    "rtpu": lambda one: one.rtpu,
    "tid": lambda one: str(one.tid),
    "S": lambda one: one.type,
    "crit": lambda one: str(one.crit),
    "state": lambda one: one.state,
    "cycle": lambda one: str(one.cycle),
    "miss": lambda one: str(one.miss),
    "ref-F": lambda one: _rate(one.ref_hz),
    "ref-T": lambda one: _period(one.ref_hz),
    "mez-F": lambda one: _rate(one.mez_hz),
    "mez-T": lambda one: _period(one.mez_hz),
    "ptime": lambda one: _number(one.ptime_s, 2),
    "tot-C": lambda one: _number(one.total_ms, 2),
    "tick": lambda one: _number(one.tick_ms, 6).rstrip("0").rstrip("."),
    "min-U": lambda one: _number(one.least_use * 100, 1),
    "max-U": lambda one: _number(one.most_use * 100, 1),
    "avg-U": lambda one: _number(one.mean_use * 100, 1),
    "min-C": lambda one: _number(one.least_ms, 3),
    "max-C": lambda one: _number(one.most_ms, 3),
    "avg-C": lambda one: _number(one.mean_ms, 3),
    "warn": lambda one: str(one.warn),
}
