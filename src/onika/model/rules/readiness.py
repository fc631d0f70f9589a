"""Whether an application can be run: every fault at once with its place (requirement E01, dissertation §5.9.2)."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from onika.model.application import Application
from onika.model.configuration import Configuration
from onika.model.redirect import Redirect
from onika.model.rules import endless, hole, job, loop, nesting, shape, subsystem, tag
from onika.model.rules.nesting import Nest
from onika.model.rules.outline import Outline
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.words.fault import Fault, Place


@dataclass(frozen=True, slots=True)
class _Laboratory:
    """What the icons of an application stand for."""

    syntax: Syntax
    configurations: Mapping[str, Configuration]
    tasks: Mapping[str, Task]
    unread: frozenset[str]


def faults(
    application: Application,
    syntax: Syntax,
    configurations: Mapping[str, Configuration],
    tasks: Mapping[str, Task],
    place: Place,
    *,
    applications: Mapping[str, Application] | None = None,
    files: Mapping[str, str] | None = None,
    unread: frozenset[str] = frozenset(),
    redirects: Sequence[Redirect] = (),
) -> tuple[Fault, ...]:
    """Everything that keeps `application` from running, and notes; none but notes: it can.

    `configurations`, `tasks` and `applications`, those that nested icons run, hold what was found, by name; `files`
    gives the files of these applications. `unread` names what is there and at fault, as is told elsewhere. What lives
    together is judged with the tasks that `redirects` put in place of others.
    """
    laboratory = _Laboratory(syntax, configurations, tasks, unread)
    nest = nesting.nest(Outline.of(application, syntax, place.file), syntax, applications or {}, files or {})
    faults = list(nest.faults)
    names = unread | {*(applications or {}), application.name}
    for outline in reversed(nest.outlines.values()):
        faults += _alone(outline, names, laboratory)
        faults += _fillings(outline, nest, syntax)
    faults += endless.faults(nest, syntax)
    if not nest.is_too_much:
        faults += _together(nest, laboratory, redirects)
    return tuple(dict.fromkeys(faults))


def _alone(outline: Outline, names: frozenset[str], laboratory: _Laboratory) -> Iterator[Fault]:
    """One application by itself, and what its icons run."""
    syntax = laboratory.syntax
    yield from hole.faults(outline, syntax)
    yield from shape.faults(outline, syntax)
    for passage in outline.passages:
        yield from loop.faults(passage.flow, syntax, outline.where(passage), outline.place(), passage.actions)
    yield from tag.faults(outline)
    yield from nesting.missing(outline, syntax, names)
    yield from job.faults(outline, syntax, laboratory.configurations, laboratory.tasks, laboratory.unread)


def _fillings(outline: Outline, nest: Nest, syntax: Syntax) -> Iterator[Fault]:
    for passage, action in outline.actions():
        inner = nest.runs(outline, action, syntax)
        if inner is not None:
            yield from hole.fillings(outline, inner, (passage, action), syntax)


def _together(nest: Nest, laboratory: _Laboratory, redirects: Sequence[Redirect]) -> Iterator[Fault]:
    """The configurations, each where it is used first, and what lives in one subsystem."""
    subsystems = subsystem.subsystems(nest, laboratory.syntax)
    judged: set[Configuration] = set()
    for shared in subsystems.values():
        living = subsystem.crew(shared, laboratory.configurations, laboratory.tasks, redirects)
        for name, configuration in living.items():
            if configuration not in judged:
                judged.add(configuration)
                yield from job.whole(configuration, laboratory.tasks, laboratory.unread, shared.uses[name])
    yield from subsystem.faults(subsystems, laboratory.configurations, laboratory.tasks, redirects)
