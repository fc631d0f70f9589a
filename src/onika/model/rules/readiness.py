"""Whether an application can be run: every fault at once with its place (requirement E01, dissertation §5.9.2)."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

from onika.model.application import AppFlow, Application, Hole, Icon, Step, actions, is_target, wanted_targets
from onika.model.configuration import Configuration
from onika.model.rules import jigsaw, loop, placement, union
from onika.model.syntax import END, START, Syntax
from onika.model.task import Task
from onika.words.fault import Fault, Place


@dataclass(frozen=True, slots=True)
class _Laboratory:
    """What the icons of an application stand for."""

    syntax: Syntax
    configurations: Mapping[str, Configuration]
    tasks: Mapping[str, Task]
    applications: Mapping[str, Application] | None
    unread: frozenset[str]


def faults(
    application: Application,
    syntax: Syntax,
    configurations: Mapping[str, Configuration],
    tasks: Mapping[str, Task],
    place: Place,
    *,
    applications: Mapping[str, Application] | None = None,
    unread: frozenset[str] = frozenset(),
) -> tuple[Fault, ...]:
    """Everything that keeps `application` from running; empty: it can.

    `configurations` and `tasks` hold what was found, by name; `applications` what nested icons run, None where nested
    applications cannot be executed yet. `unread` names configurations and tasks that are there and at fault, as is told
    elsewhere.
    """
    laboratory = _Laboratory(syntax, configurations, tasks, applications, unread)
    found = [] if application.flows else [_fault(place, "at least one flow", "none")]
    for number, flow in enumerate(application.flows):
        where = f"flow {number}"
        found += _structure(flow, laboratory.syntax, where, place)
        found += loop.faults(flow, syntax, where, place)
        if applications is None:
            found += _not_yet(flow, syntax, where, place)
        found += _nested(flow, (application.name,), laboratory, where, place)
        found += _contents(flow, laboratory, where, place)
    return tuple(dict.fromkeys(found))


def _fault(place: Place, expected: str, found: str) -> Fault:
    return Fault(place, expected, found, "the application is not run")


def _on(place: Place, step: Step) -> Place:
    """The line of the file at which a step stands, where it was read from one."""
    return Place(place.file, step.line)


def _at(where: str, position: int, icon: Icon) -> str:
    return f"`{icon.onikon.name}`, step {position} of {where}"


# -- the shape of a flow


def _structure(
    flow: AppFlow, syntax: Syntax, where: str, place: Place, *, fills_holes: bool = False
) -> Iterator[Fault]:
    """Holes, types, pairs and edges of one flow; `fills_holes`: a target from outside goes into its holes."""
    if not flow.steps:
        yield _fault(place, f"an action in {where}", "none")
        return
    for position, step in enumerate(flow.steps):
        if isinstance(step, Hole):
            if fills_holes:
                continue
            yield _fault(_on(place, step), "an application without holes", f"a hole at step {position} of {where}")
        elif isinstance(step, Icon) and syntax.acting(step.onikon.type) is None:
            yield _fault(
                _on(place, step), "a type the syntax defines", f"{step.onikon.type} of {_at(where, position, step)}"
            )
    yield from _pairs(flow, syntax, where, place)
    for position in jigsaw.misfits(flow, syntax):
        left, right = _name(flow, position - 1), _name(flow, position)
        at = _on(place, flow.steps[min(position, len(flow.steps) - 1)])
        yield _fault(at, "edges that fit", f"{right} behind {left}, at step {position} of {where}")


def _pairs(flow: AppFlow, syntax: Syntax, where: str, place: Place) -> Iterator[Fault]:
    """A target behind every action that takes one, and nowhere else."""
    used = set()
    for action in actions(flow, syntax):
        position, icon, targets = action
        used |= set(range(position, action.end))
        wanted = wanted_targets(icon.onikon, syntax)
        for missing in wanted[len(targets) :]:
            yield _fault(_on(place, icon), f"a {missing} behind it", f"none behind {_at(where, position, icon)}")
    for position, step in enumerate(flow.steps):
        if isinstance(step, Icon) and is_target(step, syntax) and position not in used:
            yield _fault(
                _on(place, step), "an action that takes this target", f"none before {_at(where, position, step)}"
            )


def _name(flow: AppFlow, position: int) -> str:
    if position < 0:
        return START
    if position == len(flow.steps):
        return END
    step = flow.steps[position]
    return f"`{step.onikon.name}` ({step.onikon.type})" if isinstance(step, Icon) else "a hole"


# -- nested applications


def _not_yet(flow: AppFlow, syntax: Syntax, where: str, place: Place) -> Iterator[Fault]:
    for position, icon, _ in actions(flow, syntax):
        kind = syntax.acting(icon.onikon.type)
        if kind and kind.is_application:
            yield _fault(
                _on(place, icon), "jobs, as nested applications are not yet executable", _at(where, position, icon)
            )


def _nested(flow: AppFlow, path: tuple[str, ...], laboratory: _Laboratory, where: str, place: Place) -> Iterator[Fault]:
    """Nested applications that are missing, at fault themselves or within themselves (requirement E06)."""
    for position, icon, _ in actions(flow, laboratory.syntax):
        kind = laboratory.syntax.acting(icon.onikon.type)
        if not kind or not kind.is_application or laboratory.applications is None:
            continue
        name = icon.onikon.name
        if name in path:
            cycle = " in ".join((name, *reversed(path[path.index(name) :])))
            yield _fault(_on(place, icon), "no application within itself", f"{cycle}, at {_at(where, position, icon)}")
        elif name not in laboratory.applications:
            yield _fault(_on(place, icon), f"the application {name}", f"none for {_at(where, position, icon)}")
        else:
            for number, inner in enumerate(laboratory.applications[name].flows):
                inside = f"flow {number} of `{name}` in {where}"
                yield from _structure(inner, laboratory.syntax, inside, place, fills_holes=kind.needs_target)
                yield from loop.faults(inner, laboratory.syntax, inside, place)
                yield from _nested(inner, (*path, name), laboratory, inside, place)
                yield from _jobs(inner, laboratory, inside, place)


# -- what the icons run


def _contents(flow: AppFlow, laboratory: _Laboratory, where: str, place: Place) -> Iterator[Fault]:
    yield from _jobs(flow, laboratory, where, place)
    known = laboratory.applications or {}
    used = union.configurations_of(flow, laboratory.syntax, laboratory.configurations, known)
    for configuration in used:
        yield from _configuration(configuration, laboratory, where, place)
    yield from union.conflicts(union.tasks_of(used, laboratory.tasks), where, place)


def _jobs(flow: AppFlow, laboratory: _Laboratory, where: str, place: Place) -> Iterator[Fault]:
    """A configuration for every job, whose trigger has the type of its icon (decision 36)."""
    for position, icon, _ in actions(flow, laboratory.syntax):
        kind = laboratory.syntax.acting(icon.onikon.type)
        if not kind or not kind.is_job:
            continue
        configuration = laboratory.configurations.get(icon.onikon.name)
        if configuration is None:
            if icon.onikon.name not in laboratory.unread:
                expected = f"the configuration {icon.onikon.name}"
                yield _fault(_on(place, icon), expected, f"none for {_at(where, position, icon)}")
            continue
        tasks = union.tasks_of([configuration], laboratory.tasks)
        types = [task.object_type for task in tasks if task.object_type]
        wanted = laboratory.syntax.find(types[0]) if types else None
        known = laboratory.syntax.find(icon.onikon.type)
        if known and known.needs_target and not types and len(tasks) == len(configuration.placed):
            yield _fault(_on(place, icon), f"a task with OBJECT {known.name} in `{configuration.name}`", "none")
        elif known and wanted and wanted.name != known.name:
            yield _fault(
                _on(place, icon),
                f"a {wanted.name}, as its trigger says",
                f"{known.name} for {_at(where, position, icon)}",
            )


def _configuration(configuration: Configuration, laboratory: _Laboratory, where: str, place: Place) -> Iterator[Fault]:
    """Its tasks are there and may stand together, Equations (2) and (3)."""
    inside = f"`{configuration.name}`, used in {where}"
    if not configuration.placed:
        yield _fault(place, "tasks", f"none in {inside}")
    for placed in configuration.placed:
        if placed.task not in laboratory.tasks and placed.task not in laboratory.unread:
            yield _fault(place, f"the task {placed.task}", f"none for {inside}")
    for one, other in combinations(union.tasks_of([configuration], laboratory.tasks), 2):
        for refusal in placement.refusals(other, [one]):
            yield _fault(place, "tasks that may stand together", f"`{other.name}` in {inside}: {refusal.reason}")
