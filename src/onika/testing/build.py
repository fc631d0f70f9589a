"""Plans for tests, in one call each: a job from the names of its tasks, an engine from its flows of jobs."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from onika.engine.engine import Engine
from onika.engine.orders import Spawn
from onika.wire.plan import Plan, PlannedAction, PlannedFlow, PlannedTask


@dataclass(frozen=True, slots=True)
class Job:
    """A job, or a job and its target: the names of its tasks, its trigger and what that is told."""

    tasks: tuple[str, ...]
    trigger: str | None
    arguments: str = ""
    rates: Mapping[str, float] = field(default_factory=dict)
    synch_tag: str | None = None


def job(
    *tasks: str,
    trigger: str | None = None,
    arguments: str = "",
    rates: Mapping[str, float] | None = None,
    synch_tag: str | None = None,
) -> Job:
    """A job of these tasks; without `trigger` nothing ends it."""
    return Job(tasks, trigger, arguments, rates or {}, synch_tag)


def task(name: str, frequency: float | None = 100.0) -> PlannedTask:
    """A periodic task without ports."""
    return PlannedTask(
        name=name,
        module=name,
        digest="",
        place=f"{name}.rmod",
        rtpu="control",
        frequency=frequency,
        type="periodic",
        aliases=(),
        inconst=(),
        outconst=(),
        invar=(),
        outvar=(),
        local=(),
    )


def names(jobs: Iterable[Job]) -> tuple[str, ...]:
    """The union of the tasks of a flow, in the order in which they are first named."""
    return tuple(dict.fromkeys(name for each in jobs for name in each.tasks))


def plan(*flows: Sequence[Job]) -> Plan:
    """A plan of flows 0, 1, … whose actions are called `action 0`, `action 1`, …"""
    return Plan(application="test", flows=tuple(_flow(number, jobs) for number, jobs in enumerate(flows)), code=())


def engine(
    *flows: Sequence[Job],
    passive: Iterable[tuple[int, str]] = (),
    other_triggers: Iterable[tuple[int, str]] = (),
    ranks: Mapping[str, int] | None = None,
) -> Engine:
    """An engine for flows of jobs; tasks rank as they are first named, unless `ranks` says otherwise."""
    return Engine(
        plan(*flows),
        triggers={(flow, index): each.trigger for flow, jobs in enumerate(flows) for index, each in enumerate(jobs)},
        passive=frozenset(passive),
        ranks={
            (flow, name): place if ranks is None else ranks[name]
            for flow, jobs in enumerate(flows)
            for place, name in enumerate(names(jobs))
        },
        other_triggers=frozenset(other_triggers),
    )


def spawns(*flows: Sequence[Job]) -> list[Spawn]:
    """The orders with which a run of these flows begins."""
    return [Spawn(flow, name) for flow, jobs in enumerate(flows) for name in names(jobs)]


def _flow(number: int, jobs: Sequence[Job]) -> PlannedFlow:
    return PlannedFlow(
        subsystem=str(number),
        tasks=tuple(task(name) for name in names(jobs)),
        actions=tuple(_action(number, index, each) for index, each in enumerate(jobs)),
    )


def _action(flow: int, index: int, each: Job) -> PlannedAction:
    return PlannedAction(
        name=f"action {index}",
        job="job",
        target="target" if each.arguments else None,
        place=f"test.appl flow {flow} action {index}",
        tasks=each.tasks,
        rates=tuple(each.rates.items()),
        arguments=each.arguments,
        synch_tag=each.synch_tag,
    )
