"""The shape of an application: its types, pairs of action and target, and edges (requirement E01, §5.5.3)."""

from collections.abc import Iterator, Sequence

from onika.model.application import Branch, Icon, Step, is_target, wanted_targets
from onika.model.rules import jigsaw
from onika.model.rules.outline import Outline, Passage
from onika.model.syntax import Syntax
from onika.words.fault import Fault
from onika.words.reason import Reason


def faults(outline: Outline, syntax: Syntax) -> Iterator[Fault]:
    """What is wrong with the steps of every flow, beside its holes."""
    if not outline.application.flows:
        yield outline.fault(None, Reason.of("rules.no_flow"))
    for passage in outline.passages:
        if not passage.flow.steps:
            if not passage.is_inner:  # a branch may do nothing
                yield outline.fault(None, Reason.of("rules.flow_empty", flow=outline.where(passage)))
            continue
        yield from _types(outline, passage, syntax)
        yield from _pairs(outline, passage, syntax)
        yield from _edges(outline, passage, syntax)


def _types(outline: Outline, passage: Passage, syntax: Syntax) -> Iterator[Fault]:
    for position, step in enumerate(passage.flow.steps):
        if isinstance(step, Icon) and syntax.acting(step.onikon.type) is None:
            at = outline.at(passage, position)
            yield outline.fault(step, Reason.of("rules.kind_unknown", kind=step.onikon.type, at=at))
        if isinstance(step, Branch) and step.conditions and len(step.conditions) != len(step.flows) - 1:
            at, count, given = outline.at(passage, position), len(step.flows) - 1, len(step.conditions)
            yield outline.fault(step, Reason.of("rules.condition_count", count=count, given=given, at=at))


def _pairs(outline: Outline, passage: Passage, syntax: Syntax) -> Iterator[Fault]:
    """Its targets behind every action, and nowhere else."""
    used: set[int] = set()
    for action in passage.actions:
        used.update(action.positions)
        for missing in wanted_targets(action.icon.onikon, syntax)[len(action.targets) :]:
            at = outline.at(passage, action.position)
            yield outline.fault(action.icon, Reason.of("rules.target_missing", kind=missing, at=at))
    for position, step in enumerate(passage.flow.steps):
        if isinstance(step, Icon) and position not in used and is_target(step, syntax):
            yield outline.fault(step, Reason.of("rules.action_missing", at=outline.at(passage, position)))


def _edges(outline: Outline, passage: Passage, syntax: Syntax) -> Iterator[Fault]:
    steps = passage.flow.steps
    for position in jigsaw.misfits(passage.flow, syntax):
        reason = _misfit(steps, position, outline.where(passage))
        yield outline.fault(steps[min(position, len(steps) - 1)], reason)


def _misfit(steps: Sequence[Step], position: int, flow: Reason) -> Reason:
    """Why the step at a position, or the end of the flow, does not fit behind what is before it."""
    if position == 0:
        return Reason.of("rules.start_unfit", right=_named(steps[0]), position=position, flow=flow)
    left = _named(steps[position - 1])
    if position == len(steps):
        return Reason.of("rules.end_unfit", left=left, position=position, flow=flow)
    return Reason.of("rules.edges_unfit", left=left, right=_named(steps[position]), position=position, flow=flow)


def _named(step: Step) -> Reason:
    if isinstance(step, Icon):
        return Reason.of("rules.icon_of_kind", name=step.onikon.name, kind=step.onikon.type)
    return Reason.of("rules.branch")
