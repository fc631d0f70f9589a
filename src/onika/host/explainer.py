"""The explainer of a run: remembers its variables, and tells of each stop once, as it happens (requirement X06).

The runner makes one when the run starts, ticks it like any other clockwork, and tells the engine under its eyes what
may stop a flow or the run:

    with self._explainer.watch(heard, now):  # Failed, Signalled, Refused, Asked, or a Cause of its own
        self._feed(...)

It looks at the flows before and after. A flow that has stopped meanwhile, or a run that is about to end, is explained
by what was heard; where nothing has stopped (a passive task failed), nothing is told. After each move of a flow `look`
tells of flows that have come to wait for ever.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace

from onika.host import cause
from onika.host.cause import Cause
from onika.host.explanation import explain
from onika.host.history import History
from onika.host.preparation import Preparation
from onika.host.standstill import causes
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
        began_ns: int,
    ) -> None:
        self.history = History(tables, began_ns=began_ns)
        self.drives: dict[str, str] = {}
        """By device, the state of its drive in words, where somebody tells it; else what its module says counts."""
        self._prepared = prepared
        self._positions = positions
        self._tell = tell
        self._began = began_ns
        self._told = 0
        self._stuck: frozenset[Cause] = frozenset()
        self._is_over = False

    def wake_at(self) -> int | None:
        """When `tick` has something to do."""
        return None if self._is_over else self.history.wake_at()

    def tick(self, now: int) -> None:
        """Let time pass; to be called with all that is heard of a task, too."""
        if not self._is_over:
            self.history.tick(now)

    @contextmanager
    def watch(self, why: Why, now: int) -> Iterator[None]:
        """What is told to the engine meanwhile is told because of this; of two within each other the inner one counts."""
        before, told = self._positions(), self._told
        yield
        after = self._positions()
        if self._told == told and not _is_over(before):
            found = self._cause(why)
            if _is_over(after):
                self._explain(replace(found, ends=True), before, now)
            elif _has_stopped(found.subsystem, before, after):
                self._explain(found, after, now)
                self._stuck = frozenset(causes(after))  # who waits for it is told with it
        self.look(now)

    def look(self, now: int) -> None:
        """After a move of a flow: tell who waits for ever, if it is new."""
        positions = self._positions()
        self._is_over = _is_over(positions)
        stuck = causes(positions)
        for one in stuck:
            if one not in self._stuck:
                self._explain(one, positions, now)
        self._stuck = frozenset(stuck)

    def _explain(self, found: Cause, positions: Sequence[Position], now: int) -> None:
        self._told += 1
        self.history.look(now)
        at_s = round((now - self._began) * 1e-9, 9)
        self._tell(explain(self._prepared, found, positions, self.history, at_s))

    def _cause(self, why: Why) -> Cause:
        match why:
            case news.Failed():
                device = self._device(why.subsystem, why.task)
                return cause.of_failure(why, bool(device), self.drives.get(device, ""))
            case news.Signalled():
                return cause.of_signal(why)
            case news.Refused():
                return cause.of_refusal(why)
            case news.Asked():
                return cause.of_question(why)
            case _:
                return why

    def _device(self, subsystem: str, task: str) -> str:
        """The device of a hardware task; empty: it has none."""
        flows = zip(self._prepared.plan.flows, self._prepared.flows, strict=True)
        wired = (one for planned, flow in flows if planned.subsystem == subsystem for one in flow)
        return next((one.device or "" for one in wired if one.name == task and one.sheet.hardware), "")


def _is_over(positions: Sequence[Position]) -> bool:
    return any(one.state in ("killing", "ended") for one in positions)


def _has_stopped(subsystem: str, before: Sequence[Position], after: Sequence[Position]) -> bool:
    """Whether a flow stands that did not; it has then stopped anew if it would not be cleared."""
    stood, stands = (next((p.state for p in found if p.subsystem == subsystem), "") for found in (before, after))
    return stands == "stopped" and stood != "stopped"
