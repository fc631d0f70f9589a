"""The check of a table's memory: what a faulty module overwrote, and which tasks could have done it (requirement A12).

Each entry has a guard before it, seals on its values and a count of strange publications (`ring.slots`). A task reaches
shared memory by its rings alone; what else writes there has gone astray, and memory does not tell who wrote it. So a
finding names whoever could have: its declared writers, tasks bound to what lies beside it, then all that share the
table. What rests is sealed whole; of what is written each cycle one publication in eight (none above 512 bytes), so a
value that is written over in place may pass one check. Not found: a forged seal, and a
counter that was moved by so little that it names a neighbouring value before the same writer makes the next.
"""

from collections.abc import Iterable
from dataclasses import dataclass

from onika.runtime.table import Table
from onika.runtime.wiring import WiredTask
from onika.words.reason import NOTHING, Reason

_LOOKED_AT_BEHIND = 4096
"""Bytes behind the last entry: an overrun of more would have met something else."""


@dataclass(frozen=True, slots=True)
class Accessor:
    """A task with access to the table: where it runs, and the variables it is bound to."""

    task: str
    rtpu: str
    writes: frozenset[str]
    reads: frozenset[str]


@dataclass(frozen=True, slots=True)
class Finding:
    """What is wrong with a variable's memory; `likely` and `others` say who could have written it and why."""

    variable: str | Reason
    wrong: tuple[Reason, ...]
    likely: tuple[Reason, ...]
    others: tuple[Reason, ...]

    @property
    def reason(self) -> Reason:
        """All of it as sentences."""
        likely = Reason.of("runtime.likely_writers", writers=self.likely) if self.likely else NOTHING
        others = Reason.of("runtime.other_writers", writers=self.others) if self.others else NOTHING
        return Reason.of("runtime.unsound", variable=self.variable, wrong=self.wrong, likely=likely, others=others)


def accessor(wired: WiredTask, rtpu: str) -> Accessor:
    """A task of a subsystem as the check sees it."""
    writes = frozenset((*wired.outconst, *wired.outvar))
    return Accessor(wired.name, rtpu, writes, frozenset((*wired.inconst, *wired.invar)))


def check(table: Table, tasks: Iterable[Accessor]) -> list[Finding]:
    """Everything that is wrong in a table, in the order of memory; while tasks write it, too."""
    everyone = sorted(tasks, key=lambda accessor: (accessor.rtpu, accessor.task))
    entries = sorted(table.entries.values(), key=lambda entry: entry.offset)
    findings = []
    for place, entry in enumerate(entries):
        wrong = table.ring(entry.name).faults()
        beside = [neighbour.name for neighbour in entries[max(place - 1, 0) : place + 2] if neighbour is not entry]
        if wrong:
            findings.append(_finding(entry.name, wrong, beside, everyone))
    behind = table.segment.view[table.end : table.end + _LOOKED_AT_BEHIND]
    if any(behind) and entries:
        wrong = [Reason.of("runtime.behind_overwritten", variable=entries[-1].name)]
        findings.append(_finding(Reason.of("runtime.free_memory"), wrong, [entries[-1].name], everyone))
    return findings


def _finding(variable: str | Reason, wrong: list[Reason], beside: list[str], tasks: list[Accessor]) -> Finding:
    likely, others = [], []
    for task in tasks:
        why = _why(task, variable, beside)
        if why:
            likely.append(Reason.of("runtime.writer_why", task=task.task, rtpu=task.rtpu, why=why))
        else:
            others.append(Reason.of("runtime.writer", task=task.task, rtpu=task.rtpu))
    return Finding(variable, tuple(wrong), tuple(likely), tuple(others))


def _why(task: Accessor, variable: str | Reason, beside: list[str]) -> Reason:
    """Why a task comes into question before others; nothing if it only shares the table."""
    if variable in task.writes:
        return Reason.of("runtime.writes_it")
    neighbours = [name for name in beside if name in task.writes or name in task.reads]
    if neighbours:
        return Reason.of("runtime.bound_beside", names=tuple(neighbours))
    return Reason.of("runtime.reads_it") if variable in task.reads else NOTHING
