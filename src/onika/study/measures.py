"""What the log of a task comes to: the statistics of §E.3, its pauses, and whether the first try succeeded (H02).

All time of a task is parted among what it was for, so that the parts add up to the elapsed time (reading 42): up to a
selection in the dictionary it is *selection*, from there to the insertion *insertion*, from the last edit to an
attempt to run *check*, while a run goes *run*; what is left is *other*. A selection is meaningful where an insertion
follows before the next selection; what fruitless ones before it took belongs to it.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from statistics import fmean, stdev

from onika.study.log import LogEntry, elapsed_s
from onika.study.session import CLOSE, NEW, RUN, TRY_NEW, TRY_RUN, StudyTask, is_end, is_request

PAUSE_S = 15.0
"""An interval without an event, outside of runs, that is at least so long counts as a pause."""
_EDITS = frozenset(
    (
        "insert_icon", "insert_branch", "delete_icon", "exchange_icon", "move_icon",
        "copy_icon", "cut_icon", "paste_icon", "edit_icon", "set_marker",
        "set_synchtag", "set_whiletag", "remove_whiletag", "add_flow", "delete_flow",
        "set_parallel", "set_conditions", "undo", "redo", "open_appl",
    )
)  # fmt: skip
_DELETIONS = ("delete_icon", "cut_icon")


@dataclass(frozen=True, slots=True)
class TaskMeasures:
    """The figures of one task; times in seconds. NaN: there is nothing of which it could be said."""

    elapsed_s: float
    """From *New* to the end of the run that succeeded; NaN where none did, or its end is not known."""
    building_s: float
    """Elapsed time but for that of runs, as in tables 1 to 3."""
    request_s: float
    """Up to the new application, from the press or the panel that asked for it."""
    selection_s: float
    selections: int
    """Meaningful ones."""
    all_selections: int
    mean_selection_s: float
    selection_spread_s: float
    """Standard deviation of the meaningful ones."""
    insertion_s: float
    insertions: int
    mean_insertion_s: float
    unselected_s: float
    unselected: int
    """Insertions without a selection before them; their time is among that of all insertions."""
    deletions: int
    """Icons that were deleted."""
    undone: int
    refused: int
    """Acts that were refused, but for runs."""
    check_s: float
    attempts: int
    not_run: int
    aborted: int
    """Runs that did not complete."""
    completed: int
    run_s: float
    """Of all runs."""
    completed_run_s: float
    mean_completed_run_s: float
    other_s: float
    pauses: int
    pause_s: float
    longest_pause_s: float
    has_succeeded: bool
    is_first_try: bool
    """Whether the first attempt succeeded."""


@dataclass(frozen=True, slots=True)
class IconSelection:
    """A meaningful selection: of which icon, at which line, and how long it took, in seconds."""

    icon: str
    line: int
    seconds: float


@dataclass(slots=True)
class _Meter:
    """The time of a task as it is parted, entry by entry."""

    spent: dict[str, float] = field(default_factory=dict)
    picked: list[IconSelection] = field(default_factory=list)
    pauses: list[float] = field(default_factory=list)
    counts: dict[str, int] = field(default_factory=dict)
    since_edit: list[tuple[str, float]] = field(default_factory=list)
    """What was spent since the last edit or run, and for what; an attempt to run makes all of it check."""
    since_select: list[tuple[str, float]] = field(default_factory=list)
    """What was spent since the selection; an insertion makes all of it insertion."""
    pending: LogEntry | None = None
    """The selection that no insertion has followed yet, and"""
    search_s: float = 0.0
    """how long it took, with those before it that led to nothing."""
    ended: frozenset[tuple[float, int]] = frozenset()
    """Times and lines at which runs begin whose end is known: of others nobody knows how long they went."""
    is_running: bool = False
    is_requesting: bool = False
    """A new application was asked for, and is not there yet."""

    def follow(self, before: LogEntry, entry: LogEntry) -> None:
        """Time passes from one entry to the next."""
        seconds = elapsed_s(before.at_s, entry.at_s)
        if before.event == "Quit_Onika" or entry.event == "Start_Onika":
            return  # nobody was at it
        if self.is_running:
            self._spend("run", seconds)
        else:
            if seconds >= PAUSE_S:
                self.pauses.append(seconds)
            self._part(entry, seconds)
        self.note(entry)

    def note(self, entry: LogEntry) -> None:
        """What an entry changes, whatever time passed before it."""
        if is_request(entry) or entry.event in (NEW, CLOSE):
            self.is_requesting = is_request(entry)
        if entry.event == RUN:
            self.is_running = (entry.at_s, entry.line) in self.ended
            self.since_edit.clear()
        elif is_end(entry):
            self.is_running = False
            self.since_edit.clear()
        self._tally(entry)

    def _tally(self, entry: LogEntry) -> None:
        """What is counted and takes no time of its own."""
        if entry.event in _DELETIONS and entry.window == "appl":
            self._count("deletions", len(entry.id.split(",")))
        elif entry.event == "undo":
            self._count("undone")
        elif entry.event.startswith("try_") and entry.event not in (TRY_RUN, TRY_NEW):
            self._count("refused")

    def _part(self, entry: LogEntry, seconds: float) -> None:
        match entry.event:
            case "select_icon" if entry.window == "dict":
                self._select(entry, seconds)
            case "insert_icon" if entry.window == "appl":
                self._insert(seconds)
            case "run_appl" | "try_run_appl":
                self._check(seconds)
            case _ if self.is_requesting:
                self._spend("request", seconds)
            case _:
                self._later("other", seconds)
        if entry.event in _EDITS and entry.window != "dict":
            self.since_edit.clear()
            self.since_select.clear()

    def _select(self, entry: LogEntry, seconds: float) -> None:
        self._count("selections")
        self.search_s += seconds
        self._later("selection", seconds)
        self.since_select.clear()
        self.pending = entry

    def _insert(self, seconds: float) -> None:
        """An insertion: all since the selection, or since the last edit after it, was for it."""
        self._count("insertions")
        if self.pending is None:
            self._count("unselected")
            self._spend("unselected", seconds)
            return
        for purpose, spent in self.since_select:
            self.spent[purpose] -= spent
        self._spend("insertion", seconds + sum(spent for _, spent in self.since_select))
        self.picked.append(IconSelection(self.pending.object, self.pending.line, self.search_s))
        self.pending, self.search_s = None, 0.0

    def _check(self, seconds: float) -> None:
        for purpose, spent in self.since_edit:
            self.spent[purpose] -= spent
        self._spend("check", seconds + sum(spent for _, spent in self.since_edit))
        self.since_edit.clear()
        self.since_select.clear()
        self.pending, self.search_s = None, 0.0

    def _later(self, purpose: str, seconds: float) -> None:
        """Spend, but remember it: what comes may say otherwise what it was for."""
        self._spend(purpose, seconds)
        self.since_edit.append((purpose, seconds))
        self.since_select.append((purpose, seconds))

    def _spend(self, purpose: str, seconds: float) -> None:
        self.spent[purpose] = self.spent.get(purpose, 0.0) + seconds

    def _count(self, what: str, number: int = 1) -> None:
        self.counts[what] = self.counts.get(what, 0) + number


def measure(task: StudyTask) -> tuple[TaskMeasures, tuple[IconSelection, ...]]:
    """The figures of a task, and each meaningful selection."""
    ended = frozenset((attempt.at_s, attempt.line) for attempt in task.attempts if attempt.end_s is not None)
    meter = _Meter(ended=ended)
    if task.entries:
        meter.note(task.entries[0])
    for before, entry in pairwise(task.entries):
        meter.follow(before, entry)
    return _measures(task, meter), tuple(meter.picked)


def _measures(task: StudyTask, meter: _Meter) -> TaskMeasures:
    spent, counts = meter.spent, meter.counts
    selected = [selection.seconds for selection in meter.picked]
    insertion_s = spent.get("insertion", 0.0) + spent.get("unselected", 0.0)
    insertions = counts.get("insertions", 0)
    runs = [attempt for attempt in task.attempts if attempt.is_run]
    completed = [
        elapsed_s(attempt.at_s, attempt.end_s) for attempt in runs if attempt.is_completed and attempt.end_s is not None
    ]
    all_s = sum(spent.values()) if task.success else math.nan
    return TaskMeasures(
        elapsed_s=all_s if task.success and task.success.end_s is not None else math.nan,
        building_s=all_s - spent.get("run", 0.0),
        request_s=spent.get("request", 0.0),
        selection_s=spent.get("selection", 0.0),
        selections=len(selected),
        all_selections=counts.get("selections", 0),
        mean_selection_s=_mean(selected),
        selection_spread_s=_spread(selected),
        insertion_s=insertion_s,
        insertions=insertions,
        mean_insertion_s=_each(insertion_s, insertions),
        unselected_s=spent.get("unselected", 0.0),
        unselected=counts.get("unselected", 0),
        deletions=counts.get("deletions", 0),
        undone=counts.get("undone", 0),
        refused=counts.get("refused", 0),
        check_s=spent.get("check", 0.0),
        attempts=len(task.attempts),
        not_run=len(task.attempts) - len(runs),
        aborted=sum(not attempt.is_completed for attempt in runs),
        completed=len(completed),
        run_s=spent.get("run", 0.0),
        completed_run_s=sum(completed),
        mean_completed_run_s=_mean(completed),
        other_s=spent.get("other", 0.0),
        pauses=len(meter.pauses),
        pause_s=sum(meter.pauses),
        longest_pause_s=max(meter.pauses, default=0.0),
        has_succeeded=task.success is not None,
        is_first_try=task.success is not None and len(task.attempts) == 1,
    )


def _mean(values: Sequence[float]) -> float:
    if not values:
        return math.nan
    return fmean(values)


def _spread(values: Sequence[float]) -> float:
    if len(values) < 2:
        return math.nan
    return stdev(values)


def _each(seconds: float, count: int) -> float:
    if not count:
        return math.nan
    return seconds / count
