"""The same plan in other subsystems: those of its own may be taken by somebody else."""

from collections.abc import Mapping

from msgspec import structs

from onika.wire.plan import Again, Choose, Instruction, Plan, PlannedFlow, Rest, Unless


def rehoused(plan: Plan, homes: Mapping[str, str]) -> Plan:
    """With the flows that are not nested in these subsystems; nested ones follow theirs, conditions too."""
    return structs.replace(plan, flows=tuple(_flow(one, homes) for one in plan.flows))


def chiefs(plan: Plan) -> tuple[str, ...]:
    """The subsystems of the flows that are not nested."""
    return tuple(one.subsystem for one in plan.flows if one.parent is None)


def _flow(flow: PlannedFlow, homes: Mapping[str, str]) -> PlannedFlow:
    program = tuple(_instruction(one, homes) for one in flow.program)
    return structs.replace(flow, subsystem=_home(flow.subsystem, homes), program=program)


def _instruction(one: Instruction, homes: Mapping[str, str]) -> Instruction:
    match one:
        case Rest() | Again() | Unless() if one.condition:
            return structs.replace(one, condition=_condition(one.condition, homes))
        case Choose() if one.conditions:
            return structs.replace(one, conditions=tuple(_condition(text, homes) for text in one.conditions))
    return one


def _condition(text: str, homes: Mapping[str, str]) -> str:
    subsystem, slash, rest = text.partition("/")
    return f"{_home(subsystem, homes)}/{rest}" if slash else text


def _home(subsystem: str, homes: Mapping[str, str]) -> str:
    first, dot, rest = subsystem.partition(".")
    return homes.get(first, first) + dot + rest
