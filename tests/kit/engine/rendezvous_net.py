"""The network between simulated runtimes whose flows meet: datagrams get lost, are late, overtaken, and cut."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from random import Random

from kit.link.event_scheduler import EventScheduler

MS = 1_000_000
STORM_NS = 12_000 * MS
"""Until then there are faults; then all that is promised has to come true."""


@dataclass(frozen=True, slots=True)
class Cut:
    """While it lasts nothing passes the place, given as a share of the way; `which` is the direction, -1: both."""

    begin_ns: int
    end_ns: int
    which: int
    place: float

    @staticmethod
    def draw(random: Random) -> "Cut":
        """Some cut."""
        begin_ns = random.randrange(STORM_NS)
        lasts_ns = random.choice((50, 300, 1_000, 4_000)) * MS
        return Cut(begin_ns, begin_ns + lasts_ns, random.choice((-1, -1, 0, 1)), random.random())


class RendezvousNet:
    """Carries what runtimes say; `one_way_ns` is the mean of both directions, which may be lopsided."""

    def __init__(self, time: EventScheduler, one_way_ns: int) -> None:
        random = time.random
        self._time = time
        self._one_way_ns = one_way_ns
        self._loss = random.choice((0.0, 0.02, 0.1, 0.3))
        self._lopsided = random.choice((0.0, 0.0, 0.1, 0.4))
        self._cuts = [Cut.draw(random) for _ in range(random.choice((0, 1, 3, 8)))]

    def send(self, sender: int, to: int, arrive: Callable[[], None]) -> None:
        """Let a datagram arrive, if it does."""
        random = self._time.random
        way = 1 + self._lopsided if sender < to else 1 - self._lopsided
        trip_ns = self._one_way_ns * (way + random.expovariate(8))
        if random.random() < 0.03:
            trip_ns *= 3
        is_calm = self._time.now_ns >= STORM_NS
        if is_calm or not (random.random() < self._loss or self._is_cut(sender < to, sender % 2, trip_ns)):
            self._time.after(int(trip_ns), arrive)

    def _is_cut(self, is_forth: bool, direction: int, trip_ns: float) -> bool:
        for cut in self._cuts:
            at_ns = self._time.now_ns + trip_ns * (cut.place if is_forth else 1 - cut.place)
            if cut.begin_ns <= at_ns < cut.end_ns and cut.which in (-1, direction):
                return True
        return False


class SimClock:
    """A clock that was started at another time, and is a little fast or slow."""

    def __init__(self, time: EventScheduler) -> None:
        self._time = time
        self._offset_ns = time.random.randrange(10**12, 2 * 10**12)
        self._ppm = time.random.randrange(-20, 21)

    @property
    def now_ns(self) -> int:
        """What it shows."""
        return self._offset_ns + self._time.now_ns + self._time.now_ns * self._ppm // 1_000_000

    def at(self, here_ns: int, act: Callable[[], None]) -> None:
        """Let this happen when it shows that, and no sooner."""
        wait_ns = here_ns - self.now_ns
        if wait_ns > 0:
            self._time.after(wait_ns, partial(self.at, here_ns, act))
        else:
            act()
