"""A connection of the environment to a runtime, for a program of one thread: ask and wait, or poll for news."""

import secrets
from collections import deque
from collections.abc import Callable

from onika.link.carrier import Carrier, wait_for
from onika.link.client import ClientEnd
from onika.link.happening import Failed, Fate, Happening, Read, Replied, Turned
from onika.link.lost import LinkLost, closed, here
from onika.link.pump import Pump
from onika.link.state import LinkState
from onika.link.terms import LOCAL, Terms

Clock = Callable[[], int]
"""A clock that never goes back, in ns (`time.monotonic_ns`)."""

Wait = Callable[[Carrier, float | None], None]
"""Wait until the carrier can be served or the seconds are over; a test lets the other side work meanwhile."""

_GONE = (LinkState.APART, LinkState.ENDED)


class Connection:
    """Requests that wait for their answer (`request`), requests that do not (`ask`), and the news (`poll`)."""

    def __init__(
        self,
        carrier: Carrier,
        clock: Clock,
        terms: Terms = LOCAL,
        client: str | None = None,
        wait: Wait = wait_for,
    ) -> None:
        self._clock = clock
        self._wait = wait
        self._end = ClientEnd(client or secrets.token_hex(16), terms)
        self._pump = Pump(self._end)
        self._awaited: set[int] = set()
        self._outcomes: dict[int, Replied | Failed] = {}
        self._news: deque[Happening] = deque()
        self._readings: dict[str, Read] = {}
        self._lost: LinkLost | None = None
        self.reconnect(carrier)

    @property
    def state(self) -> LinkState:
        """How the environment stands to the runtime."""
        return self._end.state

    @property
    def epoch(self) -> str:
        """The name of this life of the runtime, "" before the first greeting."""
        return self._end.epoch

    @property
    def lost(self) -> LinkLost | None:
        """Why there is no link, None while there is one or one is being made."""
        return self._lost

    def fileno(self) -> int:
        """The descriptor to wait for in a loop of one's own before `poll(0)`; -1 when there is none."""
        return self._pump.carrier.fileno() if self._pump.carrier is not None else -1

    def want_write(self) -> bool:
        """Whether to wait for writing too."""
        return self._pump.carrier is not None and self._pump.carrier.pending > 0

    def due_s(self) -> float | None:
        """How long that loop may wait at most, in s."""
        due_ns = self._end.due_ns(self._clock())
        return None if due_ns is None else due_ns / 1e9

    def reconnect(self, carrier: Carrier) -> None:
        """Go on over a new connection to the same runtime; raises LinkLost when the link was ended for good."""
        if self._end.state is LinkState.ENDED:
            carrier.close()
            raise self._lost or here()
        self._pump.attach(carrier, self._clock())
        self._sort()

    def open(self, timeout_s: float = 5.0) -> str:
        """Wait until the greeting is complete; the runtime's epoch. Raises LinkLost, or TimeoutError."""
        until_ns = self._clock() + round(timeout_s * 1e9)
        while self.state not in (LinkState.LINKED, LinkState.SUSPECT):
            self._raise_if_gone()
            self._step(until_ns, f"no greeting within {timeout_s:g} s")
        return self.epoch

    def request(self, body: bytes, timeout_s: float = 5.0, once: bool = False, urgent: bool = False) -> bytes:
        """Ask and wait for the answer; news that comes meanwhile is kept for `poll`.

        The runtime refuses the request when it arrives after the time-out. Raises TimeoutError when there was no
        answer in time, LinkLost when the link ended; in both cases it may have been carried out.

        once    for what moves a robot: never said again on another connection
        urgent  passes other requests that wait to be sent
        """
        now_ns = self._clock()
        limit_ns = round(timeout_s * 1e9)
        number = self._end.request(body, now_ns, limit_ns, once, urgent)
        self._awaited.add(number)
        self._pump.push(now_ns)
        self._sort()
        try:
            while number not in self._outcomes:
                self._raise_if_gone()
                self._step(now_ns + limit_ns, f"no answer within {timeout_s:g} s")
            return self._outcome(self._outcomes[number], timeout_s)
        finally:
            self._awaited.discard(number)
            self._outcomes.pop(number, None)
            self._end.forget(number)

    def ask(self, body: bytes, begin_within_s: float | None = None, once: bool = False, urgent: bool = False) -> int:
        """Ask without waiting; `poll` tells of the answer (Replied or Failed) under the number given back."""
        now_ns = self._clock()
        within_ns = round(begin_within_s * 1e9) if begin_within_s is not None else 0
        number = self._end.request(body, now_ns, within_ns, once, urgent)
        self._pump.push(now_ns)
        self._sort()
        return number

    def poll(self, timeout_s: float = 0.0) -> list[Happening]:
        """The news since the last call, signals in order, then the newest readings; waits for the first one.

        Never raises LinkLost: the end of the link is news too (Turned), and after it there is nothing to wait for.
        """
        until_ns = self._clock() + round(timeout_s * 1e9)
        self._serve()
        while not self._news and not self._readings and self.state not in _GONE and self._clock() < until_ns:
            self._rest(until_ns)
            self._serve()
        news = [*self._news, *self._readings.values()]
        self._news.clear()
        self._readings.clear()
        return news

    def close(self, reason: str = "closed", timeout_s: float = 1.0) -> None:
        """Say good-bye and let the connection go; waits a little for a slow reader."""
        self._end.close(reason)
        until_ns = self._clock() + round(timeout_s * 1e9)
        self._pump.push(self._clock())
        while self._pump.carrier is not None and self._clock() < until_ns:
            self._rest(until_ns)
            self._pump.push(self._clock())
        self._pump.drop()
        self._sort()

    def _step(self, until_ns: int, text: str) -> None:
        if self._clock() >= until_ns:
            raise TimeoutError(text)
        self._rest(until_ns)
        self._serve()

    def _rest(self, until_ns: int) -> None:
        now_ns = self._clock()
        due_ns = self._end.due_ns(now_ns)
        rest_ns = max(0, until_ns - now_ns)
        if self._pump.carrier is not None:
            self._wait(self._pump.carrier, (rest_ns if due_ns is None else min(rest_ns, due_ns)) / 1e9)

    def _serve(self) -> None:
        self._pump.service(self._clock())
        self._sort()

    def _sort(self) -> None:
        for happening in self._end.take_happenings():
            if isinstance(happening, Replied | Failed) and happening.number in self._awaited:
                self._outcomes[happening.number] = happening
            elif isinstance(happening, Read):
                self._readings[happening.key] = happening
            else:
                self._news.append(happening)
                if isinstance(happening, Turned):
                    self._lost = happening.lost

    def _raise_if_gone(self) -> None:
        if self.state in _GONE:
            raise self._lost or closed()

    def _outcome(self, outcome: Replied | Failed, timeout_s: float) -> bytes:
        if isinstance(outcome, Replied):
            return outcome.body
        if outcome.fate is Fate.LOST:
            raise self._lost or closed("the runtime was started anew")
        if outcome.fate is Fate.UNSENT and self.state in _GONE:
            raise self._lost or closed()
        raise TimeoutError(f"not begun within {timeout_s:g} s: {outcome.fate.value}")
