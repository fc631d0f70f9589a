"""A plan whose flows run on several runtimes, taken apart: each gets its own flows and the code that these need.

Nested flows stay with the one they are nested in. All flows begin at a tag that they share, so that no robot moves
before every runtime has all its tasks.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from msgspec import structs

from onika.desk.plan.shifted_jump import shifted
from onika.engine.program import straight
from onika.wire.plan import Fork, Instruction, Join, Meet, Plan, PlannedFlow
from onika.wire.rendezvous_link import SharedTag
from onika.wire.request import TargetValues

BEGIN = "application begin"
"""The tag at which all flows begin."""


@dataclass(frozen=True, slots=True)
class PlanPart:
    """What one runtime gets; `flows` are the numbers of its flows in the whole plan, in order."""

    plan: Plan
    flows: tuple[int, ...]

    def targets(self, whole: Sequence[TargetValues]) -> tuple[TargetValues, ...]:
        """The targets of these flows, out of those of the whole plan."""
        own = (target for target in whole if target.flow in self.flows)
        return tuple(structs.replace(target, flow=self.flows.index(target.flow)) for target in own)


def parts_of(plan: Plan, sites: Mapping[str, int]) -> list[PlanPart]:
    """The part of each runtime, in the order of their numbers; `sites` says which one carries out each flow."""
    homes = [_home(plan, number, sites) for number in range(len(plan.flows))]
    return [
        _part(plan, tuple(number for number, home in enumerate(homes) if home == site)) for site in sorted(set(homes))
    ]


def shared_tags(parts: Sequence[PlanPart]) -> tuple[SharedTag, ...]:
    """The tags at which flows of several runtimes meet, with these."""
    tags = [{tag for flow in part.plan.flows for tag in _tags(flow)} for part in parts]
    shared = {tag: tuple(site for site, own in enumerate(tags) if tag in own) for tag in sorted(set().union(*tags))}
    return tuple(SharedTag(tag, sites) for tag, sites in shared.items() if len(sites) > 1)


def _home(plan: Plan, number: int, sites: Mapping[str, int]) -> int:
    flow = plan.flows[number]
    while flow.parent is not None:
        flow = plan.flows[flow.parent]
    return sites[flow.subsystem]


def _part(plan: Plan, flows: tuple[int, ...]) -> PlanPart:
    numbers = {number: place for place, number in enumerate(flows)}
    planned = tuple(_flow(plan.flows[number], numbers) for number in flows)
    used = {task.digest for flow in planned for task in flow.tasks}
    code = tuple(code for code in plan.code if code.digest in used)
    return PlanPart(structs.replace(plan, flows=planned, code=code), flows)


def _flow(flow: PlannedFlow, numbers: Mapping[int, int]) -> PlannedFlow:
    if flow.parent is not None:
        program = tuple(_moved(instruction, numbers, 0) for instruction in flow.program)
        return structs.replace(flow, program=program, parent=numbers[flow.parent])
    program = flow.program or straight(flow.actions)
    return structs.replace(flow, program=(Meet(BEGIN), *(_moved(each, numbers, 1) for each in program)))


def _moved(instruction: Instruction, numbers: Mapping[int, int], by: int) -> Instruction:
    """The instruction so many places later, where flows have other numbers."""
    match instruction:
        case Fork():
            flows = tuple((numbers[number], place) for number, place in instruction.flows)
            return structs.replace(instruction, flows=flows)
        case Join():
            return structs.replace(instruction, flows=tuple(numbers[number] for number in instruction.flows))
    return shifted(instruction, by)


def _tags(flow: PlannedFlow) -> list[str]:
    return [instruction.tag for instruction in flow.program if isinstance(instruction, Meet)]
