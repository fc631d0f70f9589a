"""Figures of tasks under the names of §A.5; counters, which begin anew whenever they are asked for, are added up."""

from collections.abc import Mapping
from typing import Any

from onika.wire import live

_COUNTED = ("cycle", "miss", "warn", "tot-C", "ptime")
"""What grows as long as a task lives; everything else is of the time since figures were asked for last."""


class Tally:
    """The figures of every task, from one answer to the next."""

    def __init__(self) -> None:
        self._sums: dict[tuple[str, str, int], dict[str, float]] = {}

    def add(self, figures: live.Figures, docs: Mapping[str, str]) -> dict[str, dict[str, Any]]:
        """The rows by `DOC/TASK`; `docs` are the documents by their subsystems."""
        sums: dict[tuple[str, str, int], dict[str, float]] = {}
        rows: dict[str, dict[str, Any]] = {}
        for one in figures.tasks:
            row = columns(one)
            key = (one.subsystem, one.task, one.tid)
            before = self._sums.get(key, {})
            sums[key] = {name: row[name] + before.get(name, 0) for name in _COUNTED}
            if one.subsystem in docs:
                rows[f"{docs[one.subsystem]}/{one.task}"] = row | sums[key]
        self._sums = sums
        return rows


def columns(one: live.TaskFigure) -> dict[str, Any]:
    """Every column of §A.5; None where there is nothing to say. Shares are 0 to 1, times in ms, ptime in s."""
    return {
        "rmod": one.rmod,
        "rtpu": one.rtpu,
        "tid": one.tid,
        "S": one.type,
        "crit": one.crit,
        "state": one.state,
        "cycle": one.cycle,
        "miss": one.miss,
        "ref-F": one.ref_hz or None,
        "ref-T": 1e3 / one.ref_hz if one.ref_hz > 0 else None,
        "mez-F": one.mez_hz or None,
        "mez-T": 1e3 / one.mez_hz if one.mez_hz > 0 else None,
        "ptime": one.ptime_s,
        "tot-C": one.total_ms,
        "tick": one.tick_ms,
        "min-U": one.least_use,
        "max-U": one.most_use,
        "avg-U": one.mean_use,
        "min-C": one.least_ms,
        "max-C": one.most_ms,
        "avg-C": one.mean_ms,
        "warn": one.warn,
    }
