"""Which onikon may follow which, Equation (7), and what holes that opens and closes (dissertation §5.5.3, §5.5.4).

Behind a target that is not the last one of its action stands the next one, whatever the edge of its own type; a branch
has the edges of a no-op outside, and start and end icons in each of its flows (requirement D13).
"""

from collections.abc import Collection, Sequence
from itertools import pairwise

from onika.model.application import AppFlow, Hole, Icon, Step
from onika.model.rules.gap import Row, Solid, either, kind_at, kind_of, kinds
from onika.model.syntax import IconType, Syntax
from onika.words.fault import Refusal
from onika.words.reason import Reason


def fits(left: IconType, right: IconType) -> bool:
    """Equation (7): L(T(b)) = R(T(a)), the left edge of `right` is the right edge of `left`."""
    return right.left_edge == left.right_edge


def refusals(flow: AppFlow, after: int, step: Solid, syntax: Syntax) -> tuple[Refusal, ...]:
    """Why `step` may not be inserted behind step `after` (-1: the start icon); empty: it may.

    A hole stands for its left neighbour (reading 33). Raises IndexError where there is no such step.
    """
    left, right = kind_at(flow, solid_at(flow, after), syntax), kind_of(step, syntax)
    if isinstance(step, Icon) and (right is None or not stands_in_flow(right)):
        return (Refusal(Reason.of("rules.stands_in_no_flow", name=step.onikon.name, kind=step.onikon.type)),)
    if left is None or right is None or fits(left, right):
        return ()
    fitting = (kind.name for kind in syntax.types if stands_in_flow(kind) and fits(left, kind))
    inserting = tuple(Reason.of("rules.insert", kind=name) for name in fitting)
    if isinstance(step, Icon):
        return (Refusal(Reason.of("rules.kind_not_behind", kind=right.name, left=left.name), inserting),)
    return (Refusal(Reason.of("rules.branch_not_behind", left=left.name), inserting),)


def insert(flow: AppFlow, after: int, step: Solid, syntax: Syntax) -> AppFlow:
    """The flow with `step` behind step `after`; it fills the hole there, or leaves or opens one where the next
    icon does not fit (requirements D03, D19). Raises ValueError where `refusals` has reasons."""
    return insert_all(flow, after, (step,), syntax)


def insert_all(flow: AppFlow, after: int, steps: Sequence[Step], syntax: Syntax) -> AppFlow:
    """The flow with several steps behind step `after`, and holes between those that do not fit each other.

    Raises ValueError where the first of them does not fit, and where there is none but holes.
    """
    new = Row.of(AppFlow(tuple(steps)))
    if not new.solids:
        raise ValueError(Reason.of("rules.not_insertable", why=Reason.of("rules.only_holes")))
    reasons = refusals(flow, after, new.solids[0], syntax)
    if reasons:
        raise ValueError(Reason.of("rules.not_insertable", why=reasons[0].sentence))
    row, at = Row.of(flow), _solids(flow, solid_at(flow, after) + 1)
    behind = at + len(new.solids)
    last = either(new.gaps[-1], row.gaps[at]) if new.gaps[-1] and new.gaps[-1].kept else row.gaps[at]
    row.solids[at:at] = new.solids
    row.gaps[at : at + 1] = [None, *new.gaps[1:-1], last]
    return row.mended(range(at, behind + 1), syntax, filled=(behind,))


def delete(flow: AppFlow, position: int, syntax: Syntax) -> AppFlow:
    """The flow without the icon at `position`; a hole opens or closes by Equation (7). Raises ValueError for a hole."""
    if isinstance(flow.steps[position], Hole):
        raise ValueError(f"expected the position of an icon, found the hole at {position}")
    return take_out(flow, {position}, syntax)


def take_out(flow: AppFlow, positions: Collection[int], syntax: Syntax) -> AppFlow:
    """The flow without the steps at these positions; holes open and close by Equation (7).

    A hole among them loses what it keeps, and is there still where it must be.
    """
    row, left = Row.of(flow), Row([], [None])
    touched: set[int] = set()
    holes = {_solids(flow, at) for at in positions if isinstance(flow.steps[at], Hole)}
    gone = {_solids(flow, at) for at in positions if not isinstance(flow.steps[at], Hole)}
    for at, gap in enumerate(row.gaps):
        left.gaps[-1] = either(left.gaps[-1], Hole(gap.line, number=gap.number) if gap and at in holes else gap)
        if at in holes or at in gone:
            touched.add(len(left.solids))
        if at < len(row.solids) and at not in gone:
            left.solids.append(row.solids[at])
            left.gaps.append(None)
    return left.mended(touched, syntax)


def exchange(flow: AppFlow, position: int, step: Solid, syntax: Syntax) -> AppFlow:
    """The flow with `step` in place of the icon at `position`; holes open and close by Equation (7).

    Raises ValueError for a hole, which is filled by `insert`.
    """
    if isinstance(flow.steps[position], Hole):
        raise ValueError(f"expected the position of an icon, found the hole at {position}")
    row, at = Row.of(flow), _solids(flow, position)
    row.solids[at] = step
    return row.mended((at, at + 1), syntax)


def misfits(flow: AppFlow, syntax: Syntax) -> tuple[int, ...]:
    """The positions whose icon does not fit the icon before it; the end icon's position is the number of steps.

    Holes fit everything, and so do icons of unknown type. Flows of branches are not looked into.
    """
    pairs = enumerate(pairwise(kinds(flow, syntax)))
    return tuple(at for at, (left, right) in pairs if left and right and not fits(left, right))


def solid_at(flow: AppFlow, position: int) -> int:
    """The nearest icon at or left of a position; -1 is the start icon."""
    while position >= 0 and isinstance(flow.steps[position], Hole):
        position -= 1
    return position


def stands_in_flow(kind: IconType) -> bool:
    """Whether icons of a type can be inserted."""
    return (kind.is_action or kind.is_target) and not (kind.is_start or kind.is_end)


def _solids(flow: AppFlow, position: int) -> int:
    """How many icons and branches stand before a position."""
    return sum(not isinstance(step, Hole) for step in flow.steps[:position])
