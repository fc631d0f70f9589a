"""What is said of steps in the inputs of hardware tasks where what drives them was exchanged (X04)."""

from collections.abc import Iterator, Sequence

from onika.wire import event
from onika.wire.figures import VariableSteps


def sentence(one: event.Stepped) -> str:
    """What became of a step, as one sentence."""
    said = f"{one.task}: {one.variable}[{one.index}] stepped by {_number(one.step, one.unit)} at a switch"
    if not one.limit:
        return f"{said}; nobody says how far it may"
    allowed = f"{_number(one.limit, one.unit)} a cycle"
    if not one.is_too_far:
        return f"{said}, within {allowed}"
    if one.cycles:
        return f"{said}, more than {allowed}: blended over {one.cycles} cycles"
    return f"{said}, more than {allowed} and too far to blend: refused, the drive holds"


def summary(steps: Sequence[VariableSteps]) -> Iterator[str]:
    """The lines at the end of a run; none for variables that have never stepped too far."""
    for one in steps:
        if not (one.blended or one.refused):
            continue
        outcome = [f"blended {_times(one.blended)}, over {one.cycles} cycles at most"] * bool(one.blended)
        outcome += [f"refused {_times(one.refused)}"] * bool(one.refused)
        largest = f"{_number(one.step, one.unit)} at {one.at_s:.2f} s, of {_number(one.limit, one.unit)} a cycle"
        yield f"steps of {one.subsystem}/{one.variable}: up to {largest}; {', '.join(outcome)}"


def _number(value: float, unit: str) -> str:
    return f"{value:.4g}" if unit in ("", "-") else f"{value:.4g} {unit}"


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"
