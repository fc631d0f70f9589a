"""Whether an application can be run (E01), read a second time with the naive rules of tasks and onikons.

Written from §5.9.2, E01, D16, D22 and readings 1, 23, 33 and 36 and law 10.
"""

from collections.abc import Mapping

from onika.model.application import AppFlow, Application, Icon
from onika.model.configuration import Configuration
from onika.model.task import Task

from . import onikons, tasks
from .onikons import Edges, Line


def is_ready(
    application: Application, edges: Edges, configurations: Mapping[str, Configuration], existing: Mapping[str, Task]
) -> bool:
    """No nested applications here."""
    return bool(application.flows) and all(
        _is_ready(flow, edges, configurations, existing) for flow in application.flows
    )


def _is_ready(
    flow: AppFlow, edges: Edges, configurations: Mapping[str, Configuration], existing: Mapping[str, Task]
) -> bool:
    line: Line = [step.onikon.type if isinstance(step, Icon) else None for step in flow.steps]
    if not line or not onikons.is_whole(line, edges) or not _pairs_are_right(line, edges):
        return False
    tags = {at: step.while_tag for at, step in enumerate(flow.steps) if isinstance(step, Icon) and step.while_tag}
    tests = {at: step.while_test for at, step in enumerate(flow.steps) if isinstance(step, Icon)}
    if not onikons.loops_are_well_formed(onikons.actions(line, edges), tags, tests):
        return False
    if not onikons.loops_take_time(onikons.actions(line, edges), line, tags, tests):
        return False
    union: dict[str, Task] = {}
    for step in flow.steps:
        kind = step.onikon.type if isinstance(step, Icon) else ""
        if "job" not in onikons.words(kind) or not isinstance(step, Icon):
            continue
        configuration = configurations.get(step.onikon.name)
        if configuration is None or not configuration.placed:
            return False
        if any(placed.task not in existing for placed in configuration.placed):
            return False
        together = [existing[placed.task] for placed in configuration.placed]
        if not tasks.configuration_is_free(together) or not _has_its_type(kind, together, edges):
            return False
        union.update({task.name: task for task in together})
    given = set().union(*(tasks.writes_at_init(task) for task in union.values()))
    needed = set().union(*(tasks.named(task, "INCONST") for task in union.values()))
    return tasks.union_is_free(union.values()) and needed <= given


def _pairs_are_right(line: Line, edges: Edges) -> bool:
    """A target behind every action that takes one, and nowhere else."""
    groups = onikons.actions(line, edges)
    targets = {at for at, kind in enumerate(line) if kind is not None and onikons.is_target(kind)}
    taken = {group[1] for group in groups if len(group) == 2}
    lonely = [group for group in groups if len(group) == 1 and onikons.needs_target(line[group[0]] or "", edges)]
    return not lonely and targets == taken


def _has_its_type(kind: str, together: list[Task], edges: Edges) -> bool:
    """The icon's type is that of the first trigger with a target (reading 36, C29); an unknown one is not judged."""
    if kind.lower() not in edges:
        return True
    types = [task.object_type.lower() for task in together if task.object_type]
    if not types:
        return "complete" in onikons.words(kind)
    return types[0] == kind.lower()
