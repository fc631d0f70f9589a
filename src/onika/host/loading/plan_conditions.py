"""Conditions of a plan against the variables they speak of: each has to name one number that will be there (D13)."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from onika.runtime.wiring import WiredTask
from onika.wire.plan import Again, Choose, Do, PlannedFlow, Rest, Unless
from onika.words.condition import Condition
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import NOTHING, Reason
from onika.words.shape import Shape

Constants = Mapping[int, Mapping[str, Any]]
"""By flow: the constants that shapes depend on, as far as they are known before the run."""


def wrong_conditions(
    flows: Sequence[PlannedFlow], wired: Sequence[Sequence[WiredTask]], constants: Constants
) -> list[Fault]:
    """Conditions of tests, branches and breakpoints that could never hold, or that are none."""
    shapes = {
        planned.subsystem: {
            port.svar: _resolved(port.shape, constants.get(number, {})) for task in tasks for port in task.ports
        }
        for number, (planned, tasks) in enumerate(zip(flows, wired, strict=True))
    }
    return [
        Fault(place, reason, NOT_RUN)
        for flow in flows
        for place, text in _conditions(flow)
        if (reason := _reason(text, flow.subsystem, shapes))
    ]


def _conditions(flow: PlannedFlow) -> Iterator[tuple[Place, str]]:
    """Every condition of a flow's program, and the action behind which it is judged."""
    place = Place(flow.actions[0].place, flow.actions[0].line) if flow.actions else Place(flow.subsystem)
    for instruction in flow.program:
        match instruction:
            case Do():
                place = Place(flow.actions[instruction.action].place, flow.actions[instruction.action].line)
            case Choose():
                yield from ((place, text) for text in instruction.conditions)
            case Again() | Unless() | Rest():
                yield from ((place, text) for text in (instruction.condition,) if text)


def _reason(text: str, home: str, shapes: Mapping[str, Mapping[str, Shape]]) -> Reason:
    """Why a condition could never hold; empty: it is sound."""
    try:
        condition = Condition.parse(text)
    except ValueError:
        return Reason.of("host.condition_form", text=text)
    subsystem, _, name = condition.address.rpartition("/")
    known_shapes = shapes.get(subsystem or home, {})
    if name not in known_shapes:
        return Reason.of("host.condition_variable", subsystem=subsystem or home, text=text)
    shape = known_shapes[name]
    if shape.type.is_text:
        return Reason.of("host.condition_on_text", name=name, shape=str(shape), text=text)
    fits = len(condition.index) == len(shape.dims) and all(
        not isinstance(dim, int) or at < dim for at, dim in zip(condition.index, shape.dims, strict=False)
    )
    if fits:
        return NOTHING
    return Reason.of("host.condition_element", name=name, shape=str(shape), text=text)


def _resolved(shape: Shape, constants: Mapping[str, Any]) -> Shape:
    """The shape with every dimension that is known by now."""
    dims = tuple(int(constants[dim]) if isinstance(dim, str) and dim in constants else dim for dim in shape.dims)
    return Shape(shape.type, dims)
