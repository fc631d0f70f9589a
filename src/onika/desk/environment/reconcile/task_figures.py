"""Figures of tasks under the names of §A.5; counters, which begin anew whenever they are asked for, are added up."""

from collections.abc import Mapping
from typing import Any

from onika.wire import live

_COUNTED = ("cycle", "miss", "warn", "tot-C", "ptime")
"""What grows as long as a task lives; everything else is of the time since figures were asked for last."""


class FigureTotals:
    """The figures of every task, from one answer to the next."""

    def __init__(self) -> None:
        self._sums: dict[tuple[str, str, int], dict[str, float]] = {}

    def add(self, figures: live.Figures, homes: Mapping[str, str]) -> dict[str, dict[str, Any]]:
        """The rows by `DOC/TASK`; `homes` are the subsystems of documents, and of what is looked into."""
        docs: dict[str, list[str]] = {}
        for doc, subsystem in homes.items():
            docs.setdefault(subsystem, []).append(doc)
        sums: dict[tuple[str, str, int], dict[str, float]] = {}
        rows: dict[str, dict[str, Any]] = {}
        for task in figures.tasks:
            row = columns(task)
            key = (task.subsystem, task.task, task.tid)
            before = self._sums.get(key, {})
            sums[key] = {name: row[name] + before.get(name, 0) for name in _COUNTED}
            for doc in docs.get(task.subsystem, ()):
                rows[f"{doc}/{task.task}"] = row | sums[key]
        self._sums = sums
        return rows


def columns(request: live.TaskFigure) -> dict[str, Any]:
    """Every column of §A.5; None where there is nothing to say. Shares are 0 to 1, times in ms, ptime in s."""
    return {
        "rmod": request.rmod,
        "rtpu": request.rtpu,
        "tid": request.tid,
        "S": request.type,
        "crit": request.crit,
        "state": request.state,
        "cycle": request.cycle,
        "miss": request.miss,
        "ref-F": request.ref_hz or None,
        "ref-T": 1e3 / request.ref_hz if request.ref_hz > 0 else None,
        "mez-F": request.mez_hz or None,
        "mez-T": 1e3 / request.mez_hz if request.mez_hz > 0 else None,
        "ptime": request.ptime_s,
        "tot-C": request.total_ms,
        "tick": request.tick_ms,
        "min-U": request.least_use,
        "max-U": request.most_use,
        "avg-U": request.mean_use,
        "min-C": request.least_ms,
        "max-C": request.most_ms,
        "avg-C": request.mean_ms,
        "warn": request.warn,
    }
