"""The rounds of a unit: once its tasks have been the same for a while, they have their cycles by sweeps.

Only where nobody else writes or asks while a sweep runs, as in virtual time. Whatever happens, a command, a signal or a
fault, ends the rounds: then each task is due by itself, and the executive goes on as if there had been none.
"""

from collections import OrderedDict
from collections.abc import Sequence
from heapq import heapreplace
from typing import NamedTuple, cast

from onika.model.signal import Signal
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.execution.sweep import Sweep
from onika.runtime.execution.unit import ProcessingUnit
from onika.runtime.execution.whereabouts import Whereabouts
from onika.runtime.modules.binding import Binding
from onika.runtime.scheduler import SlotGroup, TaskSlot

STEADY = 100
"""So many instants the same tasks are due before a sweep is made of them: that costs about what it then saves in as
many."""
_STEADY_AGAIN = 2
"""So many, where the sweeps are there already."""
_KEPT = 32
"""Sweeps that are kept."""


class SweepStop(NamedTuple):
    """Where a sweep has ended early: the slot of the task, its signal, and what it raised instead of its cycle.

    Without a slot no task has had its cycle.
    """

    slot: TaskSlot | None
    signal: Signal | None
    wrong: BaseException | None


_Member = tuple[RunningTask, Binding, int]


class _Round(SlotGroup):
    """A group with the sweep of its tasks, and their titles in one."""

    __slots__ = ("laps_left", "run", "sweep", "titles")

    def __init__(self, slots: Sequence[TaskSlot], sweep: Sweep) -> None:
        super().__init__(slots)
        self.sweep = sweep
        self.run = sweep.run
        self.laps_left = sweep.most_laps
        self.titles = ", ".join(slot.key[2] for slot in slots)


class Rounds:
    """Decides when sweeps are made, and runs them; `steady` is for how many instants the tasks must have been alike."""

    def __init__(self, unit: ProcessingUnit, whereabouts: Whereabouts, steady: int = STEADY) -> None:
        self.groups = cast("list[tuple[int, int, _Round]]", unit.scheduler.groups)
        """The groups that are due, as a heap; empty where each task is due by itself."""
        self._unit = unit
        self._whereabouts = whereabouts
        self._steady = steady
        self._instants = 0
        self._kept: OrderedDict[tuple[_Member, ...], Sweep] = OrderedDict()

    def end(self) -> None:
        """Each task is due by itself again."""
        self._instants = 0
        if self.groups:
            self._count()
            self._unit.scheduler.part()

    def forget(self) -> None:
        """End, and keep no sweep: what they are bound to may become another thing."""
        self.end()
        self._kept.clear()

    def run(self, now: int) -> SweepStop | None:
        """Everything that is due; what is left of it, where a sweep stops or an instant has to go one by one.

        Then the rounds are over, and the task of the slot, if any, has its cycle.
        """
        groups, also = self.groups, self._whereabouts.also
        while groups[0][0] == now:
            _, deadline, group = groups[0]
            if not group.laps_left:
                group.sweep.count()
                group.laps_left = group.sweep.most_laps
                if not group.laps_left:  # somebody's module is to be looked at
                    self.end()
                    self._instants = _STEADY_AGAIN - 1
                    return SweepStop(None, None, None)
            group.laps_left -= 1
            if also is not None:
                also(group.titles)
            stop = group.run(now)
            if stop is not None:
                return self._stopped(group, *stop)
            heapreplace(groups, (deadline, deadline + group.period, group))
        if also is not None:
            also("")
        return None

    def _stopped(self, group: _Round, place: int, signal: Signal | None, wrong: BaseException | None) -> SweepStop:
        self._instants = 0
        group.sweep.count(place if wrong is not None else place + 1)
        self._count()
        return SweepStop(self._unit.scheduler.part_at(place), signal, wrong)

    def note_instant(self) -> None:
        """All that was due has been carried out one by one, and nothing came of it."""
        self._instants += 1
        if self._instants >= self._steady:
            self._instants = 0
            self._begin(makes=True)
        elif self._instants == _STEADY_AGAIN:
            self._begin(makes=False)

    # Inner

    def _count(self) -> None:
        for _, _, group in self.groups:
            group.sweep.count()

    def _begin(self, *, makes: bool) -> None:
        unit, rounds = self._unit, []
        for slots in unit.scheduler.gathered():
            sweep = self._sweep([unit.slots[slot] for slot in slots], makes=makes)
            if sweep is None:
                return
            rounds.append(_Round(slots, sweep))
        unit.scheduler.group(rounds)

    def _sweep(self, tasks: list[RunningTask], *, makes: bool) -> Sweep | None:
        if any(task.is_first or not task.is_periodic for task in tasks):
            return None
        key = tuple((task, task.binding, task.check_mask) for task in tasks)
        kept = self._kept.get(key)
        if kept is not None:
            self._kept.move_to_end(key)
        elif makes:
            kept = self._kept[key] = Sweep(tasks, self._whereabouts)
            if len(self._kept) > _KEPT:
                self._kept.popitem(last=False)
        return kept
