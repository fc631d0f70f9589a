"""The scheduler of a discrete-event simulation: what happens when in virtual time, and its random numbers."""

import heapq
from collections.abc import Callable, Hashable
from functools import partial
from random import Random

_MS = 1_000_000


class EventScheduler:
    """Plans what will happen and lets it happen; times in ns."""

    def __init__(self, seed: int) -> None:
        self.now_ns = 0
        self.count = 0
        self.random = Random(seed)
        self._events: list[tuple[int, int, Callable[[], None]]] = []
        self._ticks: dict[Hashable, int] = {}

    def step(self, end_ns: int) -> bool:
        """Let the next thing happen; False if there is none before the end."""
        if not self._events or self._events[0][0] > end_ns:
            return False
        self.now_ns, _, act = heapq.heappop(self._events)
        act()
        return True

    def at(self, at_ns: int, act: Callable[[], None]) -> None:
        """Let this happen then."""
        self.count += 1
        heapq.heappush(self._events, (at_ns, self.count, act))

    def after(self, wait_ns: int, act: Callable[[], None]) -> None:
        """Let this happen in so long."""
        self.at(self.now_ns + wait_ns, act)

    def wake(self, whom: Hashable, due_ns: int | None, act: Callable[[], None]) -> None:
        """Serve somebody when he wants that, once, however often he says it."""
        if due_ns is None:
            return
        at_ns = self.now_ns + max(_MS, due_ns)
        planned_ns = self._ticks.get(whom, -1)
        if planned_ns <= self.now_ns or at_ns < planned_ns:
            self._ticks[whom] = at_ns
            self.at(at_ns, partial(self._tick, whom, at_ns, act))

    def uniform(self, low_ms: int, high_ms: int) -> int:
        """Some time between so many milliseconds, in ns."""
        return self.random.randrange(low_ms * _MS, high_ms * _MS)

    def _tick(self, whom: Hashable, at_ns: int, act: Callable[[], None]) -> None:
        if self._ticks.get(whom) == at_ns:
            del self._ticks[whom]
            act()
