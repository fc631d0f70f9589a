"""A simulated network: one environment, one runtime, seeded weather between them, virtual time, the same every time.

A history is a storm (loss, duplication, reordering, cuts, one-way cuts, crashes of either program, all from one seed)
and then a calm in which everything that was promised has to come true. A `Witness` watches.
"""

import hashlib
import heapq
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from random import Random

from onika.link.client import ClientEnd
from onika.link.happening import Asked
from onika.link.journal import Journal
from onika.link.lost import closed
from onika.link.replies import ReplyBook
from onika.link.server import ServerEnd
from onika.link.state import LinkState
from onika.link.terms import Terms
from onika.testing.witness import Connection, Wanted, Who, Witness
from onika.wire.packet import Hello, Packet, Welcome, decode, encode

_MS = 1_000_000
_STORM_NS = 8_000 * _MS
_CALM_NS = 5_000 * _MS
_SLACK_NS = 60 * _MS

MakeClient = Callable[[str, Terms], ClientEnd]
MakeServer = Callable[[Journal, ReplyBook, Terms], ServerEnd]
MakeEpoch = Callable[[int], str]


def name_epoch(life: int) -> str:
    """A name of its own for each life of the runtime."""
    return f"epoch-{life}"


@dataclass(frozen=True, slots=True)
class Weather:
    """What this history's network does to packets; a reliable one only delays and cuts."""

    is_reliable: bool
    loss: float
    duplicate: float
    reorder: float
    delay_ns: int

    @staticmethod
    def draw(random: Random) -> "Weather":
        """Some weather."""
        is_reliable = random.random() < 0.5
        delay_ns = random.choice((1, 20, 80)) * _MS
        return Weather(is_reliable, random.uniform(0, 0.3), random.uniform(0, 0.2), random.uniform(0, 0.3), delay_ns)


@dataclass(frozen=True, slots=True)
class Report:
    """What a history came to; equal for equal seeds and programs."""

    seed: int
    faults: tuple[str, ...]
    signals: int
    requests: int
    events: int
    digest: str


class _Side:
    """One program: its end of the link, its clock and the connection it has now."""

    def __init__(self, who: Who, end: ClientEnd | ServerEnd, clock_ns: int) -> None:
        self.who = who
        self.end = end
        self.clock_ns = clock_ns
        self.connection: Connection | None = None
        self.heard_ns = 0
        self.tick_ns = -1
        self.free_ns = 0
        self.blind_ns = 0


