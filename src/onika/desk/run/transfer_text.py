"""Describes in a sentence how an input of hardware stepped when its source was exchanged (requirement X04)."""

from collections.abc import Iterator, Sequence

from onika.wire import event
from onika.wire.figures import VariableSteps
from onika.words.reason import Reason


def sentence(stepped: event.Stepped) -> Reason:
    """What became of a step, as one sentence."""
    variable = f"{stepped.task}: {stepped.variable}[{stepped.index}]"
    step, limit = _number(stepped.step, stepped.unit), _number(stepped.limit, stepped.unit)
    if not stepped.limit:
        return Reason.of("desk.step_unlimited", variable=variable, step=step)
    if not stepped.is_too_far:
        return Reason.of("desk.step_within", variable=variable, step=step, limit=limit)
    if stepped.cycles:
        return Reason.of("desk.step_blended", variable=variable, step=step, limit=limit, cycles=stepped.cycles)
    return Reason.of("desk.step_refused", variable=variable, step=step, limit=limit)


def sentence_with_subsystem(stepped: event.Stepped) -> Reason:
    """The same, the subsystem first."""
    return Reason.of("desk.step_of", subsystem=stepped.subsystem, step=sentence(stepped))


def summary(steps: Sequence[VariableSteps]) -> Iterator[Reason]:
    """The lines at the end of a run; none for variables that have never stepped too far."""
    for step in steps:
        if not (step.blended or step.refused):
            continue
        yield Reason.of(
            "desk.steps_of",
            variable=f"{step.subsystem}/{step.variable}",
            step=_number(step.step, step.unit),
            at_s=step.at_s,
            limit=_number(step.limit, step.unit),
            outcomes=tuple(_outcomes(step)),
        )


def _outcomes(step: VariableSteps) -> Iterator[Reason]:
    if step.blended == 1:
        yield Reason.of("desk.blended_once", cycles=step.cycles)
    elif step.blended:
        yield Reason.of("desk.blended_times", count=step.blended, cycles=step.cycles)
    if step.refused == 1:
        yield Reason.of("desk.refused_once")
    elif step.refused:
        yield Reason.of("desk.refused_times", count=step.refused)


def _number(value: float, unit: str) -> Reason:
    if unit in ("", "-"):
        return Reason.of("desk.step_value", value=value)
    return Reason.of("desk.step_value_unit", value=value, unit=unit)
