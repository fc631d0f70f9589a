"""The multiplexer of one runtime: orders go out as they come, and what comes back is sorted; nothing here waits."""

from collections.abc import Callable, Iterator
from typing import Protocol

from onika.desk.environment.outcome.outcome import Order
from onika.desk.run.runtime_conversation import NumberedResponse
from onika.wire import event, holding, live, request
from onika.words.reason import Reason

_EVERY_S = 0.5
"""How often figures are asked for while somebody wants them."""
_TRIP_EVERY_S = 2.0
"""How often the way to a runtime elsewhere is measured."""


class RuntimeClient(Protocol):
    """A runtime, launched or reached."""

    def send(self, message: request.Request) -> int:
        """Ask without waiting; the number of the reply."""
        ...

    def messages(self, timeout_s: float = 0.0) -> Iterator[event.Event | NumberedResponse]:
        """Events and replies as they came; raises LinkLost at the end."""
        ...

    def readings(self) -> dict[str, bytes]:
        """The newest reading under each key since the last call."""
        ...


Answered = tuple[Order, request.Response]


class Multiplexer:
    """Who waits for which reply, what is attended to, and when figures are due.

    clock   seconds that never go back
    """

    def __init__(self, runtime: RuntimeClient, clock: Callable[[], float]) -> None:
        self._runtime = runtime
        self._clock = clock
        self._waiting: dict[int, Order] = {}
        self._attended: live.Attend | None = None
        self._figures_asked: int | None = None
        self._figures_due_s = 0.0
        self.figures: live.Figures | None = None
        """Those that came with the last `hear`; None: none."""
        self._trip: tuple[int, float] | None = None
        self._trip_due_s = 0.0
        self.round_trip_s: float | None = None
        """How long the last question took that is answered at once; None: none was answered yet."""

    @property
    def is_owed(self) -> bool:
        """Whether anything that was asked is not answered yet."""
        return bool(self._waiting) or self._figures_asked is not None

    def ask(self, order: Order) -> None:
        """Send an order out."""
        self._waiting[self._runtime.send(order.asked)] = order

    def attend(self, wish: live.Attend) -> None:
        """What is listened to from now on."""
        if wish != self._attended:
            self._attended = wish
            self._runtime.send(wish)

    def hear(self) -> list[event.Event | Answered]:
        """What has come since the last call, in order; raises LinkLost at the end, `orphans` are left then."""
        self.figures = None
        messages: list[event.Event | Answered] = []
        for message in self._runtime.messages():
            if not isinstance(message, NumberedResponse):
                messages.append(message)
            elif self._trip is not None and message.number == self._trip[0]:
                self.round_trip_s, self._trip = self._clock() - self._trip[1], None
            elif message.number == self._figures_asked:
                self._figures_asked = None
                self.figures = message.response if isinstance(message.response, live.Figures) else None
            elif message.number in self._waiting:
                messages.append((self._waiting.pop(message.number), message.response))
        return messages

    def readings(self) -> dict[str, bytes]:
        """The newest reading under each key since the last call."""
        return self._runtime.readings()

    def orphans(self, reason: Reason) -> list[Answered]:
        """The orders that get no reply any more, with the refusal in its place."""
        taken, self._waiting = self._waiting, {}
        return [(order, request.Refused(reason)) for order in taken.values()]

    def poll_figures(self, is_wanted: bool) -> float | None:
        """Ask for figures if it is time and the last ones have come; how long until it is again."""
        if not is_wanted or self._figures_asked is not None:
            return None
        left = self._figures_due_s - self._clock()
        if left > 0:
            return left
        self._figures_due_s = self._clock() + _EVERY_S
        self._figures_asked = self._runtime.send(live.Status())
        return None

    def poll_round_trip(self) -> float | None:
        """Measure the way if it is time and the last question was answered; how long until it is again."""
        if self._trip is not None:
            return None
        now = self._clock()
        if now < self._trip_due_s:
            return self._trip_due_s - now
        self._trip_due_s = now + _TRIP_EVERY_S
        self._trip = (self._runtime.send(holding.Sessions()), now)
        return None
