"""The engine of a prepared plan (§5.9.2)."""

from collections.abc import Callable, Collection, Mapping

from onika.engine.engine import Engine
from onika.host.loading.plan_preparation import Preparation


def plan_engine(
    prepared: Preparation,
    ranks: Mapping[tuple[int, str], int],
    stands_still: bool,
    judge: Callable[[int, str], bool],
    shared: Collection[str] = (),
) -> Engine:
    """The engine that carries out a plan once; see `Engine` for what it is given."""
    tasks = [(flow, wired) for flow, wired_tasks in enumerate(prepared.flows) for wired in wired_tasks]
    passive = {(flow, wired.name) for flow, wired in tasks if wired.sheet.passive}
    triggers = {(flow, wired.name) for flow, wired in tasks if wired.sheet.trigger}
    return Engine(prepared.plan, prepared.triggers, passive, ranks, triggers, judge, stands_still, shared)
