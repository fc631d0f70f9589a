"""The faults of a simulated network: what happens to packets, drawn from a seed."""

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from kit.link.event_scheduler import EventScheduler
from kit.link.sim_link import SimCarrier

_MS = 1_000_000


@dataclass(frozen=True, slots=True)
class NetFaults:
    """What this history's network does to packets; a reliable one only delays and cuts."""

    is_reliable: bool
    loss: float
    duplicate: float
    reorder: float
    delay_ns: int

    @staticmethod
    def draw(random: Random) -> "NetFaults":
        """Some faults."""
        is_reliable = random.random() < 0.5
        delay_ns = random.choice((1, 20, 80)) * _MS
        return NetFaults(is_reliable, random.uniform(0, 0.3), random.uniform(0, 0.2), random.uniform(0, 0.3), delay_ns)


class FaultyNet:
    """Lets things arrive as the faults allow, until it is calm."""

    def __init__(self, weather: NetFaults, time: EventScheduler) -> None:
        self.is_calm = False
        self._weather = weather
        self._time = time

    def carry(self, plug: SimCarrier, blind_ns: int, act: Callable[[], None]) -> None:
        """Let it happen at the other end: in order where the network is reliable; else perhaps, and perhaps twice.

        blind_ns    until then nothing arrives
        """
        if self._weather.is_reliable:
            self._in_order(plug, blind_ns, act)
            return
        if blind_ns > self._time.now_ns or self._strikes(self._weather.loss):
            return
        for _ in range(2 if self._strikes(self._weather.duplicate) else 1):
            overtaken_ns = self._delay() if self._strikes(self._weather.reorder) else 0
            self._time.after(self._weather.delay_ns + overtaken_ns, act)

    def tell_end(self, plug: SimCarrier, blind_ns: int, act: Callable[[], None]) -> None:
        """Behind everything that was said where the network is reliable; else perhaps."""
        if self._weather.is_reliable:
            self._in_order(plug, blind_ns, act)
        elif blind_ns <= self._time.now_ns and self._time.random.random() < 0.5:
            self._time.after(self._delay(), act)

    def _in_order(self, plug: SimCarrier, blind_ns: int, act: Callable[[], None]) -> None:
        plug.free_ns = max(plug.free_ns, blind_ns, self._time.now_ns + self._delay())
        self._time.at(plug.free_ns, act)

    def _strikes(self, chance: float) -> bool:
        return not self.is_calm and self._time.random.random() < chance

    def _delay(self) -> int:
        return self._time.random.randrange(self._weather.delay_ns // 2, self._weather.delay_ns * 2)