class History:
    """One history of a link, from a seed; the programs may be given with planted mistakes."""

    def __init__(
        self,
        seed: int,
        client: MakeClient = ClientEnd,
        server: MakeServer = ServerEnd,
        epoch: MakeEpoch = name_epoch,
    ) -> None:
        self._seed = seed
        self._random = Random(seed)  # noqa: S311  a simulation wants the same numbers every time
        self._weather = Weather.draw(self._random)
        self._terms = Terms(
            beat_ns=200 * _MS,
            suspect_ns=500 * _MS,
            lost_ns=1_500 * _MS,
            greeting_ns=1_500 * _MS,
            retry_ns=0 if self._weather.is_reliable else 250 * _MS,
            window=8,
            piece=64,
            body_limit=10_000,
        )
        self._make_client, self._make_server, self._make_epoch = client, server, epoch
        self._now_ns = 0
        self._events: list[tuple[int, int, Callable[[], None]]] = []
        self._count = 0
        self._digest = hashlib.blake2b(digest_size=16)
        self._witness = Witness()
        self._lives = {Who.ENVIRONMENT: 0, Who.RUNTIME: 0}
        self._labels = 0
        self._is_calm = False
        self._runtime_is_up = True
        self._environment = self._start_environment()
        self._runtime = self._start_runtime()

    def run(self) -> Report:
        """Live through it; stops at the first fault."""
        self._plan()
        end_ns = _STORM_NS + _CALM_NS
        while self._events and not self._witness.faults and self._events[0][0] <= end_ns:
            self._now_ns, _, act = heapq.heappop(self._events)
            act()
        if not self._witness.faults:
            states = {self._environment.end.state, self._runtime.end.state}
            self._witness.final(self._epoch, states)
        return Report(
            self._seed,
            tuple(self._witness.faults),
            self._witness.accepted,
            self._witness.begun,
            self._count,
            self._digest.hexdigest(),
        )

    # -- the two programs

    @property
    def _epoch(self) -> str:
        return self._make_epoch(self._lives[Who.RUNTIME])

    def _start_environment(self) -> _Side:
        self._lives[Who.ENVIRONMENT] += 1
        name = f"client-{self._lives[Who.ENVIRONMENT]}"
        self._witness.environment_starts(name)
        clock_ns = self._random.randrange(10**15)
        return _Side(Who.ENVIRONMENT, self._make_client(name, self._terms), clock_ns)

    def _start_runtime(self) -> _Side:
        self._lives[Who.RUNTIME] += 1
        self._runtime_is_up = True
        self._witness.runtime_starts(self._epoch)
        end = self._make_server(Journal(self._epoch), ReplyBook(), self._terms)
        return _Side(Who.RUNTIME, end, self._random.randrange(10**15))

    def _signal(self) -> None:
        if not self._runtime_is_up:
            return
        body = f"{self._epoch} {self._random.random()}".encode()
        self._witness.signal(self._epoch, body)
        end = self._runtime.end
        if isinstance(end, ServerEnd):
            end.signal(body, self._now_ns + self._runtime.clock_ns)
            end.reading(f"key-{self._random.randrange(3)}", b"%d" % (self._now_ns + 1), self._clock(self._runtime))
        self._serve(self._runtime)

    def _ask(self) -> None:
        self._labels += 1
        body = f"{self._labels} ".encode() + b"x" * self._random.choice((0, 10, 200))
        within_ns = self._random.choice((0, 100, 1_000)) * _MS
        once = self._random.random() < 0.3
        side = self._environment
        begin_by_ns = self._now_ns + within_ns if within_ns else 0
        wanted = Wanted(str(self._labels), body, once, begin_by_ns, side.connection)
        if isinstance(side.end, ClientEnd):
            urgent = self._random.random() < 0.1
            number = side.end.request(body, self._clock(side), within_ns, once, urgent)
            self._witness.wants(wanted, number)
        self._serve(side)

    def _answer(self, side: _Side, asked: Asked) -> None:
        if side is self._runtime and isinstance(side.end, ServerEnd):
            side.end.reply(asked.ticket, b"re: " + asked.body)
            self._serve(side)

    def _crash_environment(self) -> None:
        self._leave(self._environment)
        self._environment = self._start_environment()
        self._after(self._uniform(100, 500), self._dial)

    def _crash_runtime(self) -> None:
        if not self._runtime_is_up:
            return
        self._runtime_is_up = False
        self._leave(self._runtime)
        self._after(self._uniform(50, 1_500), self._boot)

    def _boot(self) -> None:
        self._runtime = self._start_runtime()

    # -- serving one side: what it says, what it tells, when it wants to be ticked

    def _clock(self, side: _Side) -> int:
        return self._now_ns + side.clock_ns

    def _serve(self, side: _Side) -> None:
        while packets := side.end.take_packets(self._clock(side), 1 << 16):
            for packet in packets:
                self._send(side, packet)
        for happening in side.end.take_happenings():
            self._witness.happened(side.who, happening, side.connection, self._now_ns)
            if isinstance(happening, Asked):
                self._after(self._uniform(0, 800), partial(self._answer, side, happening))
        if side.end.state is LinkState.APART and side.connection is not None:
            self._leave(side)
        self._schedule_tick(side)

    def _schedule_tick(self, side: _Side) -> None:
        due_ns = side.end.due_ns(self._clock(side))
        if due_ns is None:
            return
        at_ns = self._now_ns + max(_MS, due_ns)
        if side.tick_ns <= self._now_ns or at_ns < side.tick_ns:
            side.tick_ns = at_ns
            self._at(at_ns, partial(self._tick, side, at_ns))

    def _tick(self, side: _Side, at_ns: int) -> None:
        if side.tick_ns != at_ns or side not in (self._environment, self._runtime):
            return
        side.tick_ns = -1
        side.end.tick(self._clock(side))
        self._serve(side)

    def _inspect(self) -> None:
        for side in (self._environment, self._runtime):
            silence_ns = self._now_ns - side.heard_ns - _SLACK_NS
            self._witness.heard_last(side.who, side.end.state, silence_ns, self._terms.suspect_ns, self._terms.lost_ns)

    # -- the network between them

    def _other(self, side: _Side) -> _Side:
        return self._runtime if side is self._environment else self._environment

    def _send(self, side: _Side, packet: Packet) -> None:
        connection = side.connection
        if connection is None:
            return
        self._witness.sent(side.who, connection, packet)
        arrive = partial(self._arrive, connection, self._other(side), encode(packet))
        if self._weather.is_reliable:
            self._in_order(side, arrive)
            return
        if side.blind_ns > self._now_ns or self._strikes(self._weather.loss):
            return
        for _ in range(2 if self._strikes(self._weather.duplicate) else 1):
            overtaken_ns = self._delay() if self._strikes(self._weather.reorder) else 0
            self._after(self._weather.delay_ns + overtaken_ns, arrive)

    def _strikes(self, chance: float) -> bool:
        return not self._is_calm and self._random.random() < chance

    def _in_order(self, side: _Side, act: Callable[[], None]) -> None:
        side.free_ns = max(side.free_ns, side.blind_ns, self._now_ns + self._delay())
        self._at(side.free_ns, act)

    def _arrive(self, connection: Connection, side: _Side, payload: bytes) -> None:
        if side.connection is not connection or connection.is_broken:
            return
        self._digest.update(b"%d %s " % (self._now_ns, side.who.value.encode()) + payload)
        packet = decode(payload)
        connection.heard_hello |= isinstance(packet, Hello)
        connection.heard_welcome |= isinstance(packet, Welcome)
        side.heard_ns = self._now_ns
        side.end.feed(packet, self._clock(side))
        self._serve(side)

    def _leave(self, side: _Side) -> None:
        """This side lets its connection go; the other one learns it, or not."""
        connection, side.connection = side.connection, None
        if connection is not None:
            other, hear = self._other(side), partial(self._hear_of_end, connection, self._other(side))
            if self._weather.is_reliable:
                self._in_order(side, hear)
            elif side.blind_ns <= self._now_ns and other.connection is connection and self._random.random() < 0.5:
                self._after(self._delay(), hear)
        if side is self._environment:
            self._after(self._uniform(50, 400), self._dial)

    def _hear_of_end(self, connection: Connection, side: _Side) -> None:
        if side.connection is connection:
            side.end.cut(closed())
            self._serve(side)

    def _dial(self) -> None:
        side = self._environment
        if side.connection is not None:
            return
        blind_ns = max(side.blind_ns, self._runtime.blind_ns)
        if blind_ns > self._now_ns or not self._runtime_is_up:
            self._after(self._uniform(50, 400), self._dial)
            return
        connection = Connection()
        for party in (self._runtime, side):
            party.connection = connection
            party.heard_ns = self._now_ns
            party.free_ns = 0
            party.end.open(self._clock(party))
            self._serve(party)

    def _cut(self) -> None:
        for side in (self._environment, self._runtime):
            if side.connection is not None:
                # nothing more arrives; each side learns of it in its own time
                side.connection.is_broken = True
                self._after(self._uniform(0, 600), partial(self._hear_of_end, side.connection, side))

    def _blind(self) -> None:
        side = self._random.choice((self._environment, self._runtime))
        side.blind_ns = self._now_ns + self._uniform(100, 3_000)

    def _blind_both(self) -> None:
        for side in (self._environment, self._runtime):
            side.blind_ns = self._now_ns + self._uniform(100, 3_000)

    def _heal(self) -> None:
        self._is_calm = True
        for side in (self._environment, self._runtime):
            side.blind_ns = min(side.blind_ns, self._now_ns)

    # -- the plan of the storm

    def _plan(self) -> None:
        random = self._random
        self._at(0, self._dial)
        for _ in range(random.randrange(40, 80)):
            self._at(random.randrange(_STORM_NS), self._signal)
        for _ in range(random.randrange(20, 50)):
            self._at(random.randrange(_STORM_NS), self._ask)
        troubles = (self._cut, self._blind, self._blind_both, self._crash_environment, self._crash_runtime)
        for trouble in random.choices(troubles, weights=(5, 4, 2, 1, 1), k=random.randrange(7)):
            self._at(random.randrange(_STORM_NS), trouble)
        self._at(_STORM_NS, self._heal)
        for at_ns in range(0, _STORM_NS + _CALM_NS, 250 * _MS):
            self._at(at_ns, self._inspect)

    def _at(self, at_ns: int, act: Callable[[], None]) -> None:
        self._count += 1
        heapq.heappush(self._events, (at_ns, self._count, act))

    def _after(self, wait_ns: int, act: Callable[[], None]) -> None:
        self._at(self._now_ns + wait_ns, act)

    def _uniform(self, low_ms: int, high_ms: int) -> int:
        return self._random.randrange(low_ms * _MS, high_ms * _MS)

    def _delay(self) -> int:
        return self._random.randrange(self._weather.delay_ns // 2, self._weather.delay_ns * 2)
