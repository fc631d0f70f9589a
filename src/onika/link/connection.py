"""A connection of the environment to a runtime, for a single-threaded program: request and wait, or poll for news."""

import secrets
from collections import deque
from collections.abc import Callable, Sequence
from typing import Protocol

from onika.link.carrier import Carrier, HeartbeatCarrier, PayloadSource, wait_for
from onika.link.channel import THREE, Channel
from onika.link.link_events import (
    LinkNotice,
    LinkStateChanged,
    ReadingReceived,
    ReplyReceived,
    RequestFailed,
    RequestFate,
)
from onika.link.link_terms import LOCAL, LinkTerms
from onika.link.lost import LinkLost, closed, here
from onika.link.session_channels import SessionChannels
from onika.link.state import LinkState
from onika.words.reason import NOTHING, Reason

Clock = Callable[[], int]
"""A clock that never goes back, in ns (`time.monotonic_ns`)."""


Wait = Callable[[Sequence[PayloadSource], float | None], None]
"""Wait until one of these can be served or the seconds are over; a test lets the other side work meanwhile."""


class Connector(PayloadSource, Protocol):
    """Opens connections for channels without letting anybody wait; readable when something has finished."""

    def dial(self, channel: Channel) -> None:
        """Begin to open a connection."""

    def finished(self) -> list[tuple[Channel, Carrier | LinkLost]]:
        """What came of those that were begun."""

    def close(self) -> None:
        """Nothing more is wanted."""


class RequestTooLong(ValueError):
    """A request is longer than this link carries: nothing was sent."""


