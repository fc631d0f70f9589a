"""The loop in pathsim: four blocks of our own in one simulation with a fixed step.

No block has a continuous state, so pathsim evaluates the graph once per step and then lets the blocks keep their
samples: its leanest way for such a loop. A vector is six channels.
"""

from importlib.metadata import version
from time import perf_counter_ns

import numpy as np
from pathsim import Connection, Simulation
from pathsim.blocks import Block

from beside.contestant import Figures, serve
from beside.loop.blocks import BLOCKS, SIZE, STEP_S, derivative, moved, path, torque


class Path(Block):
    """Where the joint shall be."""

    def __len__(self) -> int:
        return 0

    def update(self, t: float) -> None:
        """Of the present time."""
        self.outputs.update_from_array(path(t))


class Rate(Block):
    """The path's rate."""

    def __init__(self) -> None:
        super().__init__()
        self._old = path(0.0)

    def __len__(self) -> int:
        return 1

    def update(self, t: float) -> None:
        """Against the last sample."""
        self.outputs.update_from_array(derivative(self.inputs.to_array(), self._old))

    def sample(self, t: float, dt: float) -> None:
        """Keep the sample."""
        self._old = self.inputs.to_array().copy()


class Control(Block):
    """What pushes the joint."""

    def __len__(self) -> int:
        return 1

    def update(self, t: float) -> None:
        """Of all four vectors."""
        self.outputs.update_from_array(torque(*self.inputs.to_array().reshape(4, SIZE)))


class Joint(Block):
    """A unit mass."""

    def __init__(self) -> None:
        super().__init__()
        self.position, self._rate = np.zeros(SIZE), np.zeros(SIZE)

    def __len__(self) -> int:
        return 0

    def update(self, t: float) -> None:
        """As the last step left it."""
        self.outputs.update_from_array(np.concatenate((self.position, self._rate)))

    def sample(self, t: float, dt: float) -> None:
        """One step."""
        self.position, self._rate = moved(self.position, self._rate, self.inputs.to_array())


def main() -> None:
    """The contestant."""
    source, differ, control, joint = Path(), Rate(), Control(), Joint()
    wires = [
        Connection(source[:SIZE], differ[:SIZE], control[:SIZE]),
        Connection(differ[:SIZE], control[SIZE : 2 * SIZE]),
        Connection(joint[: 2 * SIZE], control[2 * SIZE : 4 * SIZE]),
        Connection(control[:SIZE], joint[:SIZE]),
    ]
    simulation = Simulation([source, differ, control, joint], wires, dt=STEP_S, log=False)
    done = 0

    def measure(steps: int) -> Figures:
        nonlocal done
        began = perf_counter_ns()
        for _ in range(steps):
            simulation.timestep()
        took = perf_counter_ns() - began
        done += steps
        return {"figure": took / 1e3 / steps / BLOCKS, "steps": done, "position": joint.position.tolist()}

    simulation.time = -STEP_S  # a step evaluates at its end: the first at 0
    serve(version("pathsim"), measure)


if __name__ == "__main__":
    main()
