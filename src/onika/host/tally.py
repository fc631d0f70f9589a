"""The tally of a run: what is counted and read for its result."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from onika.runtime.news import Statuses
from onika.runtime.table import Table
from onika.wire import event


class Tally:
    """Filled by the runner, told at the end."""

    def __init__(self, watch: tuple[str, ...]) -> None:
        self._watch = watch
        self._finished_at: dict[int, int] = {}
        self._figures: list[event.TaskFigures] = []
        self._switches: list[float] = []
        self.answered: set[str] = set()
        self.values: dict[str, Any] = {}
        self.done = 0
        self.completed = False
        self.cause = ""
        self.began_at = 0
        self.ended_at = 0

    def finished(self, flow: int, now: int) -> None:
        """A trigger has finished."""
        self._finished_at[flow] = now

    def first_cycle(self, flow: int, at: int) -> None:
        """A task had its first cycle after coming on; the first one after a finish ends the switch."""
        finished = self._finished_at.pop(flow, None)
        if finished is not None:
            self._switches.append((at - finished) / 1e3)

    def figures(self, statuses: Statuses) -> None:
        """The statuses of one RTPU."""
        for one in statuses.tasks:
            self._figures.append(
                event.TaskFigures(
                    one.subsystem,
                    one.task,
                    statuses.rtpu,
                    round(one.reference_hz, 3),
                    one.cycle,
                    one.miss,
                    round(one.mean_us, 1),
                    round(one.most_us, 1),
                )
            )

    def read(self, tables: Mapping[str, Table]) -> None:
        """Read the watched variables; an address without a subsystem is looked for in all, in order."""
        for address in self._watch:
            home, _, name = address.rpartition("/")
            for subsystem, table in tables.items():
                if home in ("", subsystem) and name in table.entries:
                    self.values[address] = plain(table.value(name))
                    break

    def end(self, completed: bool, cause: str, now: int) -> None:
        """The engine's last word; only the first one counts."""
        if not self.ended_at:
            self.completed, self.cause, self.ended_at = completed, cause, now

    def result(self, actions: int, wall_s: float, digest: str) -> event.Result:
        """The last event of the run."""
        return event.Result(
            completed=self.completed,
            cause=self.cause,
            done=self.done,
            of=actions,
            runtime_s=round((self.ended_at - self.began_at) * 1e-9, 9),
            wall_s=wall_s,
            values=self.values,
            tasks=tuple(sorted(self._figures, key=lambda one: (one.subsystem, one.task))),
            hash=digest,
            switches_us=tuple(self._switches),
        )


def plain(value: Any) -> Any:
    """A value that travels: arrays as lists."""
    return value.tolist() if isinstance(value, np.ndarray) else value
