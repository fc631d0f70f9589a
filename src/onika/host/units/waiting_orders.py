"""What a device server is asked while something is worked out beside its loop: it waits, the worlds go on (law 16)."""

import sys
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from threading import Thread
from typing import Generic, Protocol, TypeVar

from onika.host.processes.forked_work import ForkedWork

_SWITCH_S = 0.0005
"""How soon the loop gets its turn beside what is taken over: it steps worlds every few milliseconds."""

Order = TypeVar("Order")


class Preparation(Protocol):
    """What takes long before an order can be carried out, and changes nothing."""

    def work_out(self) -> bytes:
        """In a copy of this process, of which nothing but these bytes is left."""
        ...

    def take(self, worked_out: bytes) -> None:
        """Beside the loop: have it at hand."""
        ...


class WaitingOrders(Generic[Order]):
    """Orders that want an answer, in their order, behind one for which something is worked out elsewhere."""

    def __init__(self) -> None:
        self._orders: deque[Order] = deque()
        self._work: Thread | None = None

    def __bool__(self) -> bool:
        """Whether any wait: whoever asks now comes behind them."""
        return bool(self._orders)

    def put(self, order: Order) -> None:
        """One more."""
        self._orders.append(order)

    def begin(self, preparation: Preparation) -> None:
        """Something is worked out that the first of them needs; where it comes to nothing, that order says why."""
        with suppress(OSError):  # without room for a copy the order does it itself
            work = ForkedWork(preparation.work_out)
            sys.setswitchinterval(_SWITCH_S)
            self._work = Thread(target=_take_over, args=(work, preparation.take), daemon=True)
            self._work.start()

    def take(self) -> Order | None:
        """The first, as soon as nothing is worked out any more; None: there is nothing to do yet."""
        if not self._orders or (self._work is not None and self._work.is_alive()):
            return None
        self._work = None
        return self._orders.popleft()


def _take_over(work: ForkedWork, take: Callable[[bytes], None]) -> None:
    worked_out = work.wait()
    if worked_out is not None:
        take(worked_out)
