"""Whether a target was made for an arm of the job before it: another arm's joints would lead it elsewhere (D08)."""

from onika.desk.environment.outcome.icon_source import Sources
from onika.desk.environment.state.model import Model
from onika.model.application import AppFlow, Icon
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax


def hardware_before(model: Model, syntax: Syntax, flow: AppFlow, at: int) -> tuple[str, ...]:
    """The tasks with a device of the job to which a target behind the step at `at` would belong; none: not known."""
    for step in reversed(flow.steps[: at + 1]):
        kind = syntax.acting(step.onikon.type) if isinstance(step, Icon) else None
        if kind is None or not isinstance(step, Icon):
            return ()
        if not kind.is_target:
            return Sources(model, syntax).hardware_of(step.onikon.name)
    return ()


def is_of_another_arm(onikon: Onikon, hardware: tuple[str, ...]) -> bool:
    """Whether it was made for another arm than a job with these tasks moves."""
    return bool(onikon.arm and hardware) and onikon.arm not in hardware
