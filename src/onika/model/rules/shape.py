"""The shape of an application: its types, pairs of action and target, and edges (requirement E01, §5.5.3)."""

from collections.abc import Iterator

from onika.model.application import AppFlow, Branch, Icon, is_target, wanted_targets
from onika.model.rules import jigsaw
from onika.model.rules.outline import Outline, Passage
from onika.model.syntax import END, START, Syntax
from onika.words.fault import Fault


def faults(outline: Outline, syntax: Syntax) -> Iterator[Fault]:
    """What is wrong with the steps of every flow, beside its holes."""
    if not outline.application.flows:
        yield outline.fault(None, "at least one flow", "none")
    for passage in outline.passages:
        if not passage.flow.steps:
            if not passage.is_inner:  # a branch may do nothing
                yield outline.fault(None, f"an action in {outline.where(passage)}", "none")
            continue
        yield from _types(outline, passage, syntax)
        yield from _pairs(outline, passage, syntax)
        yield from _edges(outline, passage, syntax)


def _types(outline: Outline, passage: Passage, syntax: Syntax) -> Iterator[Fault]:
    for position, step in enumerate(passage.flow.steps):
        if isinstance(step, Icon) and syntax.acting(step.onikon.type) is None:
            found = f"{step.onikon.type} of {outline.at(passage, position)}"
            yield outline.fault(step, "a type the syntax defines", found)
        if isinstance(step, Branch) and step.conditions and len(step.conditions) != len(step.flows) - 1:
            found = f"{len(step.conditions)} at {outline.at(passage, position)}"
            yield outline.fault(step, f"{len(step.flows) - 1} conditions of a branch, or none", found)


def _pairs(outline: Outline, passage: Passage, syntax: Syntax) -> Iterator[Fault]:
    """Its targets behind every action, and nowhere else."""
    used: set[int] = set()
    for action in passage.actions:
        used.update(action.positions)
        for missing in wanted_targets(action.icon.onikon, syntax)[len(action.targets) :]:
            found = f"none behind {outline.at(passage, action.position)}"
            yield outline.fault(action.icon, f"a {missing} behind it", found)
    for position, step in enumerate(passage.flow.steps):
        if isinstance(step, Icon) and position not in used and is_target(step, syntax):
            found = f"none before {outline.at(passage, position)}"
            yield outline.fault(step, "an action that takes this target", found)


def _edges(outline: Outline, passage: Passage, syntax: Syntax) -> Iterator[Fault]:
    steps = passage.flow.steps
    for position in jigsaw.misfits(passage.flow, syntax):
        left, right = _name(passage.flow, position - 1), _name(passage.flow, position)
        found = f"{right} behind {left}, at step {position} of {outline.where(passage)}"
        yield outline.fault(steps[min(position, len(steps) - 1)], "edges that fit", found)


def _name(flow: AppFlow, position: int) -> str:
    if position < 0:
        return START
    if position == len(flow.steps):
        return END
    step = flow.steps[position]
    return f"`{step.onikon.name}` ({step.onikon.type})" if isinstance(step, Icon) else "a branch"
