"""Where the flows of a plan begin: not at their first actions, but where a run of them ended (decision 76)."""

from collections.abc import Mapping
from typing import NamedTuple

from msgspec import structs

from onika.desk.plan.shifted_jump import shifted
from onika.engine.program import FlowProgram
from onika.wire.plan import Do, Fork, Halt, Instruction, Jump, Meet, Plan, PlannedFlow, Rest
from onika.words.reason import Reason


class FlowEnd(NamedTuple):
    """Where a flow was when its run ended."""

    action: int
    """The one that was carried out, or the last one; -1: none was."""
    is_acting: bool
    """Whether that was under way, so that it is to be carried out again."""


def places(plan: Plan, ends: Mapping[int, FlowEnd], former: Plan) -> dict[str, int] | Reason:
    """The place in its program where each flow goes on, by subsystem; or why there is none for one of them.

    ends     by the numbers of the flows
    former   the plan of the run that ended: who has carried out nothing in it begins where it began there
    """
    places: dict[str, int] = {}
    for number, flow in enumerate(plan.flows):
        if flow.parent is not None:
            continue
        end = ends.get(number, FlowEnd(-1, is_acting=False))
        place = _onward(flow, end) if end.action >= 0 else _beginning(former.flows[number])
        if isinstance(place, Reason):
            return place
        places[flow.subsystem] = place
    return places


def is_anywhere(plan: Plan, ends: Mapping[int, FlowEnd]) -> bool:
    """Whether something has begun, and everybody has a place to go on."""
    has_begun = any(end.action >= 0 for end in ends.values()) or any(map(_beginning, plan.flows))
    return has_begun and isinstance(places(plan, ends, plan), dict)


def entry(flow: PlannedFlow, action: int) -> int:
    """The place where an action of a flow begins, at its tag if it has one; raises ValueError where it is nested."""
    program = FlowProgram(flow)
    place = _unless_nested(flow, program, program.entries[action])
    if isinstance(place, Reason):
        raise ValueError(place)
    return place


def begun_at(plan: Plan, places: Mapping[str, int]) -> Plan:
    """The plan whose flows begin at these places; what is before them is still there to be sent to."""
    numbers = {number for number, flow in enumerate(plan.flows) if places.get(flow.subsystem)}
    flows = [
        _begun_at(flow, places[flow.subsystem], numbers) if number in numbers else _moved_flow(flow, numbers)
        for number, flow in enumerate(plan.flows)
    ]
    return structs.replace(plan, flows=tuple(flows))


def _beginning(flow: PlannedFlow) -> int:
    """Where a flow began, in the numbers of its own program: elsewhere than at 0 where `begun_at` has sent it there."""
    first = flow.program[0] if flow.program else None
    return first.to - 1 if isinstance(first, Jump) else 0


def _onward(flow: PlannedFlow, end: FlowEnd) -> int | Reason:
    program = FlowProgram(flow)
    at = next(
        place
        for place, instruction in enumerate(program.instructions)
        if isinstance(instruction, Do) and instruction.action == end.action
    )
    if end.is_acting:
        return _unless_nested(flow, program, at)
    place = _behind(program, at + 1)
    if not isinstance(program.instructions[place], Do | Meet | Halt | Fork):
        return Reason.of("run.goes_on_undecided", flow=flow.subsystem, action=end.action + 1)
    return _unless_nested(flow, program, place)


def _behind(program: FlowProgram, place: int) -> int:
    """Past breakpoints, at which it has rested, and plain jumps."""
    for _ in program.instructions:
        instruction = program.instructions[place]
        if isinstance(instruction, Rest):
            place += 1
        elif isinstance(instruction, Jump) and not instruction.loop:
            place = instruction.to
        else:
            break
    return place


def _unless_nested(flow: PlannedFlow, program: FlowProgram, place: int) -> int | Reason:
    if program.parallel_at(place):
        return Reason.of("run.goes_on_nested", flow=flow.subsystem)
    return place


def _begun_at(flow: PlannedFlow, place: int, moved: set[int]) -> PlannedFlow:
    program = [_moved(instruction, 1, moved) for instruction in FlowProgram(flow).instructions]
    return structs.replace(flow, program=(Jump(place + 1), *program))


def _moved_flow(flow: PlannedFlow, moved: set[int]) -> PlannedFlow:
    program = tuple(_moved(instruction, 0, moved) for instruction in flow.program)
    return structs.replace(flow, program=program)


def _moved(instruction: Instruction, by: int, moved: set[int]) -> Instruction:
    """An instruction of a program before which so many others have come."""
    if isinstance(instruction, Fork):
        flows = tuple((number, place + (number in moved)) for number, place in instruction.flows)
        return structs.replace(instruction, flows=flows)
    return shifted(instruction, by)
