"""The runtimes of a replay: what was asked of them waits until the log has the reply."""

from collections import deque

from onika.desk.environment.outcome.outcome import Order

_MOST = 1000
"""Orders that wait; a log that lacks replies has no more of them."""


class RecordedRuntime:
    """The way to runtimes on which nothing goes: replies come from a log."""

    def __init__(self) -> None:
        self._orders: deque[Order] = deque(maxlen=_MOST)

    def send(self, order: Order) -> None:
        """Keep an order until its reply comes."""
        self._orders.append(order)

    def awaiting(self, station: str, kind: str) -> Order | None:
        """The oldest order of this kind to a station, which waits no longer; None: there is none."""
        for order in self._orders:
            if type(order.asked).__name__ == kind and (order.station or "") == station:
                self._orders.remove(order)
                return order
        return None