class Connection:
    """Requests that wait for their answer (`request`), requests that do not (`ask`), and the news (`poll`)."""

    def __init__(
        self,
        carrier: Carrier | None,
        clock: Clock,
        terms: LinkTerms = LOCAL,
        client: str | None = None,
        wait: Wait = wait_for,
        connector: Connector | None = None,
    ) -> None:
        self._clock = clock
        self._wait = wait
        self._connector = connector
        channels = (Channel.ALL,) if connector is None else THREE
        self._session = SessionChannels(client or secrets.token_hex(16), terms, channels)
        self._awaited: set[int] = set()
        self._outcomes: dict[int, ReplyReceived | RequestFailed] = {}
        self._news: deque[LinkNotice] = deque()
        self._readings: dict[str, ReadingReceived] = {}
        self._lost: LinkLost | None = None
        self._refusal: LinkLost | None = None
        if carrier is not None:
            self.reconnect(carrier)

    @property
    def state(self) -> LinkState:
        """How the environment stands to the runtime."""
        return self._session.state

    @property
    def epoch(self) -> str:
        """The name of this life of the session, "" before the first greeting."""
        return self._session.epoch

    @property
    def lost(self) -> LinkLost | None:
        """Why there is no link, None while there is one or one is being made."""
        return self._lost

    @property
    def comes_back(self) -> bool:
        """Whether a cut link is made anew by itself."""
        return self._connector is not None and self._refusal is None and self.state is not LinkState.ENDED

    def readers(self) -> list[int]:
        """The descriptors to wait for in a loop of one's own before `poll(0)`."""
        return [source.fileno() for source in self._sources()]

    def writers(self) -> list[int]:
        """Those to wait for writing too."""
        return [carrier.fileno() for carrier in self._session.carriers if carrier.pending]

    def due_s(self) -> float | None:
        """How long that loop may wait at most, in s."""
        due_ns = self._session.due_ns(self._clock())
        return None if due_ns is None else due_ns / 1e9

    def reconnect(self, carrier: Carrier) -> None:
        """Go on over a new connection to the same runtime; raises LinkLost when the link was ended for good."""
        if self.state is LinkState.ENDED:
            carrier.close()
            raise self._lost or here()
        self._session.attach(Channel.ALL, carrier, self._clock())
        self._sort()

    def open(self, timeout_s: float = 5.0) -> str:
        """Wait until the greeting is complete; the session's epoch. Raises LinkLost, or TimeoutError."""
        until_ns = self._clock() + round(timeout_s * 1e9)
        self._serve()
        while self.state not in (LinkState.LINKED, LinkState.SUSPECT):
            self._raise_if_gone()
            self._step(until_ns, Reason.of("link.no_greeting", seconds=timeout_s))
        return self.epoch

    def request(self, body: bytes, timeout_s: float = 5.0, once: bool = False, urgent: bool = False) -> bytes:
        """Ask and wait for the answer; news that comes meanwhile is kept for `poll`.

        The runtime refuses the request when it arrives after the time-out. Raises TimeoutError when there was no
        answer in time, LinkLost when the link ended; in both cases it may have been carried out. Raises RequestTooLong.

        once    for what moves a robot: never said again on another connection
        urgent  passes other requests that wait to be sent
        """
        now_ns = self._clock()
        limit_ns = round(timeout_s * 1e9)
        number = self._session.request(body, now_ns, limit_ns, once, urgent)
        self._awaited.add(number)
        self._sort()
        try:
            while number not in self._outcomes:
                self._raise_if_gone()
                self._step(now_ns + limit_ns, Reason.of("link.no_answer_within", seconds=timeout_s))
            return self._outcome(self._outcomes[number], timeout_s)
        finally:
            self._awaited.discard(number)
            self._outcomes.pop(number, None)
            self._session.forget(number)

    def ask(self, body: bytes, begin_within_s: float | None = None, once: bool = False, urgent: bool = False) -> int:
        """Ask without waiting; `poll` gives the answer (ReplyReceived or RequestFailed) under the number returned."""
        within_ns = round(begin_within_s * 1e9) if begin_within_s is not None else 0
        number = self._session.request(body, self._clock(), within_ns, once, urgent)
        self._sort()
        return number

    def poll(self, timeout_s: float = 0.0) -> list[LinkNotice]:
        """The news since the last call, signals in order, then the newest readings; waits for the first one.

        Never raises LinkLost: the end of the link is news too (LinkStateChanged), and where it does not come back
        there is nothing to wait for after it.
        """
        until_ns = self._clock() + round(timeout_s * 1e9)
        self._serve()
        while not self._news and not self._readings and not self.is_gone and self._clock() < until_ns:
            self._rest(until_ns)
            self._serve()
        news = [*self._news, *self._readings.values()]
        self._news.clear()
        self._readings.clear()
        return news

    def close(self, reason: Reason = NOTHING, timeout_s: float = 1.0) -> None:
        """Say good-bye and let the connection go; waits a little for a slow reader."""
        until_ns = self._clock() + round(timeout_s * 1e9)
        self._session.close(reason, self._clock())
        while self._session.carriers and self._clock() < until_ns:
            self._rest(until_ns)
            self._session.push(self._clock())
        self._session.cut(here(reason))
        if self._connector is not None:
            self._connector.close()
            self._connector = None
        self._sort()

    @property
    def is_gone(self) -> bool:
        """Whether there is no link, and none will be made."""
        return self.state in (LinkState.APART, LinkState.ENDED) and not self.comes_back

    def _step(self, until_ns: int, late: Reason) -> None:
        if self._clock() >= until_ns:
            raise TimeoutError(late)
        self._rest(until_ns)
        self._serve()

    def _rest(self, until_ns: int) -> None:
        now_ns = self._clock()
        due_ns = self._session.due_ns(now_ns)
        rest_ns = max(0, until_ns - now_ns)
        sources = self._sources()
        if sources:
            self._wait(sources, (rest_ns if due_ns is None else min(rest_ns, due_ns)) / 1e9)

    def _vouch(self) -> None:
        """Whoever serves the connections is alive."""
        for carrier in self._session.carriers:
            if isinstance(carrier, HeartbeatCarrier):
                carrier.served()

    def _sources(self) -> list[PayloadSource]:
        return [*self._session.carriers, *([] if self._connector is None else [self._connector])]

    def _serve(self) -> None:
        self._dial()
        self._session.service(self._clock())
        self._vouch()
        self._sort()

    def _dial(self) -> None:
        if self._connector is None or self._refusal is not None:
            return
        for channel, came in self._connector.finished():
            if isinstance(came, LinkLost):
                self._session.failed(channel, self._clock())
                self._lost = came
                # nobody there before the first greeting, or what trying again does not mend
                self._refusal = came if not self.epoch or came.is_final else None
            else:
                self._session.attach(channel, came, self._clock())
        for channel in self._session.wants(self._clock()):
            self._connector.dial(channel)

    def _sort(self) -> None:
        for notice in self._session.take_notices():
            if isinstance(notice, ReplyReceived | RequestFailed) and notice.number in self._awaited:
                self._outcomes[notice.number] = notice
            elif isinstance(notice, ReadingReceived):
                self._readings[notice.key] = notice
            else:
                self._news.append(notice)
                if isinstance(notice, LinkStateChanged):
                    self._lost = notice.lost

    def _raise_if_gone(self) -> None:
        if self.is_gone:
            raise self._lost or closed()

    def _outcome(self, outcome: ReplyReceived | RequestFailed, timeout_s: float) -> bytes:
        if isinstance(outcome, ReplyReceived):
            return outcome.body
        if outcome.fate is RequestFate.TOO_LONG:
            raise RequestTooLong(outcome.fate.reason)
        if outcome.fate is RequestFate.LOST:
            raise self._lost or closed(outcome.fate.reason)
        if outcome.fate is RequestFate.UNSENT and self.state in (LinkState.APART, LinkState.ENDED):
            raise self._lost or closed()
        raise TimeoutError(Reason.of("link.not_begun", seconds=timeout_s, fate=outcome.fate.reason))
