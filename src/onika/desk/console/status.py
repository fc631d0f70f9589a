"""The columns of the status table: what each name of STATINFO shows of a task (requirement A11, §A.5)."""

from collections.abc import Callable

from onika.desk.run.text_table import Cell
from onika.model.preferences import STATUS_COLUMNS
from onika.wire.live import TaskFigure
from onika.words.reason import Reason

UNITS = {
    "ref-F": "Hz", "mez-F": "Hz", "ref-T": "ms", "mez-T": "ms", "ptime": "s", "tot-C": "ms", "tick": "ms",
    "min-U": "%", "max-U": "%", "avg-U": "%", "min-C": "ms", "max-C": "ms", "avg-C": "ms",
}  # fmt: skip
"""The unit of each column that has one."""


def overview(figures: list[TaskFigure], columns: tuple[str, ...]) -> tuple[list[Cell], list[list[Cell]]]:
    """The head, and one row for each task with the chosen columns; the subsystem only where there are several."""
    several = len({figure.subsystem for figure in figures}) > 1
    head: list[Cell] = [Reason.of("console.head_subsystem")] * several
    head += [Reason.of("console.head_task"), *map(_head, columns)]
    rows: list[list[Cell]] = [
        [*[figure.subsystem] * several, figure.task, *(cell(figure, name) for name in columns)] for figure in figures
    ]
    return head, rows


def _head(column: str) -> str:
    """The name of a column, as STATINFO has it, with its unit."""
    if column in UNITS:
        return f"{column}/{UNITS[column]}"
    return column


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
    "rmod": lambda figure: figure.rmod,
    "rtpu": lambda figure: figure.rtpu,
    "tid": lambda figure: str(figure.tid),
    "S": lambda figure: figure.type,
    "crit": lambda figure: str(figure.crit),
    "state": lambda figure: figure.state,
    "cycle": lambda figure: str(figure.cycle),
    "miss": lambda figure: str(figure.miss),
    "ref-F": lambda figure: _rate(figure.ref_hz),
    "ref-T": lambda figure: _period(figure.ref_hz),
    "mez-F": lambda figure: _rate(figure.mez_hz),
    "mez-T": lambda figure: _period(figure.mez_hz),
    "ptime": lambda figure: _number(figure.ptime_s, 2),
    "tot-C": lambda figure: _number(figure.total_ms, 2),
    "tick": lambda figure: _number(figure.tick_ms, 6).rstrip("0").rstrip("."),
    "min-U": lambda figure: _number(figure.least_use * 100, 1),
    "max-U": lambda figure: _number(figure.most_use * 100, 1),
    "avg-U": lambda figure: _number(figure.mean_use * 100, 1),
    "min-C": lambda figure: _number(figure.least_ms, 3),
    "max-C": lambda figure: _number(figure.most_ms, 3),
    "avg-C": lambda figure: _number(figure.mean_ms, 3),
    "warn": lambda figure: str(figure.warn),
}
