"""24 tasks with nothing to do, each carried out once: their cycles in Onika's executive in virtual time.

Every task has a vector of six copied in and one copied out; there is no logic of actions in it.
"""

from collections.abc import Callable
from time import perf_counter_ns

import onika
from beside.contestant import serve
from beside.unit import Household
from onika.host.guards.call_watchdog import CallWatchdog
from onika.runtime.execution.executive import Executive

ACTIONS = 24

MODULE = """
from onika.module import InVar, Module, OutVar

class Idle(Module):
    IN = InVar("double[6]", "-", "what its neighbour wrote")
    OUT = OutVar("double[6]", "-", "what its neighbour reads")

    def cycle(self):
        pass
"""


class Sweep:
    """So many idle tasks in a chain, ON at 1000 Hz."""

    def __init__(self, tasks: int, watch: Callable[[str], None] | None = None) -> None:
        self.house = Household()
        self.executive = Executive("", self.house.views, watch)
        names = [f"idle{number:03}" for number in range(tasks)]
        for rank, name in enumerate(names):
            aliases = {"IN": f"V{rank}", "OUT": f"V{rank + 1}"}
            self.executive.handle(self.house.spawn(name, MODULE, 1000.0, rank, aliases), 0)
        self.executive.handle(self.house.switch(on=names), 0)

    def run(self, sweeps: int) -> float:
        """Carry out every task so many times; microseconds per sweep."""
        began = perf_counter_ns()
        for _ in range(sweeps):
            now = self.executive.next_release()
            assert now is not None
            while self.executive.run_due(now, 1000) is not None:
                pass
        return (perf_counter_ns() - began) / 1e3 / sweeps

    def cycles(self) -> int:
        """Cycles of all tasks since they came on."""
        return sum(task.counters.cycles for task in self.executive.tasks.values())


def main() -> None:
    """The contestant."""
    sweep = Sweep(ACTIONS, CallWatchdog().watch)
    serve(onika.__version__, lambda sweeps: {"figure": sweep.run(sweeps)})


if __name__ == "__main__":
    main()
