"""A task of 500 Hz alone on a processing unit of Onika's runtime, in wall time.

The module itself looks at the clock, first thing in its cycle: after the wake-up, the agenda and the copy in.
"""

from time import monotonic_ns

import onika
from beside.contestant import Figures, serve
from beside.punctuality.lateness import RATE_HZ, figures, is_fifo_granted
from beside.unit import HOME, Household, Unit
from onika.host.units.supervisor import Supervisor
from onika.runtime import command, news

_TASK = "late"

MODULE = """
from time import monotonic_ns
from onika.module import InVar, Module, OutVar

class Late(Module):
    IN = InVar("double[6]", "-", "what nobody writes")
    OUT = OutVar("double[6]", "-", "what nobody reads")

    def on(self, inputs):
        self._late = []
        self._period = round(self.dt * 1e9)

    def cycle(self):
        self._late.append(monotonic_ns() % self._period)

    def get(self, name):
        return self._late[1:]
"""
"""The runtime's time begins at zero of the monotonic clock here, so that its grid is that of whole periods."""


class LateTask:
    """The unit and its task; it is switched on for every round and off again."""

    def __init__(self, with_fifo: bool) -> None:
        self._supervisor = Supervisor(0, with_fifo)
        house = Household()
        self._unit = Unit(self._supervisor, "rt0", house)
        self._house = house
        self._unit.spawn(house.spawn(_TASK, MODULE, float(RATE_HZ)))
        if with_fifo and not self._unit.granted["SCHED_FIFO"]:
            raise RuntimeError("SCHED_FIFO is not granted")

    def measure(self, milliseconds: int) -> Figures:
        """Lateness within so many milliseconds."""
        self._unit.report()
        self._unit.send(self._house.switch(on=[_TASK]))
        self._unit.pass_time(monotonic_ns() + milliseconds * 1_000_000)
        missed = self._unit.report().tasks[0].miss
        self._unit.send(self._house.switch(off=[_TASK]))
        self._unit.send(command.Get(HOME, _TASK, "late"))
        return figures(self._unit.hear(news.Got).value, missed)

    def end(self) -> None:
        """End the unit."""
        self._supervisor.end()


def main() -> None:
    """The contestant."""
    late = LateTask(is_fifo_granted())
    try:
        serve(onika.__version__, late.measure)
    finally:
        late.end()


if __name__ == "__main__":
    main()
