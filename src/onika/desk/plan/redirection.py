"""Redirection before a run: finds what could stand for a task, and what is wrong with a choice.

Nothing here touches a file: a choice lives as long as the session, or as one run of the command line (requirement E09).
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from onika.desk.plan import world_redirection
from onika.desk.plan.subsystem_renaming import chiefs
from onika.model.redirect import Choice, Redirect, choice, world_choice
from onika.model.rules.redirection import Candidate, candidates, is_alike, shortcomings
from onika.model.rules.worlds import relocated
from onika.model.task import Task
from onika.store.program import ApplicationProgram
from onika.wire.plan import Plan
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class RedirectableTask:
    """A task that a flow uses: who has its place now, and who else could."""

    task: Task
    taken_by: str
    """The name of the task that stands there; its own where nothing is redirected."""
    candidates: tuple[Candidate, ...]


def sound(redirects: Sequence[Redirect], program: ApplicationProgram) -> tuple[Redirect, ...]:
    """Those that can be carried out at all; any other would only make everything else look wrong."""
    known_tasks = program.tasks
    return tuple(
        redirect
        for redirect in redirects
        if redirect.is_of_world
        or (
            redirect.old in known_tasks
            and redirect.new in known_tasks
            and is_alike(known_tasks[redirect.old], known_tasks[redirect.new])
        )
    )


def faults(redirects: Sequence[Redirect], plan: Plan, program: ApplicationProgram) -> Iterator[Fault]:
    """Everything that is wrong with what is wished; conflicts among those who live together are told by readiness."""
    yield from _twice(redirects)
    for redirect in redirects:
        place = Place(f"redirect {redirect}")
        subsystems = [flow.subsystem for flow in plan.flows if redirect.holds_in(flow.subsystem)]
        if not subsystems:
            every = ", ".join(flow.subsystem for flow in plan.flows)
            yield Fault(place, Reason.of("desk.flow_unknown", names=every, flow=redirect.flow), NOT_RUN)
            continue
        if redirect.is_of_world:
            yield from world_redirection.faults(redirect, place, _where(redirect, plan), plan)
            continue
        used = _used(plan, program, subsystems)
        if redirect.new not in program.tasks:
            yield Fault(place, Reason.of("desk.task_unknown", new=redirect.new), NOT_RUN)
        if redirect.old not in used:
            where = _where(redirect, plan)
            yield Fault(
                place,
                Reason.of("desk.task_not_of_flow", where=where, used=tuple(sorted(used)), old=redirect.old),
                NOT_RUN,
            )
        elif redirect.new in program.tasks and redirect.new != redirect.old:
            crews = dict(_crews_of(plan, program, redirects, subsystems, redirect.old))
            for reason in shortcomings(used[redirect.old], program.tasks[redirect.new], crews):
                unfit = Reason.of("desk.substitute_unfit", old=redirect.old, reason=reason.reason)
                yield Fault(place, unfit, NOT_RUN, remedies=reason.remedies)


def seats(
    program: ApplicationProgram, plan: Plan, redirects: Sequence[Redirect], known_tasks: Iterable[Task]
) -> dict[str, tuple[RedirectableTask, ...]]:
    """For every flow that is not nested, by its subsystem: the tasks that it uses, each with who could stand for it.

    known   the tasks of all libraries
    """
    library = list(known_tasks)
    seats_of: dict[str, tuple[RedirectableTask, ...]] = {}
    homes = chiefs(plan)
    for home in homes:
        own = _within(plan, home)
        elsewhere = [flow.subsystem for flow in plan.flows if flow.subsystem not in own]
        others = list(_living(plan, program, redirects, elsewhere))
        moved = world_choice(redirects, home)
        offered = [relocated(task, moved) for task in library]
        seats = []
        for task in _used(plan, program, own).values():
            crews = dict(_crews_of(plan, program, redirects, own, task.name))
            taken_by = choice(redirects, home).get(task.name, task.name)
            seats.append(RedirectableTask(task, taken_by, tuple(candidates(task, offered, crews, others))))
        seats_of[home] = tuple(seats)
    return seats_of


def homes_of(redirect: Redirect, plan: Plan, program: ApplicationProgram) -> tuple[str, ...]:
    """The flows that are not nested and use what is redirected, themselves or in what is nested in them."""
    if redirect.is_of_world:
        return world_redirection.homes_of(redirect, plan)
    return tuple(home for home in chiefs(plan) if redirect.old in _used(plan, program, _within(plan, home)))


def _where(redirect: Redirect, plan: Plan) -> Reason:
    """The flow that a redirection is meant for, or the whole application."""
    return Reason.of("desk.flow_named", flow=redirect.flow) if redirect.flow else Reason.plain(plan.application)


def _within(plan: Plan, home: str) -> list[str]:
    """A flow and all that is nested in it."""
    return [flow.subsystem for flow in plan.flows if f"{flow.subsystem}.".startswith(f"{home}.")]


def _twice(redirects: Sequence[Redirect]) -> Iterator[Fault]:
    first: dict[tuple[str, str], Redirect] = {}
    for redirect in redirects:
        other = first.setdefault((redirect.home, redirect.old), redirect)
        if other.new != redirect.new:
            yield Fault(
                Place(f"redirect {redirect}"),
                Reason.of("desk.redirected_twice", old=redirect.old, other=str(other)),
                NOT_RUN,
            )


def _jobs(plan: Plan, subsystem: str) -> Iterator[str]:
    """The jobs of a flow, each once."""
    for flow in plan.flows:
        if flow.subsystem == subsystem:
            yield from dict.fromkeys(action.job for action in flow.actions if not action.is_noop)


def _used(plan: Plan, program: ApplicationProgram, subsystems: Iterable[str]) -> dict[str, Task]:
    """The tasks of flows as their configurations name them."""
    names = [
        placed.task
        for subsystem in subsystems
        for job in _jobs(plan, subsystem)
        if job in program.configurations
        for placed in program.configurations[job].placed
    ]
    return {name: program.tasks[name] for name in dict.fromkeys(names) if name in program.tasks}


def _living(
    plan: Plan, program: ApplicationProgram, redirects: Sequence[Redirect], subsystems: Iterable[str]
) -> Iterator[Task]:
    """The tasks of flows as they will live."""
    for subsystem in subsystems:
        chosen, worlds = choice(redirects, subsystem), world_choice(redirects, subsystem)
        for name in _used(plan, program, [subsystem]):
            yield relocated(_in_place(name, chosen, program), worlds)


def _crews_of(
    plan: Plan, program: ApplicationProgram, redirects: Sequence[Redirect], subsystems: Iterable[str], old: str
) -> Iterator[tuple[str, Sequence[Task]]]:
    for subsystem in subsystems:
        yield from _crews(plan, program, redirects, subsystem, old)


def _crews(
    plan: Plan, program: ApplicationProgram, redirects: Sequence[Redirect], subsystem: str, old: str
) -> Iterator[tuple[str, Sequence[Task]]]:
    """The jobs that use `old`, each with its tasks: those that stand for others in their places, `old` as it is."""
    chosen = {name: new for name, new in choice(redirects, subsystem).items() if name != old}
    worlds = world_choice(redirects, subsystem)
    for job in _jobs(plan, subsystem):
        configuration = program.configurations.get(job)
        names = (
            [placed.task for placed in configuration.placed if placed.task in program.tasks] if configuration else []
        )
        if old in names:
            yield job, [relocated(_in_place(name, chosen, program), worlds) for name in names]


def _in_place(name: str, chosen: Choice, program: ApplicationProgram) -> Task:
    """The task that lives where one is named."""
    return program.tasks.get(chosen.get(name, name), program.tasks[name])
