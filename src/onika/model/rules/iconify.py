"""Which type the icon of a configuration or an application has (requirement D09, reading 31, §5.6.2, §5.6.4)."""

from collections.abc import Mapping
from dataclasses import dataclass

from onika.model.application import Application
from onika.model.configuration import Configuration
from onika.model.rules import hole, shape
from onika.model.rules.outline import Outline
from onika.model.rules.union import tasks_of
from onika.model.syntax import COMPLETE_APPLICATION, COMPLETE_JOB, Syntax, application_name
from onika.model.task import Task
from onika.words.fault import Refusal
from onika.words.reason import Reason

_DEFINE_IT = Reason.of("rules.define_it")


@dataclass(frozen=True, slots=True)
class ActionType:
    """The type of an action and of the targets it takes beyond the one that this names."""

    type: str
    more_targets: tuple[str, ...] = ()


def job_type(
    configuration: Configuration, tasks: Mapping[str, Task], syntax: Syntax
) -> ActionType | tuple[Refusal, ...]:
    """The type of a job: that of the first of its tasks with OBJECT, else a complete one (reading 16, C29).

    A type that the syntax lacks is kept; the icon acts as a complete one (requirement D16).
    """
    if refusals := _incomplete(configuration, tasks):
        return refusals
    trigger = next((task for task in tasks_of([configuration], tasks) if task.object_type), None)
    if trigger is None or trigger.object_type is None:
        return ActionType(COMPLETE_JOB)
    object_type = syntax.find(trigger.object_type)
    if object_type is None:
        return ActionType(trigger.object_type, _more_targets(trigger, syntax))
    if refusals := _unknown_targets(trigger, syntax):
        return refusals
    return ActionType(object_type.name, _more_targets(trigger, syntax))


def _incomplete(configuration: Configuration, tasks: Mapping[str, Task]) -> tuple[Refusal, ...]:
    """Why a configuration is no job yet: it has no tasks, or some of them are missing."""
    if not configuration.placed:
        reason = Reason.of("rules.without_tasks", configuration=configuration.name)
        return (Refusal(reason, (Reason.of("rules.place_some"),)),)
    name = configuration.name
    missing = [placed.task for placed in configuration.placed if placed.task not in tasks]
    remedies = (Reason.of("rules.make_it"), Reason.of("rules.remove_from", configuration=name))
    reasons = (Reason.of("rules.task_lost", task=task, configuration=name) for task in missing)
    return tuple(Refusal(reason, remedies) for reason in reasons)


def _unknown_targets(trigger: Task, syntax: Syntax) -> tuple[Refusal, ...]:
    """A refusal for each further target of a trigger whose type is no target of the syntax."""
    unknown = (kind for kind in trigger.more_targets if not _is_target(kind, syntax))
    reasons = (Reason.of("rules.target_undefined", task=trigger.name, kind=kind) for kind in unknown)
    return tuple(Refusal(reason, (_DEFINE_IT,)) for reason in reasons)


def _is_target(kind: str, syntax: Syntax) -> bool:
    icon_type = syntax.find(kind)
    return icon_type is not None and icon_type.is_target


def _more_targets(trigger: Task, syntax: Syntax) -> tuple[str, ...]:
    """The types of the further targets of a trigger, as the syntax writes them where it knows them."""
    icon_types = [(kind, syntax.find(kind)) for kind in trigger.more_targets]
    return tuple(icon_type.name if icon_type else kind for kind, icon_type in icon_types)


def application_type(application: Application, syntax: Syntax) -> ActionType | tuple[Refusal, ...]:
    """The type of an application: complete without holes, else that of the targets its holes want.

    Refused where a hole wants an action, where the syntax has no type for it, and where it is not whole otherwise.
    """
    outline = Outline.of(application, syntax, application.name)
    refusals = [Refusal(fault.reason) for fault in shape.faults(outline, syntax)]
    for open_hole in hole.holes(outline, syntax):
        if not open_hole.types:
            at = outline.at(open_hole.passage, open_hole.position)
            reason = Reason.of("rules.hole_no_target", at=at)
            refusals.append(Refusal(reason, (Reason.of("rules.fill_with_action"),)))
    kinds = hole.open_types(outline, syntax)
    refusals += [_no_type(kind, syntax) for kind in kinds[:1] if not syntax.find(application_name(kind))]
    refusals += [_no_target(kind) for kind in kinds if not syntax.find(kind)]
    if refusals:
        return tuple(refusals)
    kind = syntax.find(application_name(kinds[0])) if kinds else None
    return ActionType(kind.name if kind else COMPLETE_APPLICATION, kinds[1:])


def _no_type(kind: str, syntax: Syntax) -> Refusal:
    partial_types = (kind for kind in syntax.types if kind.is_application and not kind.is_complete)
    names = tuple(icon_type.name for icon_type in partial_types)
    wanted = application_name(kind)
    if names:
        reason = Reason.of("rules.holes_untyped", kind=kind, type=wanted, names=names)
    else:
        reason = Reason.of("rules.holes_untyped_wholly", kind=kind, type=wanted)
    return Refusal(reason, (Reason.of("rules.fill_holes"), _DEFINE_IT))


def _no_target(kind: str) -> Refusal:
    return Refusal(Reason.of("rules.holes_undefined", kind=kind), (_DEFINE_IT,))
