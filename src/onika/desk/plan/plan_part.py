"""Parts of a plan: some of its flows as a plan of their own, for the runtime that carries them out (E12)."""

from collections.abc import Collection, Sequence

from msgspec import structs

from onika.wire.plan import Fork, Instruction, Join, Plan, PlannedFlow


def flows_of(plan: Plan, homes: Collection[str]) -> tuple[int, ...]:
    """The numbers of the flows in these subsystems, with those that are nested in them."""
    return tuple(at for at, flow in enumerate(plan.flows) if flow.subsystem.partition(".")[0] in homes)


def part_of(plan: Plan, flows: Sequence[int]) -> Plan:
    """These flows alone, numbered anew, with the code of their tasks; whoever begins another one is among them."""
    numbers = {old: new for new, old in enumerate(flows)}
    parts = tuple(_renumbered(plan.flows[flow], numbers) for flow in flows)
    digests = {task.digest for flow in parts for task in flow.tasks}
    return structs.replace(plan, flows=parts, code=tuple(code for code in plan.code if code.digest in digests))


def _renumbered(flow: PlannedFlow, numbers: dict[int, int]) -> PlannedFlow:
    program = tuple(_instruction(instruction, numbers) for instruction in flow.program)
    parent = None if flow.parent is None else numbers[flow.parent]
    return structs.replace(flow, program=program, parent=parent)


def _instruction(instruction: Instruction, numbers: dict[int, int]) -> Instruction:
    match instruction:
        case Fork():
            return structs.replace(instruction, flows=tuple((numbers[flow], at) for flow, at in instruction.flows))
        case Join():
            return structs.replace(instruction, flows=tuple(numbers[flow] for flow in instruction.flows))
    return instruction
