"""What is carried over a hop, and how a round of hops is judged: there and back again, halved."""

from collections.abc import Callable
from time import perf_counter_ns

from beside.contestant import Figures

SIZE = 6
BYTES = 8 * SIZE
WARM_UP = 200


def hops(there_and_back: Callable[[list[float]], list[float]], count: int) -> Figures:
    """Median and 99 % of half a round trip; raises RuntimeError where something else comes back."""
    values = [0.5 * number for number in range(SIZE)]
    times = []
    for number in range(WARM_UP + count):
        values[0] = float(number)
        began = perf_counter_ns()
        back = there_and_back(values)
        times.append(perf_counter_ns() - began)
        if back != values:
            raise RuntimeError(f"expected {values}, found {back}")
    return figures([time / 2e3 for time in times[WARM_UP:]])


def figures(microseconds: list[float]) -> Figures:
    """Median and 99 % of hops."""
    found = sorted(microseconds)
    return {"figure": found[len(found) // 2], "p99": found[int(len(found) * 0.99)]}
