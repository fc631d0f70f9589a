"""The statistics of a run: what is counted and read for its result."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

from msgspec import structs

from onika.host.run.transfer_statistics import TransferStatistics
from onika.runtime.news import Statuses, TaskStatus
from onika.runtime.table import Table, plain
from onika.wire import event
from onika.wire.figures import TaskFigures
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class Meeting:
    """Flows that began together, and what lay between the first cycles of the first and the last of them."""

    tag: str
    flows: tuple[int, ...]
    skew_us: float


class RunStatistics:
    """Filled by the runner, told at the end."""

    def __init__(self, watch: tuple[str, ...]) -> None:
        self._watch = watch
        self._finished_at: dict[int, int] = {}
        self._figures: dict[tuple[str, str], TaskFigures] = {}
        self._switches: list[float] = []
        self._skews: list[float] = []
        self._meetings: dict[int, tuple[str, tuple[int, ...], dict[int, int]]] = {}
        self.strides = TransferStatistics()
        self.values: dict[str, Any] = {}
        self.done = 0
        self.completed = False
        self.cause: Reason = NOTHING
        self.remarks: list[Reason] = []
        """What went wrong after the last action."""
        self.began_at = 0
        self.ended_at = 0

    def finished(self, flow: int, now: int) -> None:
        """A trigger has finished."""
        self._finished_at[flow] = now

    def meets(self, tag: str, flows: tuple[int, ...]) -> None:
        """Flows begin together."""
        first_cycles: dict[int, int] = {}
        for flow in flows:
            self._finished_at.pop(flow, None)  # it has waited: that is no switch
            self._meetings[flow] = (tag, flows, first_cycles)

    def first_cycle(self, flow: int, at: int) -> Meeting | None:
        """A task had its first cycle after coming on; the first one after a finish ends the switch.

        The meeting, if that of this flow was the last one missing in it.
        """
        finished = self._finished_at.pop(flow, None)
        if finished is not None:
            self._switches.append((at - finished) / 1e3)
        if flow not in self._meetings:
            return None
        tag, flows, first_cycles = self._meetings.pop(flow)
        first_cycles[flow] = at
        if len(first_cycles) < len(flows):
            return None
        skew = (max(first_cycles.values()) - min(first_cycles.values())) / 1e3
        self._skews.append(skew)
        return Meeting(tag, flows, skew)

    def figures(self, statuses: Statuses, subsystems: Collection[str]) -> None:
        """The statuses of one RTPU; whoever asked for them, they add up to the figures of the run."""
        for task_status in statuses.tasks:
            if task_status.subsystem in subsystems:
                address = (task_status.subsystem, task_status.task)
                self._figures[address] = _sum(self._figures.get(address), _figures(statuses.rtpu, task_status))

    def read(self, tables: Mapping[str, Table]) -> None:
        """Read the watched variables; an address without a subsystem is looked for in all, in order."""
        for address in self._watch:
            home, _, name = address.rpartition("/")
            for subsystem, table in tables.items():
                if home in ("", subsystem) and name in table.entries:
                    self.values[address] = plain(table.value(name))
                    break

    def end(self, completed: bool, cause: Reason, now: int) -> None:
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
            tasks=tuple(self._figures[address] for address in sorted(self._figures)),
            hash=digest,
            switches_us=tuple(self._switches),
            skews_us=tuple(self._skews),
            steps=self.strides.figures(self.began_at),
            remarks=tuple(self.remarks),
        )


def _figures(rtpu: str, task_status: TaskStatus) -> TaskFigures:
    times = (round(task_status.mean_us, 1), round(task_status.most_us, 1))
    return TaskFigures(
        task_status.subsystem,
        task_status.task,
        rtpu,
        round(task_status.reference_hz, 3),
        task_status.cycle,
        task_status.miss,
        *times,
    )


def _sum(before: TaskFigures | None, more: TaskFigures) -> TaskFigures:
    if before is None:
        return more
    cycles = before.cycles + more.cycles
    mean = (before.cycles * before.mean_us + more.cycles * more.mean_us) / cycles if cycles else 0.0
    most = max(before.most_us, more.most_us)
    missed = before.missed + more.missed
    return structs.replace(more, cycles=cycles, missed=missed, mean_us=round(mean, 1), most_us=most)
