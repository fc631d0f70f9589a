"""The weather of a simulated network: what it does to packets, drawn from a seed."""

from dataclasses import dataclass
from random import Random

_MS = 1_000_000


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
