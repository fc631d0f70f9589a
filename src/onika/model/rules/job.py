"""Checks the configurations behind jobs: whole, and of the type their icons say (requirement E01, reading 36)."""

from collections.abc import Iterator, Mapping
from itertools import combinations

from onika.model.application import Action, wanted_targets
from onika.model.configuration import Configuration
from onika.model.rules import placement
from onika.model.rules.outline import Outline, Passage
from onika.model.rules.union import tasks_of
from onika.model.syntax import Syntax, same_type
from onika.model.task import Task
from onika.words.fault import Fault
from onika.words.reason import Reason


def faults(
    outline: Outline,
    syntax: Syntax,
    configurations: Mapping[str, Configuration],
    tasks: Mapping[str, Task],
    unread: frozenset[str],
) -> Iterator[Fault]:
    """What is wrong with the jobs of an application; `unread` names what is there and at fault itself."""
    for passage, action in outline.actions():
        kind = syntax.acting(action.icon.onikon.type)
        name = action.icon.onikon.name
        if not kind or not kind.is_job:
            continue
        if configuration := configurations.get(name):
            yield from _type(outline, passage, action, configuration, syntax, tasks)
        elif name not in unread:
            at = outline.at(passage, action.position)
            yield outline.fault(action.icon, Reason.of("rules.configuration_missing", name=name, at=at))


def whole(
    configuration: Configuration, tasks: Mapping[str, Task], unread: frozenset[str], use: tuple[Outline, Passage, int]
) -> Iterator[Fault]:
    """Whether a configuration has tasks, which are there and may stand together, Equations (2) and (3).

    `use` is the icon that is named: where it is used first.
    """
    outline, passage, position = use
    icon, name = passage.flow.steps[position], configuration.name
    shown = Reason.of("rules.icon", name=name)
    at = Reason.of("rules.at", step=shown, position=position, flow=outline.where(passage))
    if not configuration.placed:
        yield outline.fault(icon, Reason.of("rules.configuration_empty", at=at))
    for placed in configuration.placed:
        if placed.task not in tasks and placed.task not in unread:
            yield outline.fault(icon, Reason.of("rules.task_missing", name=placed.task, at=at))
    for task, other in combinations(tasks_of([configuration], tasks), 2):
        for refusal in placement.refusals(other, [task]):
            yield outline.fault(icon, Reason.of("rules.tasks_clash", name=other.name, at=at, why=refusal.reason))


def _type(
    outline: Outline,
    passage: Passage,
    action: Action,
    configuration: Configuration,
    syntax: Syntax,
    tasks: Mapping[str, Task],
) -> Iterator[Fault]:
    """The type of an icon is that of its trigger, with all its targets; one of unknown type is not judged."""
    placed = tasks_of([configuration], tasks)
    trigger = next((task for task in placed if task.object_type), None)
    type_of_icon = syntax.find(action.icon.onikon.type)
    if type_of_icon is None:
        return
    at = outline.at(passage, action.position)
    if trigger is None:
        if type_of_icon.needs_target and len(placed) == len(configuration.placed):
            missing = Reason.of(
                "rules.trigger_missing", kind=type_of_icon.name, configuration=configuration.name, at=at
            )
            yield outline.fault(action.icon, missing)
        return
    wanted = syntax.find(trigger.object_type or "")
    if wanted is None:
        return
    has, needs = (
        wanted_targets(action.icon.onikon, syntax)[1:],
        tuple(_written(more_target, syntax) for more_target in trigger.more_targets),
    )
    is_alike = len(has) == len(needs) and all(map(same_type, has, needs))
    if wanted.name != type_of_icon.name or not is_alike:
        here, there = _shown(type_of_icon.name, has), _shown(wanted.name, needs)
        reason = Reason.of("rules.kind_of_trigger", wanted=there, trigger=trigger.name, kind=here, at=at)
        yield outline.fault(action.icon, reason)


def _written(name: str, syntax: Syntax) -> str:
    """A type as the syntax writes it, where it has it (reading 37)."""
    kind = syntax.find(name)
    return kind.name if kind else name


def _shown(name: str, more: tuple[str, ...]) -> Reason:
    if more:
        return Reason.of("rules.kind_with", kind=name, targets=more)
    return Reason.plain(name)
