"""The loop in bdsim: its own blocks on one clock; the joint is two of its sampled integrators.

Every round begins at time zero again, for that is how bdsim runs a diagram.
"""

from importlib.metadata import version
from time import perf_counter_ns

import bdsim
import numpy as np

from beside.contestant import Figures, serve
from beside.loop.blocks import BLOCKS, RATE_HZ, SIZE, STEP_S, path, torque


def main() -> None:
    """The contestant."""
    simulator = bdsim.BDSim(graphics=False, progress=False, banner=False, toolboxes=False, quiet=True)
    diagram = simulator.blockdiagram()
    clock = diagram.clock(RATE_HZ, unit="Hz")
    zeros = np.zeros(SIZE)
    source = diagram.FUNCTION(path)
    differ = diagram.DERIV_S(clock, x0=path(0.0))
    control = diagram.FUNCTION(torque, nin=4)
    rate = diagram.INTEGRATOR_S(clock, x0=zeros)
    position = diagram.INTEGRATOR_S(clock, x0=zeros)
    diagram.connect(diagram.TIME(), source)
    diagram.connect(source, differ, control[0])
    diagram.connect(differ, control[1])
    diagram.connect(position, control[2])
    diagram.connect(rate, control[3], position)
    diagram.connect(control, rate)
    diagram.compile()

    def measure(steps: int) -> Figures:
        began = perf_counter_ns()
        out = simulator.run(diagram, T=(steps - 0.5) * STEP_S)
        took = perf_counter_ns() - began
        return {"figure": took / 1e3 / steps / BLOCKS, "steps": steps, "position": out.clock0.X[-1][-SIZE:].tolist()}

    serve(version("bdsim"), measure)


if __name__ == "__main__":
    main()
