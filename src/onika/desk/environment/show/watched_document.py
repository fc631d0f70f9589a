"""A document that looks into a running application, with what is known there of its tasks (requirements C15, E11)."""

from collections.abc import Mapping
from dataclasses import replace

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts, TaskFacts
from onika.desk.environment.state.model import Model
from onika.model.configuration import name_within
from onika.wire.view import LivingTaskView, SubsystemView


def stand_ins(model: Model, subsystem: str) -> tuple[tuple[str, str], ...]:
    """Who stands for whom in a redirected flow of the run that goes on here: the task that is named, and the other."""
    flows = [flow for run in model.every_run for flow in run.plan.flows if flow.subsystem == subsystem]
    return tuple((old.name, name) for flow in flows for name, old in flow.replaced)


def in_run(
    document: Document, subsystem: SubsystemView, holder: str, me: str, substitutes: tuple[tuple[str, str], ...]
) -> Document:
    """As it is shown while it looks into a run; only for the eye, nothing is asked of the runtime for it."""
    if document.watched is None:
        return document
    facts = {name: _facts(task) for name, task in subsystem.tasks.items()}
    facts |= {old: facts[name] for old, name in substitutes if name in facts}
    return replace(
        document, live=SubsystemFacts(document.watched.subsystem, "live", _placed(document, facts), holder, me=me)
    )


def _placed(document: Document, facts: Mapping[str, TaskFacts]) -> dict[str, TaskFacts]:
    names = {name: _name_in_run(name, document.name, facts) for name in document.content.names}
    return {name: facts[other] for name, other in names.items() if other in facts}


def _name_in_run(task: str, configuration: str, facts: Mapping[str, TaskFacts]) -> str:
    """By which name a run has a task of a configuration."""
    own = name_within(task, configuration)
    return own if own in facts else task


def _facts(task: LivingTaskView) -> TaskFacts:
    return TaskFacts(task.state, task.note, task.rtpu, task.hz or None)
