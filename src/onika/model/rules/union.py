"""The tasks that live together while a flow runs and what conflicts among them (dissertation §5.3.4, §5.9.2)."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from onika.model.application import AppFlow, Application, actions, flows_within
from onika.model.configuration import Configuration
from onika.model.rules import placement
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.words.fault import Fault, Place

DEVICE = "DEVICE"
"""The LOCAL parameter whose first word is the device a hardware task claims."""


def configurations_of(
    flow: AppFlow,
    syntax: Syntax,
    configurations: Mapping[str, Configuration],
    applications: Mapping[str, Application],
) -> tuple[Configuration, ...]:
    """The configurations that a flow runs, each once, in the order of the file.

    Nested applications are entered as far as `applications` has them; what is missing, and an application within
    itself, is left out.
    """
    found = _walk(flow, syntax, configurations, applications, set())
    return tuple({configuration.name: configuration for configuration in found}.values())


def tasks_of(configurations: Sequence[Configuration], tasks: Mapping[str, Task]) -> tuple[Task, ...]:
    """The tasks placed in some configurations, each once, in the order of their files; missing ones are left out."""
    names = dict.fromkeys(placed.task for configuration in configurations for placed in configuration.placed)
    return tuple(tasks[name] for name in names if name in tasks)


def conflicts(tasks: Sequence[Task], where: str, place: Place) -> tuple[Fault, ...]:
    """What may not live side by side in one subsystem, though never ON together; `where` names the flow.

    One module twice, a device claimed twice, a constant supplied twice, a pure OUTVAR against a pure INCONST
    (decision 1: sharing an OUTVAR is legal), and a constant that nobody supplies (laws 9 and 10).
    """
    found: list[tuple[str, str]] = []
    for one, other in combinations(tasks, 2):
        found += _between(one, other, f"`{one.name}` and `{other.name}` of {where}")
    found += _unsupplied(tasks, where)
    return tuple(Fault(place, expected, what, "the application is not run") for expected, what in found)


def _between(one: Task, other: Task, both: str) -> Iterator[tuple[str, str]]:
    if one.module == other.module:
        yield "every module once in a flow", f"{one.module} in {both}"
    for device in sorted(_devices(one) & _devices(other)):
        yield "every device claimed once in a flow", f"{device} by {both}"
    for svar in sorted(_constants(one) & _constants(other)):
        yield "one supplier of each constant in a flow", f"{svar} from {both}"
    for svar in sorted(placement.meets_constant(one, other) | placement.meets_constant(other, one)):
        yield "constants that are given at initialisation", f"{svar} between {both}"


def _unsupplied(tasks: Sequence[Task], where: str) -> Iterator[tuple[str, str]]:
    given = frozenset[str]().union(*map(_constants, tasks))
    for task in tasks:
        needed = frozenset(task.svars(tuple(name for name in task.inconst if name not in task.invar)))
        for svar in sorted(needed - given):
            yield f"a task that gives the constant {svar}", f"none for `{task.name}` of {where}"


def _devices(task: Task) -> frozenset[str]:
    return frozenset(line.words[0] for line in task.local if line.key == DEVICE and line.words)


def _constants(task: Task) -> frozenset[str]:
    return frozenset(task.svars(task.outconst))


def _walk(
    flow: AppFlow,
    syntax: Syntax,
    configurations: Mapping[str, Configuration],
    applications: Mapping[str, Application],
    entered: set[str],
) -> Iterator[Configuration]:
    every = (action for _, inner in flows_within(flow, "") for action in actions(inner, syntax))
    for _, icon, _ in every:
        kind, name = syntax.acting(icon.onikon.type), icon.onikon.name
        if kind and kind.is_job and name in configurations:
            yield configurations[name]
        elif kind and kind.is_application and name in applications and name not in entered:
            entered.add(name)
            for inner in applications[name].flows:
                yield from _walk(inner, syntax, configurations, applications, entered)
