"""Steps in the inputs of hardware tasks, as a page shows them at the end of a run (X04)."""

from onika.wire.figures import VariableSteps
from onika.wire.view import JumpView


def jump_view(one: VariableSteps) -> JumpView:
    """The largest step of a variable, and what became of it and the others."""
    name = f"{one.variable}[{one.index}]"
    counts = (one.count, one.blended, one.cycles, one.refused)
    return JumpView(one.subsystem, one.task, name, one.unit, one.step, one.limit, one.at_s, *counts)
