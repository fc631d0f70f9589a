"""Describes in a sentence how an input of hardware stepped when its source was exchanged (requirement X04)."""

from collections.abc import Iterator, Sequence

from onika.wire import event
from onika.wire.figures import VariableSteps


def sentence(stepped: event.Stepped) -> str:
    """What became of a step, as one sentence."""
    variable = f"{stepped.task}: {stepped.variable}[{stepped.index}]"
    sentence = f"{variable} stepped by {_number(stepped.step, stepped.unit)} at a switch"
    if not stepped.limit:
        return f"{sentence}; nobody says how far it may"
    allowed = f"{_number(stepped.limit, stepped.unit)} a cycle"
    if not stepped.is_too_far:
        return f"{sentence}, within {allowed}"
    if stepped.cycles:
        return f"{sentence}, more than {allowed}: blended over {stepped.cycles} cycles"
    return f"{sentence}, more than {allowed} and too far to blend: refused, the drive holds"


def summary(steps: Sequence[VariableSteps]) -> Iterator[str]:
    """The lines at the end of a run; none for variables that have never stepped too far."""
    for step in steps:
        if not (step.blended or step.refused):
            continue
        outcome = [f"blended {_times(step.blended)}, over {step.cycles} cycles at most"] * bool(step.blended)
        outcome += [f"refused {_times(step.refused)}"] * bool(step.refused)
        largest = f"{_number(step.step, step.unit)} at {step.at_s:.2f} s, of {_number(step.limit, step.unit)} a cycle"
        yield f"steps of {step.subsystem}/{step.variable}: up to {largest}; {', '.join(outcome)}"


def _number(value: float, unit: str) -> str:
    return f"{value:.4g}" if unit in ("", "-") else f"{value:.4g} {unit}"


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"
