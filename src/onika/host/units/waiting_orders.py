"""What a device server is asked while something is worked out beside its loop: it waits, the worlds go on (law 16)."""

import sys
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from threading import Thread
from typing import Generic, TypeVar

_SWITCH_S = 0.0005
"""How soon the loop gets its turn beside the work: it steps worlds every few milliseconds."""

Order = TypeVar("Order")


class WaitingOrders(Generic[Order]):
    """Orders that want an answer, in their order, behind one for which something is worked out in a thread."""

    def __init__(self) -> None:
        self._orders: deque[Order] = deque()
        self._work: Thread | None = None

    def __bool__(self) -> bool:
        """Whether any wait: whoever asks now comes behind them."""
        return bool(self._orders)

    def put(self, order: Order) -> None:
        """One more."""
        self._orders.append(order)

    def begin(self, work: Callable[[], object]) -> None:
        """Something is worked out that the first of them needs; what it raises is raised again by that order itself."""
        sys.setswitchinterval(_SWITCH_S)
        self._work = Thread(target=_tried, args=(work,), daemon=True)
        self._work.start()

    def take(self) -> Order | None:
        """The first, as soon as nothing is worked out any more; None: there is nothing to do yet."""
        if not self._orders or (self._work is not None and self._work.is_alive()):
            return None
        self._work = None
        return self._orders.popleft()


def _tried(work: Callable[[], object]) -> None:
    with suppress(ValueError):
        work()
