"""Finds which flows share a subsystem, and what must hold among their tasks (law 9, requirement E01)."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from onika.model.application import Branch, Icon
from onika.model.configuration import Configuration
from onika.model.redirect import Redirect, choice, world_choice
from onika.model.rules import union
from onika.model.rules.nesting import Nest
from onika.model.rules.outline import Outline, Passage
from onika.model.rules.redirection import redirected
from onika.model.rules.worlds import all_relocated
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.words.condition import Condition
from onika.words.fault import Fault
from onika.words.reason import NOTHING, Reason


@dataclass(slots=True)
class SharedSubsystem:
    """One subsystem: the passages that run on it and its configurations, each with the icon that uses it first."""

    name: str
    passages: list[tuple[Outline, Passage]] = field(default_factory=list)
    uses: dict[str, tuple[Outline, Passage, int]] = field(default_factory=dict)
    variables: frozenset[str] = frozenset()
    is_known: bool = True
    """Whether all its tasks are there, so that `variables` are all there are."""


def subsystems(nest: Nest, syntax: Syntax) -> dict[str, SharedSubsystem]:
    """The subsystems of an application by name: `flow0`, `flow1`, …

    The first flow of a nested parallel application runs where that stands, the others on `flow0.1` and so on; all
    flows of a nested conditional one run where that stands.
    """
    by_name: dict[str, SharedSubsystem] = {}
    seen: set[tuple[str, str, int]] = set()
    ways = [(f"flow{at}", nest.top, at) for at in reversed(range(len(nest.top.application.flows)))]
    while ways:
        way = ways.pop()
        name, outline, number = way
        if (name, outline.application.name, number) in seen:
            continue
        seen.add((name, outline.application.name, number))
        subsystem = by_name.setdefault(name, SharedSubsystem(name))
        inner = [
            way for passage in outline.of_flow(number) for way in _enter(subsystem, outline, passage, nest, syntax)
        ]
        ways += reversed(inner)
    return by_name


def faults(
    by_name: Mapping[str, SharedSubsystem],
    files: Mapping[str, Configuration],
    tasks: Mapping[str, Task],
    redirects: Sequence[Redirect] = (),
) -> Iterator[Fault]:
    """Conflicts among the tasks of each subsystem, and conditions on variables that none of them has."""
    for subsystem in by_name.values():
        configurations = crew(subsystem, files, tasks, redirects)
        used = list(configurations.values())
        own = union.tasks_of(used, all_relocated(tasks, world_choice(redirects, subsystem.name)))
        subsystem.variables = union.variables(own)
        placed = {placed.task for configuration in used for placed in configuration.placed}
        subsystem.is_known = len(used) == len(subsystem.uses) and placed <= tasks.keys()
        outline, passage = subsystem.passages[0]
        sources = _sources(subsystem, configurations)
        yield from union.conflicts(own, passage.named, outline.place(), sources)
    for subsystem in by_name.values():
        yield from _conditions(subsystem, by_name)


def crew(
    subsystem: SharedSubsystem,
    configurations: Mapping[str, Configuration],
    tasks: Mapping[str, Task],
    redirects: Sequence[Redirect],
) -> dict[str, Configuration]:
    """The configurations of a subsystem as far as they are there, with the tasks in them that stand for others."""
    chosen = choice(redirects, subsystem.name)
    own = {name: configurations[name] for name in subsystem.uses if name in configurations}
    return {name: redirected(configuration, chosen, tasks) for name, configuration in own.items()}


def _enter(
    subsystem: SharedSubsystem, outline: Outline, passage: Passage, nest: Nest, syntax: Syntax
) -> Iterator[tuple[str, Outline, int]]:
    """Take in a passage; gives the flows nested in it, each with the name of its subsystem."""
    subsystem.passages.append((outline, passage))
    for action in passage.actions:
        kind, name = syntax.acting(action.icon.onikon.type), action.icon.onikon.name
        inner = nest.runs(outline, action, syntax)
        if inner is not None:
            for number in range(len(inner.application.flows)):
                apart = f".{number}" if number and inner.application.is_parallel else ""
                yield subsystem.name + apart, inner, number
        elif kind and kind.is_job:
            subsystem.uses.setdefault(name, (outline, passage, action.position))


def _sources(subsystem: SharedSubsystem, configurations: Mapping[str, Configuration]) -> dict[str, union.TaskOrigin]:
    origins: dict[str, union.TaskOrigin] = {}
    for name, (outline, passage, position) in subsystem.uses.items():
        place = outline.place(passage.flow.steps[position])
        flow = outline.where(passage) if outline.is_nested or passage.is_inner else None
        for placed in configurations[name].placed if name in configurations else ():
            origins.setdefault(placed.task, union.TaskOrigin(place, name, position, flow))
    return origins


def _conditions(subsystem: SharedSubsystem, every: Mapping[str, SharedSubsystem]) -> Iterator[Fault]:
    for outline, passage in subsystem.passages:
        for position, step in enumerate(passage.flow.steps):
            given: tuple[str, ...] = ()
            if isinstance(step, Icon):
                given = tuple(filter(None, (step.marker_if, step.while_if)))
            elif isinstance(step, Branch):
                given = step.conditions
            for text in given:
                if reason := _condition(text, outline.at(passage, position), subsystem, every):
                    yield outline.fault(step, reason)


def _condition(text: str, at: Reason, subsystem: SharedSubsystem, every: Mapping[str, SharedSubsystem]) -> Reason:
    """What is wrong with a condition."""
    try:
        condition = Condition.parse(text)
    except ValueError:
        return Reason.of("rules.condition_form", text=text, at=at)
    *named, variable = condition.address.split("/")
    meant = every.get(named[0]) if named else subsystem
    if meant is None:
        return Reason.of("rules.condition_flow", subsystems=tuple(every), text=text, at=at)
    if meant.is_known and variable not in meant.variables:
        return Reason.of("rules.condition_variable", subsystem=meant.name, text=text, at=at)
    return NOTHING
