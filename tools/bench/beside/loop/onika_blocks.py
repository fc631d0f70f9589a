"""The loop in Onika: four modules on one executive in virtual time, joined by the table of state variables.

As a run with `--virtual` does it: inputs are copied in from shared memory, `cycle` runs, outputs are copied out, and
times are counted. Only the worlds are missing, for the joint is a block here.
"""

from collections.abc import Callable, Mapping
from time import perf_counter_ns

import numpy as np

import onika
from beside.contestant import Figures, serve
from beside.loop.blocks import BLOCKS
from beside.unit import Household
from onika.host.guards.call_watchdog import CallWatchdog
from onika.runtime.execution.executive import Executive

MODULES = {
    "path": """
from beside.loop.blocks import path
from onika.module import Module, OutVar

class Path(Module):
    Q_REF = OutVar("double[6]", "rad", "where the joint shall be")

    def cycle(self):
        self.Q_REF = path(self.now)
""",
    "rate": """
from beside.loop.blocks import derivative, path
from onika.module import InVar, Module, OutVar

class Rate(Module):
    Q_REF = InVar("double[6]", "rad", "where the joint shall be")
    QD_REF = OutVar("double[6]", "rad/s", "how fast", name="Q^_REF")

    def on(self, inputs):
        self._old = path(self.now)

    def cycle(self):
        new = self.Q_REF
        self.QD_REF = derivative(new, self._old)
        self._old = new.copy()
""",
    "control": """
from beside.loop.blocks import torque
from onika.module import InVar, Module, OutVar

class Control(Module):
    Q_REF = InVar("double[6]", "rad", "where the joint shall be")
    QD_REF = InVar("double[6]", "rad/s", "how fast", name="Q^_REF")
    Q_MEZ = InVar("double[6]", "rad", "where it is")
    QD_MEZ = InVar("double[6]", "rad/s", "how fast", name="Q^_MEZ")
    TAU_REF = OutVar("double[6]", "Nm", "what pushes it")

    def cycle(self):
        self.TAU_REF = torque(self.Q_REF, self.QD_REF, self.Q_MEZ, self.QD_MEZ)
""",
    "joint": """
from beside.loop.blocks import moved
from onika.module import InVar, Module, OutVar

class Joint(Module):
    TAU_REF = InVar("double[6]", "Nm", "what pushes it")
    Q_MEZ = OutVar("double[6]", "rad", "where it is")
    QD_MEZ = OutVar("double[6]", "rad/s", "how fast", name="Q^_MEZ")

    def cycle(self):
        self.Q_MEZ, self.QD_MEZ = moved(self.Q_MEZ, self.QD_MEZ, self.TAU_REF)
""",
}


class Loop:
    """The four tasks, ON; `step` moves virtual time. `watch` is told whose code runs, as in a runtime."""

    def __init__(self, watch: Callable[[str], None] | None = None, modules: Mapping[str, str] = MODULES) -> None:
        self._house = Household()
        self._executive = Executive("", self._house.views, watch)
        for rank, (name, source) in enumerate(modules.items()):
            self._executive.handle(self._house.spawn(name, source, 1000.0, rank), 0)
        self._executive.handle(self._house.switch(on=modules), 0)

    def step(self, steps: int) -> None:
        """So many steps of 1 ms; every task has its cycle in each."""
        executive = self._executive
        for _ in range(steps):
            now = executive.next_release()
            assert now is not None
            while executive.run_due(now, 1000) is not None:
                pass

    @property
    def position(self) -> list[float]:
        """Where the joint is."""
        found: list[float] = np.asarray(self._house.table.value("Q_MEZ")).tolist()
        return found


def measured(modules: Mapping[str, str]) -> Callable[[int], Figures]:
    """A loop of these modules, and what so many steps more of it take."""
    loop, done = Loop(CallWatchdog().watch, modules), 0

    def measure(steps: int) -> Figures:
        nonlocal done
        began = perf_counter_ns()
        loop.step(steps)
        took = perf_counter_ns() - began
        done += steps
        return {"figure": took / 1e3 / steps / BLOCKS, "steps": done, "position": loop.position}

    return measure


def main() -> None:
    """The contestant."""
    serve(onika.__version__, measured(MODULES))


if __name__ == "__main__":
    main()
