"""Which onikon may follow which, Equation (7), and what holes that opens and closes (dissertation §5.5.3, §5.5.4).

Behind a target that is not the last one of its action stands the next one, whatever the edge of its own type; a branch
has the edges of a no-op outside, and start and end icons in each of its flows (requirement D13).
"""

from dataclasses import replace
from itertools import pairwise

from onika.model.application import Action, AppFlow, Branch, Hole, Icon, Step, actions, is_target, wanted_targets
from onika.model.syntax import COMPLETE_NOP, END, START, IconType, Syntax
from onika.words.fault import Refusal

_Kinds = list[IconType | None]
"""The types of a flow's steps between those of its start and end icon; None fits everything."""


def fits(left: IconType, right: IconType) -> bool:
    """Equation (7): L(T(b)) = R(T(a)), the left edge of `right` is the right edge of `left`."""
    return right.left_edge == left.right_edge


def refusals(flow: AppFlow, after: int, step: Icon | Branch, syntax: Syntax) -> tuple[Refusal, ...]:
    """Why `step` may not be inserted behind step `after` (-1: the start icon); empty: it may.

    A hole stands for its left neighbour (decision 33). Raises IndexError where there is no such step.
    """
    left, right = _kinds(flow, syntax)[_solid(flow, after) + 1], _kind(step, syntax)
    if isinstance(step, Icon) and (right is None or not (right.is_action or right.is_target)):
        return (Refusal(f"`{step.onikon.name}` is of the type {step.onikon.type}, which stands in no flow"),)
    if left is None or right is None or fits(left, right):
        return ()
    fitting = tuple(f"insert a {kind.name}" for kind in syntax.types if _stands_in_flow(kind) and fits(left, kind))
    shown = right.name if isinstance(step, Icon) else "branch"
    return (Refusal(f"a {shown} does not fit behind a {left.name}", fitting),)


def insert(flow: AppFlow, after: int, step: Icon | Branch, syntax: Syntax) -> AppFlow:
    """The flow with `step` behind step `after`; it fills the hole there, or leaves or opens one where the next
    icon does not fit (requirements D03, D19). Raises ValueError where `refusals` has reasons."""
    reasons = refusals(flow, after, step, syntax)
    if reasons:
        raise ValueError(f"expected an icon that fits, found: {reasons[0]}")
    at = _solid(flow, after) + 1
    joined = _joined((*flow.steps[:at], step), flow.steps[at:], syntax)
    return _settled(joined, at + 1, syntax, was_several=_several(flow, at, syntax) is not None)


def delete(flow: AppFlow, position: int, syntax: Syntax) -> AppFlow:
    """The flow without the icon at `position`; a hole opens or closes by Equation (7). Raises ValueError for a hole."""
    if isinstance(flow.steps[position], Hole):
        raise ValueError(f"expected the position of an icon, found the hole at {position}")
    joined = _joined(flow.steps[:position], flow.steps[position + 1 :], syntax)
    seam = _solid(flow, position - 1) + 1
    return _settled(joined, seam, syntax, was_several=_several(flow, position + 1, syntax) is not None)


def misfits(flow: AppFlow, syntax: Syntax) -> tuple[int, ...]:
    """The positions whose icon does not fit the icon before it; the end icon's position is the number of steps.

    Holes fit everything, and so do icons of unknown type. Flows of branches are not looked into.
    """
    pairs = enumerate(pairwise(_kinds(flow, syntax)))
    return tuple(at for at, (left, right) in pairs if left and right and not fits(left, right))


def _fits_at(flow: AppFlow, position: int, syntax: Syntax) -> bool:
    left, right = _kinds(flow, syntax)[position : position + 2]
    return left is None or right is None or fits(left, right)


def _kinds(flow: AppFlow, syntax: Syntax) -> _Kinds:
    kinds = [syntax.find(START), *(_kind(step, syntax) for step in flow.steps), syntax.find(END)]
    for action in actions(flow, syntax):
        following = wanted_targets(action.icon.onikon, syntax)[1:]
        for position, wanted in zip(action.positions, following, strict=False):
            kind, after = kinds[position + 1], syntax.find(wanted)
            if kind:
                kinds[position + 1] = replace(kind, right_edge=after.left_edge) if after else None
    return kinds


def _kind(step: Step, syntax: Syntax) -> IconType | None:
    if isinstance(step, Icon):
        return syntax.acting(step.onikon.type)
    return syntax.find(COMPLETE_NOP) if isinstance(step, Branch) else None


def _solid(flow: AppFlow, position: int) -> int:
    """The nearest icon at or left of a position; -1 is the start icon."""
    while position >= 0 and isinstance(flow.steps[position], Hole):
        position -= 1
    return position


def _joined(left: tuple[Step, ...], right: tuple[Step, ...], syntax: Syntax) -> AppFlow:
    """Two parts of a flow with a hole between them exactly where their icons do not fit; one that was there stays."""
    gap = Hole()
    while left and isinstance(left[-1], Hole):
        gap, left = left[-1], left[:-1]
    while right and isinstance(right[0], Hole):
        gap, right = right[0] if not gap.kept else gap, right[1:]
    whole = AppFlow(left + right)
    return whole if _fits_at(whole, len(left), syntax) else AppFlow((*left, gap, *right))


def _settled(flow: AppFlow, seam: int, syntax: Syntax, *, was_several: bool) -> AppFlow:
    """Where the seam lies in an action of several targets, or did, their edges are others now: holes are found anew."""
    action = _several(flow, seam, syntax)
    if action is None and not was_several:
        return flow
    start = seam if action is None else action.position + 1
    return _found_anew(flow, start, syntax)


def _several(flow: AppFlow, seam: int, syntax: Syntax) -> Action | None:
    """The action of several targets that has a step before `seam` and may have one behind."""
    for action in actions(flow, syntax):
        if action.position < seam <= action.end and len(wanted_targets(action.icon.onikon, syntax)) > 1:
            return action
    return None


def _found_anew(flow: AppFlow, start: int, syntax: Syntax) -> AppFlow:
    """A flow with holes exactly where they must be from `start` to behind the last target that follows there.

    Holes with something in them stay as long as there is a hole.
    """
    end = start
    while end < len(flow.steps) and _may_be_targets(flow.steps[end], syntax):
        end += 1
    kept = [step for step in flow.steps[start:end] if isinstance(step, Hole) and step.kept]
    steps = flow.steps[:start]
    for step in (*(one for one in flow.steps[start:end] if not isinstance(one, Hole)), *flow.steps[end : end + 1]):
        if not _fits_at(AppFlow((*steps, step)), len(steps), syntax):
            steps += (kept.pop(0) if kept else Hole(),)
        steps += (step,)
    rest = flow.steps[end + 1 :]
    if end >= len(flow.steps) and not _fits_at(AppFlow(steps), len(steps), syntax):
        steps += (kept.pop(0) if kept else Hole(),)
    return AppFlow(steps + rest)


def _may_be_targets(step: Step, syntax: Syntax) -> bool:
    return isinstance(step, Hole) or (isinstance(step, Icon) and is_target(step, syntax))


def _stands_in_flow(kind: IconType) -> bool:
    return (kind.is_action or kind.is_target) and not (kind.is_start or kind.is_end)
