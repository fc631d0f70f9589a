"""Renames the subsystems of a plan, where its own are taken by somebody else."""

from collections.abc import Mapping

from msgspec import structs

from onika.wire.plan import Again, Choose, Instruction, Plan, PlannedFlow, Rest, Unless


def rehoused(plan: Plan, homes: Mapping[str, str]) -> Plan:
    """With the flows that are not nested in these subsystems; nested ones follow theirs, conditions too."""
    return structs.replace(plan, flows=tuple(_flow(flow, homes) for flow in plan.flows))


def chiefs(plan: Plan) -> tuple[str, ...]:
    """The subsystems of the flows that are not nested."""
    return tuple(flow.subsystem for flow in plan.flows if flow.parent is None)


def _flow(flow: PlannedFlow, homes: Mapping[str, str]) -> PlannedFlow:
    program = tuple(_instruction(instruction, homes) for instruction in flow.program)
    return structs.replace(flow, subsystem=_home(flow.subsystem, homes), program=program)


def _instruction(instruction: Instruction, homes: Mapping[str, str]) -> Instruction:
    match instruction:
        case Rest() | Again() | Unless() if instruction.condition:
            return structs.replace(instruction, condition=_condition(instruction.condition, homes))
        case Choose() if instruction.conditions:
            return structs.replace(
                instruction, conditions=tuple(_condition(text, homes) for text in instruction.conditions)
            )
    return instruction


def _condition(text: str, homes: Mapping[str, str]) -> str:
    subsystem, slash, rest = text.partition("/")
    if slash:
        return f"{_home(subsystem, homes)}/{rest}"
    return text


def _home(subsystem: str, homes: Mapping[str, str]) -> str:
    first, dot, rest = subsystem.partition(".")
    return homes.get(first, first) + dot + rest
