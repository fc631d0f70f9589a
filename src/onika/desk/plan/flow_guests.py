"""The guests of a plan's flows: programs of other frameworks that carry out all their actions (requirement A20)."""

from collections.abc import Sequence

from onika.desk.plan.subsystem_renaming import chiefs
from onika.wire.plan import Plan, PlannedFlow, PlannedTask

_GUEST = "GUEST"
"""The LOCAL line in which a task names its guest."""


def guest_of(flows: Sequence[PlannedFlow]) -> str:
    """The guest of these flows: the only one that tasks name in every action; empty where they have none."""
    guests = set()
    for flow in flows:
        by_task = {task.name: _named_by(task) for task in flow.tasks}
        for action in flow.actions:
            if not action.is_noop:
                guests.add(next((by_task[name] for name in action.tasks if by_task.get(name)), ""))
    return guests.pop() if len(guests) == 1 else ""


def guests_by_flow(plan: Plan) -> dict[str, str]:
    """The guest of each flow that is not nested and has one, with what is nested in it, by its subsystem."""
    of_chief: dict[str, list[PlannedFlow]] = {home: [] for home in chiefs(plan)}
    for flow in plan.flows:
        chief = flow
        while chief.parent is not None:
            chief = plan.flows[chief.parent]
        of_chief[chief.subsystem].append(flow)
    guests = {home: guest_of(flows) for home, flows in of_chief.items()}
    return {home: guest for home, guest in guests.items() if guest}


def _named_by(task: PlannedTask) -> str:
    return next((" ".join(words) for key, words in task.local if key == _GUEST), "")
