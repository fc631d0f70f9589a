"""The loop in Drake: four LeafSystems in Python in one diagram, periodic discrete updates, one simulator.

Outputs are computed when they are pulled and cached by Drake; the joint's outputs are Drake's own of its state.
"""

from importlib.metadata import version
from time import perf_counter_ns
from typing import Any

import numpy as np
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder, LeafSystem

from beside.contestant import Figures, serve
from beside.loop.blocks import BLOCKS, SIZE, STEP_S, derivative, moved, path, torque


class Path(LeafSystem):
    """Where the joint shall be."""

    def __init__(self) -> None:
        LeafSystem.__init__(self)
        self.DeclareVectorOutputPort("Q_REF", SIZE, self._give, {self.time_ticket()})

    def _give(self, context: Any, output: Any) -> None:
        output.SetFromVector(path(context.get_time()))


class Rate(LeafSystem):
    """The path's rate; the last sample is its state."""

    def __init__(self) -> None:
        LeafSystem.__init__(self)
        self._wanted = self.DeclareVectorInputPort("Q_REF", SIZE)
        self.DeclareDiscreteState(path(0.0))
        self.DeclareVectorOutputPort("Q^_REF", SIZE, self._give)
        self.DeclarePeriodicDiscreteUpdateEvent(STEP_S, 0.0, self._keep)

    def _give(self, context: Any, output: Any) -> None:
        old = context.get_discrete_state_vector().value()
        output.SetFromVector(derivative(self._wanted.Eval(context), old))

    def _keep(self, context: Any, state: Any) -> None:
        state.set_value(self._wanted.Eval(context))


class Control(LeafSystem):
    """What pushes the joint."""

    def __init__(self) -> None:
        LeafSystem.__init__(self)
        self.ports = [self.DeclareVectorInputPort(name, SIZE) for name in ("Q_REF", "Q^_REF", "Q_MEZ", "Q^_MEZ")]
        self.DeclareVectorOutputPort("TAU_REF", SIZE, self._give)

    def _give(self, context: Any, output: Any) -> None:
        output.SetFromVector(torque(*[port.Eval(context) for port in self.ports]))


class Joint(LeafSystem):
    """A unit mass."""

    def __init__(self) -> None:
        LeafSystem.__init__(self)
        self._pushed = self.DeclareVectorInputPort("TAU_REF", SIZE)
        position, rate = self.DeclareDiscreteState(SIZE), self.DeclareDiscreteState(SIZE)
        self.DeclareStateOutputPort("Q_MEZ", position)
        self.DeclareStateOutputPort("Q^_MEZ", rate)
        self.DeclarePeriodicDiscreteUpdateEvent(STEP_S, 0.0, self._move)

    def _move(self, context: Any, state: Any) -> None:
        now = context.get_discrete_state()
        position, rate = moved(now.value(0), now.value(1), self._pushed.Eval(context))
        state.set_value(0, position)
        state.set_value(1, rate)


def main() -> None:
    """The contestant."""
    builder = DiagramBuilder()
    source, differ, control, joint = (builder.AddSystem(one()) for one in (Path, Rate, Control, Joint))
    given = (source.GetOutputPort("Q_REF"), differ.get_output_port(), *(joint.get_output_port(i) for i in (0, 1)))
    builder.Connect(given[0], differ.get_input_port())
    for one, port in zip(given, control.ports, strict=True):
        builder.Connect(one, port)
    builder.Connect(control.get_output_port(), joint.get_input_port())
    diagram = builder.Build()
    simulator = Simulator(diagram)
    simulator.Initialize()
    done = 0

    def measure(steps: int) -> Figures:
        nonlocal done
        done += steps
        until = (done - 0.5) * STEP_S  # between two steps, so that rounding decides nothing
        began = perf_counter_ns()
        simulator.AdvanceTo(until)
        took = perf_counter_ns() - began
        own = joint.GetMyContextFromRoot(simulator.get_context())
        position = np.asarray(own.get_discrete_state().value(0))
        return {"figure": took / 1e3 / steps / BLOCKS, "steps": done, "position": position.tolist()}

    serve(version("drake"), measure)


if __name__ == "__main__":
    main()
