"""Redirection of an application that is about to run: what could stand for its tasks, and what is wrong with a wish.

Nothing here touches a file (E09, §5.9.1): a wish lives as long as the session, or as one run from the command line.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from onika.desk.plan.subsystem_renaming import chiefs
from onika.model.redirect import Choice, Redirect, choice
from onika.model.rules.redirection import Candidate, candidates, is_alike, shortcomings
from onika.model.task import Task
from onika.store.program import Program
from onika.wire.plan import Plan
from onika.words.fault import Fault, Place

NOT_RUN = "the application is not run"


@dataclass(frozen=True, slots=True)
class Seat:
    """A task that a flow uses: who has its place now, and who else could."""

    task: Task
    taken_by: str
    """The name of the task that stands there; its own where nothing is redirected."""
    candidates: tuple[Candidate, ...]


def sound(redirects: Sequence[Redirect], program: Program) -> tuple[Redirect, ...]:
    """Those that can be carried out at all; any other would only make everything else look wrong."""
    known = program.tasks
    return tuple(
        one for one in redirects if one.old in known and one.new in known and is_alike(known[one.old], known[one.new])
    )


def faults(redirects: Sequence[Redirect], plan: Plan, program: Program) -> Iterator[Fault]:
    """Everything that is wrong with what is wished; conflicts among those who live together are told by readiness."""
    yield from _twice(redirects)
    for one in redirects:
        place = Place(f"redirect {one}")
        subsystems = [flow.subsystem for flow in plan.flows if one.holds_in(flow.subsystem)]
        if not subsystems:
            known = ", ".join(flow.subsystem for flow in plan.flows)
            yield Fault(place, f"a flow by its number or its subsystem ({known})", one.flow, NOT_RUN)
            continue
        used = _used(plan, program, subsystems)
        if one.new not in program.tasks:
            yield Fault(place, "a task on the search path", f"no {one.new}", NOT_RUN)
        if one.old not in used:
            where = f"flow {one.flow}" if one.flow else plan.application
            yield Fault(place, f"a task of {where} ({', '.join(sorted(used))})", one.old, NOT_RUN)
        elif one.new in program.tasks and one.new != one.old:
            crews = {key: crew for name in subsystems for key, crew in _crews(plan, program, redirects, name, one.old)}
            for reason in shortcomings(used[one.old], program.tasks[one.new], crews):
                expected = f"a task with the outputs of {one.old}, that works in its place"
                yield Fault(place, expected, reason.reason, NOT_RUN, remedies=reason.remedies)


def seats(
    program: Program, plan: Plan, redirects: Sequence[Redirect], known: Iterable[Task]
) -> dict[str, tuple[Seat, ...]]:
    """For every flow that is not nested, by its subsystem: the tasks that it uses, each with who could stand for it.

    known   the tasks of all libraries
    """
    library = list(known)
    found: dict[str, tuple[Seat, ...]] = {}
    homes = chiefs(plan)
    for home in homes:
        own = _within(plan, home)
        elsewhere = [one.subsystem for one in plan.flows if one.subsystem not in own]
        others = list(_living(plan, program, redirects, elsewhere).values())
        seats = []
        for task in _used(plan, program, own).values():
            crews = {key: crew for name in own for key, crew in _crews(plan, program, redirects, name, task.name)}
            taken_by = choice(redirects, home).get(task.name, task.name)
            seats.append(Seat(task, taken_by, tuple(candidates(task, library, crews, others))))
        found[home] = tuple(seats)
    return found


def homes_of(task: str, plan: Plan, program: Program) -> tuple[str, ...]:
    """The flows that are not nested and use a task, themselves or in what is nested in them."""
    return tuple(home for home in chiefs(plan) if task in _used(plan, program, _within(plan, home)))


def _within(plan: Plan, home: str) -> list[str]:
    """A flow and all that is nested in it."""
    return [one.subsystem for one in plan.flows if f"{one.subsystem}.".startswith(f"{home}.")]


def _twice(redirects: Sequence[Redirect]) -> Iterator[Fault]:
    first: dict[tuple[str, str], Redirect] = {}
    for one in redirects:
        other = first.setdefault((one.home, one.old), one)
        if other.new != one.new:
            yield Fault(Place(f"redirect {one}"), f"one task in place of {one.old}", f"{other} too", NOT_RUN)


def _jobs(plan: Plan, subsystem: str) -> Iterator[str]:
    """The jobs of a flow, each once."""
    for flow in plan.flows:
        if flow.subsystem == subsystem:
            yield from dict.fromkeys(one.job for one in flow.actions if not one.is_noop)


def _used(plan: Plan, program: Program, subsystems: Iterable[str]) -> dict[str, Task]:
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
    plan: Plan, program: Program, redirects: Sequence[Redirect], subsystems: Iterable[str]
) -> Mapping[str, Task]:
    """The tasks of flows as they will live."""
    found: dict[str, Task] = {}
    for subsystem in subsystems:
        chosen = choice(redirects, subsystem)
        for name in _used(plan, program, [subsystem]):
            task = _in_place(name, chosen, program)
            found[task.name] = task
    return found


def _crews(
    plan: Plan, program: Program, redirects: Sequence[Redirect], subsystem: str, old: str
) -> Iterator[tuple[str, Sequence[Task]]]:
    """The jobs that use `old`, each with its tasks: those that stand for others in their places, `old` as it is."""
    chosen = {name: new for name, new in choice(redirects, subsystem).items() if name != old}
    for job in _jobs(plan, subsystem):
        configuration = program.configurations.get(job)
        names = [one.task for one in configuration.placed if one.task in program.tasks] if configuration else []
        if old in names:
            yield job, [_in_place(name, chosen, program) for name in names]


def _in_place(name: str, chosen: Choice, program: Program) -> Task:
    """The task that lives where one is named."""
    return program.tasks.get(chosen.get(name, name), program.tasks[name])
