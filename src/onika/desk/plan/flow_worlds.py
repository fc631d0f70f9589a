"""The worlds that the flows of a plan drive (requirement E09)."""

from onika.desk.plan.subsystem_renaming import chiefs
from onika.model.planned import task_of
from onika.model.rules.worlds import worlds_of
from onika.wire.plan import Plan, PlannedFlow


def driven_worlds(flow: PlannedFlow) -> tuple[str, ...]:
    """The worlds in which the tasks of a flow have devices, by name."""
    return worlds_of(map(task_of, flow.tasks))


def worlds_by_flow(plan: Plan) -> dict[str, tuple[str, ...]]:
    """The worlds of each flow that is not nested, with those of what is nested in it, by its subsystem."""
    by_flow: dict[str, set[str]] = {home: set() for home in chiefs(plan)}
    for flow in plan.flows:
        chief = flow
        while chief.parent is not None:
            chief = plan.flows[chief.parent]
        by_flow[chief.subsystem].update(driven_worlds(flow))
    return {home: tuple(sorted(worlds)) for home, worlds in by_flow.items()}
