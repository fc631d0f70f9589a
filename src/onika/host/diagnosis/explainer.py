"""The explainer of a run: remembers its variables, and tells of each stop once, as it happens (requirement X06).

The runner makes one when the run starts, ticks it like any other clockwork, and tells the engine under its eyes what
may stop a flow or the run:

    with self._explainer.watch(heard, now):  # Failed, Signalled, Refused, Asked, or a Cause of its own
        self._feed(...)

It looks at the flows before and after. A flow that has stopped meanwhile, or a run that is about to end, is explained
by what was heard; where nothing has stopped (a passive task failed), nothing is told. After everything that was told to
the engine, `look` tells of flows that have come to wait for ever.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace

from onika.host.diagnosis import stop_cause
from onika.host.diagnosis.explanation import explain
from onika.host.diagnosis.stall import causes
from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.host.diagnosis.variable_history import VariableHistory
from onika.host.loading.plan_preparation import Preparation
from onika.runtime import news
from onika.runtime.table import Table
from onika.wire import event
from onika.wire.steer import Position

Why = Cause | news.Failed | news.Signalled | news.Refused | news.Asked


class Explainer:
    """One run's. `positions` are the engine's, asked for when they are needed only."""

    def __init__(
        self,
        prepared: Preparation,
        tables: Mapping[str, Table],
        positions: Callable[[], Sequence[Position]],
        tell: Callable[[event.Event], None],
    ) -> None:
        self._tables = tables
        self._history = VariableHistory(tables)
        self._prepared = prepared
        self._positions = positions
        self._tell = tell
        self._began = 0
        self._watching = 0
        self._has_moved = False
        self._told = 0
        self._stuck: frozenset[Cause] = frozenset()
        self._is_over = False

    def begin(self, now: int) -> None:
        """The run begins: all times count from here."""
        self._began = now
        self._history = VariableHistory(self._tables, began_ns=now)

    def wake_at(self) -> int | None:
        """When `tick` has something to do."""
        return None if self._is_over else self._history.wake_at()

    def tick(self, now: int) -> None:
        """Let time pass; to be called with all that is heard of a task, too."""
        if not self._is_over:
            self._history.tick(now)

    @contextmanager
    def watch(self, why: Why, now: int) -> Iterator[None]:
        """What is told to the engine meanwhile is told because of this; of two, one in the other, the inner counts."""
        before, told = self._positions(), self._told
        self._watching += 1
        try:
            yield
        finally:
            self._watching -= 1
        after = self._positions()
        self._has_moved = True
        if self._told == told and not _is_over(before):
            cause = self._cause(why)
            if _is_over(after):
                self._explain(replace(cause, ends=True), before, now)
            elif _has_stopped(cause.subsystem, before, after):
                self._explain(cause, after, now)
                self._stuck = frozenset(causes(after))  # who waits for it is told with it
        self.look(now)

    def moved(self) -> None:
        """A flow has come into another state; `look` follows."""
        self._has_moved = True

    def look(self, now: int) -> None:
        """Tell who has come to wait for ever; nothing, and quickly, where no flow has moved."""
        if not self._has_moved or self._watching:
            return
        self._has_moved = False
        positions = self._positions()
        self._is_over = _is_over(positions)
        stuck = causes(positions)
        for cause in stuck:
            if cause not in self._stuck:
                self._explain(cause, positions, now)
        self._stuck = frozenset(stuck)

    def _explain(self, cause: Cause, positions: Sequence[Position], now: int) -> None:
        self._told += 1
        self._history.look(now)
        at_s = round((now - self._began) * 1e-9, 9)
        self._tell(explain(self._prepared, cause, positions, self._history, at_s))

    def _cause(self, why: Why) -> Cause:
        match why:
            case news.Failed():
                return stop_cause.of_failure(why, self._is_hardware(why.subsystem, why.task))
            case news.Signalled():
                return stop_cause.of_signal(why)
            case news.Refused():
                return stop_cause.of_refusal(why)
            case news.Asked():
                return stop_cause.of_question(why)
            case Cause(kind=CauseKind.LOST, task=""):
                tasks = ((flow.subsystem, task.name) for flow in self._prepared.plan.flows for task in flow.tasks)
                return stop_cause.of_loss(why.text, tasks)
            case _:
                return why

    def _is_hardware(self, subsystem: str, task: str) -> bool:
        flows = zip(self._prepared.plan.flows, self._prepared.flows, strict=True)
        wired = (wired_task for planned, flow in flows if planned.subsystem == subsystem for wired_task in flow)
        return any(wired_task.name == task and wired_task.sheet.hardware for wired_task in wired)


def _is_over(positions: Sequence[Position]) -> bool:
    return any(position.state in ("killing", "ended") for position in positions)


def _has_stopped(subsystem: str, before: Sequence[Position], after: Sequence[Position]) -> bool:
    """Whether a flow stands that did not; it has then stopped anew if it would not be cleared."""
    stood, stands = (
        next((p.state for p in positions if p.subsystem == subsystem), "") for positions in (before, after)
    )
    return stands == "stopped" and stood != "stopped"
