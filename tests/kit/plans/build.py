"""Plans for tests, in one call each: a job from the names of its tasks, an engine from its flows of jobs."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from onika.engine.engine import Engine
from onika.engine.orders import Spawn
from onika.wire.plan import Instruction, Plan, PlannedAction, PlannedFlow, PlannedTask


@dataclass(frozen=True, slots=True)
class Job:
    """A job, or a job and its target: the names of its tasks, its trigger and what that is told."""

    tasks: tuple[str, ...]
    trigger: str | None
    arguments: str = ""
    rates: Mapping[str, float] = field(default_factory=dict)
    synch_tag: str | None = None
    marker: bool = False
    is_noop: bool = False


@dataclass(frozen=True, slots=True)
class Flow:
    """Jobs and the program in which they follow each other; none: one after the other."""

    jobs: tuple[Job, ...]
    program: tuple[Instruction, ...] = ()
    parent: int | None = None


Jobs = Sequence[Job] | Flow
"""What a flow is made of."""


def job(
    *tasks: str,
    trigger: str | None = None,
    arguments: str = "",
    rates: Mapping[str, float] | None = None,
    synch_tag: str | None = None,
    marker: bool = False,
) -> Job:
    """A job of these tasks; without `trigger` nothing ends it. `marker`: there is a breakpoint after it."""
    return Job(tasks, trigger, arguments, rates or {}, synch_tag, marker)


def noop(synch_tag: str | None = None, marker: bool = False) -> Job:
    """A no-op."""
    return Job((), None, synch_tag=synch_tag, marker=marker, is_noop=True)


def flow(jobs: Iterable[Job], program: Iterable[Instruction] = (), parent: int | None = None) -> Flow:
    """A flow of these jobs in this program; `parent` begins it where it belongs to a nested parallel application."""
    return Flow(tuple(jobs), tuple(program), parent)


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


def plan(*flows: Jobs) -> Plan:
    """A plan of flows 0, 1, … whose actions are called `action 0`, `action 1`, …"""
    planned = (_planned(number, _whole(jobs)) for number, jobs in enumerate(flows))
    return Plan(application="test", flows=tuple(planned), code=())


def engine(
    *flows: Jobs,
    passive: Iterable[tuple[int, str]] = (),
    other_triggers: Iterable[tuple[int, str]] = (),
    ranks: Mapping[str, int] | None = None,
    judge: Callable[[int, str], bool] = lambda _flow, _condition: False,
    stands_still: bool = False,
    shared: Iterable[str] = (),
) -> Engine:
    """An engine for flows of jobs; tasks rank as they are first named, unless `ranks` says otherwise."""
    whole = [_whole(jobs).jobs for jobs in flows]
    return Engine(
        plan(*flows),
        triggers={(flow, index): each.trigger for flow, jobs in enumerate(whole) for index, each in enumerate(jobs)},
        passive=frozenset(passive),
        ranks={
            (flow, name): place if ranks is None else ranks[name]
            for flow, jobs in enumerate(whole)
            for place, name in enumerate(names(jobs))
        },
        other_triggers=frozenset(other_triggers),
        judge=judge,
        stands_still=stands_still,
        shared=tuple(shared),
    )


def spawns(*flows: Jobs) -> list[Spawn]:
    """The orders with which a run of these flows begins."""
    return [Spawn(flow, name) for flow, jobs in enumerate(flows) for name in names(_whole(jobs).jobs)]


def _whole(jobs: Jobs) -> Flow:
    return jobs if isinstance(jobs, Flow) else Flow(tuple(jobs))


def _planned(number: int, whole: Flow) -> PlannedFlow:
    return PlannedFlow(
        subsystem=str(number),
        tasks=tuple(task(name) for name in names(whole.jobs)),
        actions=tuple(_action(number, index, each) for index, each in enumerate(whole.jobs)),
        program=whole.program,
        parent=whole.parent,
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
        marker=each.marker,
        is_noop=each.is_noop,
    )
