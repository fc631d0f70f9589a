"""Steps in the inputs of hardware tasks, as a page shows them at the end of a run (X04)."""

from onika.wire.figures import VariableSteps
from onika.wire.view import JumpView


def jump_view(variable_steps: VariableSteps) -> JumpView:
    """The largest step of a variable, and what became of it and the others."""
    name = f"{variable_steps.variable}[{variable_steps.index}]"
    counts = (variable_steps.count, variable_steps.blended, variable_steps.cycles, variable_steps.refused)
    return JumpView(
        variable_steps.subsystem,
        variable_steps.task,
        name,
        variable_steps.unit,
        variable_steps.step,
        variable_steps.limit,
        variable_steps.at_s,
        *counts,
    )
