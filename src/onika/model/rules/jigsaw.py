"""Which onikon may follow which, Equation (7), and what holes that opens and closes (dissertation §5.5.3, §5.5.4)."""

from onika.model.application import AppFlow, Hole, Icon, Step
from onika.model.syntax import END, START, IconType, Syntax
from onika.words.fault import Refusal


def fits(left: IconType, right: IconType) -> bool:
    """Equation (7): L(T(b)) = R(T(a)), the left edge of `right` is the right edge of `left`."""
    return right.left_edge == left.right_edge


def refusals(flow: AppFlow, after: int, icon: Icon, syntax: Syntax) -> tuple[Refusal, ...]:
    """Why `icon` may not be inserted behind step `after` (-1: the start icon); empty: it may.

    A hole stands for its left neighbour (decision 33). Raises IndexError where there is no such step.
    """
    left, right = _type_at(flow, _solid(flow, after), syntax), syntax.acting(icon.onikon.type)
    if right is None or not (right.is_action or right.is_target):
        return (Refusal(f"`{icon.onikon.name}` is of the type {icon.onikon.type}, which stands in no flow"),)
    if left is None or fits(left, right):
        return ()
    fitting = tuple(f"insert a {kind.name}" for kind in syntax.types if _stands_in_flow(kind) and fits(left, kind))
    return (Refusal(f"a {right.name} does not fit behind a {left.name}", fitting),)


def insert(flow: AppFlow, after: int, icon: Icon, syntax: Syntax) -> AppFlow:
    """The flow with `icon` behind step `after`; it fills the hole there, or leaves or opens one where the next
    icon does not fit (requirements D03, D19). Raises ValueError where `refusals` has reasons."""
    reasons = refusals(flow, after, icon, syntax)
    if reasons:
        raise ValueError(f"expected an icon that fits, found: {reasons[0]}")
    at = _solid(flow, after) + 1
    return _joined((*flow.steps[:at], icon), flow.steps[at:], syntax)


def delete(flow: AppFlow, position: int, syntax: Syntax) -> AppFlow:
    """The flow without the icon at `position`; a hole opens or closes by Equation (7). Raises ValueError for a hole."""
    if isinstance(flow.steps[position], Hole):
        raise ValueError(f"expected the position of an icon, found the hole at {position}")
    return _joined(flow.steps[:position], flow.steps[position + 1 :], syntax)


def misfits(flow: AppFlow, syntax: Syntax) -> tuple[int, ...]:
    """The positions whose icon does not fit the icon before it; the end icon's position is the number of steps.

    Holes fit everything, and so do icons of unknown type.
    """
    positions = range(len(flow.steps) + 1)
    return tuple(at for at in positions if not _fits_at(flow, at, syntax))


def _fits_at(flow: AppFlow, position: int, syntax: Syntax) -> bool:
    left, right = _type_at(flow, position - 1, syntax), _type_at(flow, position, syntax)
    return left is None or right is None or fits(left, right)


def _type_at(flow: AppFlow, position: int, syntax: Syntax) -> IconType | None:
    """The type at a position, start and end icon included; None for holes and unknown types."""
    if position < 0:
        return syntax.find(START)
    if position == len(flow.steps):
        return syntax.find(END)
    step = flow.steps[position]
    return syntax.acting(step.onikon.type) if isinstance(step, Icon) else None


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


def _stands_in_flow(kind: IconType) -> bool:
    return (kind.is_action or kind.is_target) and not (kind.is_start or kind.is_end)
