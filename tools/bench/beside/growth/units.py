"""So many processing units in wall time, each with 16 tasks of 1000 Hz: cycles per second in all, and missed ones."""

from time import monotonic_ns

import onika
from beside.contestant import Figures, serve
from beside.punctuality.lateness import is_fifo_granted
from beside.sequence.onika_sweep import MODULE
from beside.unit import Household, Unit
from onika.host.units.supervisor import Supervisor

TASKS = 16
RATE_HZ = 1000.0
SPAN_NS = 1_000_000_000


class Units:
    """Processing units, started as they are needed; their tasks share one table."""

    def __init__(self) -> None:
        self._supervisor = Supervisor(monotonic_ns(), is_fifo_granted())
        self._house = Household()
        self._units: list[tuple[Unit, list[str]]] = []

    def measure(self, count: int, span_ns: int = SPAN_NS) -> Figures:
        """Let so many units cycle for a while, one second unless said otherwise."""
        while len(self._units) < count:
            self._start()
        taken = self._units[:count]
        for unit, names in taken:
            unit.report()
            unit.send(self._house.switch(on=names))
        until = monotonic_ns() + span_ns
        for unit, _ in taken:
            unit.pass_time(until)
        figures = [one for unit, _ in taken for one in unit.report().tasks]
        for unit, names in taken:
            unit.send(self._house.switch(off=names))
        cycles, missed = sum(one.cycle for one in figures), sum(one.miss for one in figures)
        return {"figure": cycles * 1e9 / span_ns, "missed": missed / max(1, cycles + missed)}

    def end(self) -> None:
        """End them all."""
        self._supervisor.end()

    def _start(self) -> None:
        number = len(self._units)
        unit = Unit(self._supervisor, f"rt{number}", self._house)
        names = [f"idle{number}_{task:02}" for task in range(TASKS)]
        for rank, name in enumerate(names):
            aliases = {"IN": f"U{number}V{rank}", "OUT": f"U{number}V{rank + 1}"}
            unit.spawn(self._house.spawn(name, MODULE, RATE_HZ, rank, aliases))
        self._units.append((unit, names))


def main() -> None:
    """The contestant; a size is a number of units."""
    units = Units()
    try:
        serve(onika.__version__, units.measure)
    finally:
        units.end()


if __name__ == "__main__":
    main()
