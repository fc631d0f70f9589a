"""The loop in pathsim as its library invites one to write it: functions, a sampled derivative, two integrators.

Explicit Euler with a fixed step; a vector is six channels. pathsim evaluates the graph at both ends of a step.
"""

from importlib.metadata import version
from time import perf_counter_ns

import numpy as np
from pathsim import Connection, Simulation
from pathsim.blocks import DiscreteDerivative, Function, Integrator, Source
from pathsim.solvers import EUF

from beside.contestant import Figures, serve
from beside.loop.blocks import BLOCKS, SIZE, STEP_S, path, torque


def main() -> None:
    """The contestant."""
    clock = Source(lambda t: t)
    source = Function(lambda t: tuple(path(t)))
    differ = DiscreteDerivative(T=STEP_S)
    control = Function(lambda *u: tuple(torque(*np.reshape(u, (4, SIZE)))))
    position, rate = Integrator(np.zeros(SIZE)), Integrator(np.zeros(SIZE))
    wires = [
        Connection(clock, source),
        Connection(source[:SIZE], differ[:SIZE], control[:SIZE]),
        Connection(differ[:SIZE], control[SIZE : 2 * SIZE]),
        Connection(position[:SIZE], control[2 * SIZE : 3 * SIZE]),
        Connection(rate[:SIZE], control[3 * SIZE : 4 * SIZE], position[:SIZE]),
        Connection(control[:SIZE], rate[:SIZE]),
    ]
    blocks = [clock, source, differ, control, position, rate]
    simulation = Simulation(blocks, wires, dt=STEP_S, Solver=EUF, log=False)
    done = 0

    def measure(steps: int) -> Figures:
        nonlocal done
        began = perf_counter_ns()
        for _ in range(steps):
            simulation.timestep()
        took = perf_counter_ns() - began
        done += steps
        return {"figure": took / 1e3 / steps / BLOCKS, "steps": done, "position": position.engine.state.tolist()}

    serve(version("pathsim"), measure)


if __name__ == "__main__":
    main()
