"""What stands between the icons of a flow: a hole exactly where two neighbours do not fit (dissertation §5.5.3).

A flow is taken apart into what stands in it and the gaps between; whoever changes it says which gaps that touched.
"""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace

from onika.model.application import Action, AppFlow, Branch, Hole, Icon, Step, actions, is_target, wanted_targets
from onika.model.syntax import COMPLETE_NOP, END, START, IconType, Syntax

Solid = Icon | Branch

_Kinds = list[IconType | None]
"""The types of a flow's steps between those of its start and end icon; None fits everything."""


@dataclass(slots=True)
class Row:
    """What stands in a flow, and the gap before each of it and before the end icon: a hole, or nothing."""

    solids: list[Solid]
    gaps: list[Hole | None]

    @classmethod
    def of(cls, flow: AppFlow) -> "Row":
        """A flow taken apart; several holes beside each other are one."""
        row = cls([], [None])
        for step in flow.steps:
            if isinstance(step, Hole):
                row.gaps[-1] = either(row.gaps[-1], step)
            else:
                row.solids.append(step)
                row.gaps.append(None)
        return row

    def mended(self, touched: Iterable[int], syntax: Syntax, filled: Collection[int] = ()) -> AppFlow:
        """The flow again; of the gaps that were touched, and those of the targets beside them, holes are found anew.

        A hole that keeps lines of its own stays, unless it is `filled` and what fills it fits.
        """
        wanted = self._spread(touched, syntax)
        steps: list[Step] = []
        owner = 0  # where the action begins to which the next step may belong
        for at, gap in enumerate(self.gaps):
            solid = self.solids[at] if at < len(self.solids) else None
            hole = gap
            if at in wanted and not (gap and gap.kept and at not in filled):
                hole = None if _is_joint(steps[owner:], solid, syntax) else gap or Hole()
            steps += [hole] if hole else []
            if solid is not None:
                owner = owner if isinstance(solid, Icon) and is_target(solid, syntax) else len(steps)
                steps.append(solid)
        return AppFlow(tuple(steps))

    def _spread(self, touched: Iterable[int], syntax: Syntax) -> set[int]:
        """With the gaps of all targets beside: whose turn each is may be another now (requirement D13)."""
        places: set[int] = set()
        for at in touched:
            start = end = at
            while start > 0 and self._is_target(start - 1, syntax):
                start -= 1
            while end < len(self.solids) and self._is_target(end, syntax):
                end += 1
            places.update(range(start, end + 1))
        return places

    def _is_target(self, at: int, syntax: Syntax) -> bool:
        solid = self.solids[at]
        return isinstance(solid, Icon) and is_target(solid, syntax)


def either(hole: Hole | None, other: Hole | None) -> Hole | None:
    """Of two holes that come together the one that keeps something, else the first; of two that do, both."""
    if hole is None or other is None:
        return hole or other
    if hole.kept and other.kept:
        return replace(hole, kept=hole.kept + other.kept)
    return other if other.kept else hole


def kinds(flow: AppFlow, syntax: Syntax, every: Sequence[Action] | None = None) -> _Kinds:
    """The types of start icon, steps and end icon, with the edges that they have where they stand.

    `every` are the actions of the flow, where they are known already.
    """
    icon_types = [syntax.find(START), *(kind_of(step, syntax) for step in flow.steps), syntax.find(END)]
    for action in actions(flow, syntax) if every is None else every:
        if len(action.icon.onikon.more_targets) == 0:
            continue
        following = wanted_targets(action.icon.onikon, syntax)[1:]
        for position, wanted in zip(action.positions, following, strict=False):
            kind, after = icon_types[position + 1], syntax.find(wanted)
            if kind:
                icon_types[position + 1] = replace(kind, right_edge=after.left_edge) if after else None
    return icon_types


def kind_of(step: Step, syntax: Syntax) -> IconType | None:
    """The type that a step acts as; None for a hole and for an unknown target."""
    if isinstance(step, Icon):
        return syntax.acting(step.onikon.type)
    if isinstance(step, Branch):
        return syntax.find(COMPLETE_NOP)
    return None


def kind_at(flow: AppFlow, position: int, syntax: Syntax) -> IconType | None:
    """The type of one step as it stands there; -1 is the start icon."""
    start = position
    while start > 0 and not begins(flow.steps[start], syntax):
        start -= 1
    return kinds(AppFlow(flow.steps[max(start, 0) : position + 1]), syntax)[-2]


def begins(step: Step, syntax: Syntax) -> bool:
    """Whether no action before a step has to do with it."""
    return not (isinstance(step, Hole) or (isinstance(step, Icon) and is_target(step, syntax)))


def _is_joint(before: list[Step], solid: Solid | None, syntax: Syntax) -> bool:
    """Whether a step, or the end icon, fits behind these steps; without any, behind the start icon."""
    flow = AppFlow((*before, solid) if solid is not None else tuple(before))
    left, right = kinds(flow, syntax)[len(before) : len(before) + 2]
    return left is None or right is None or left.right_edge == right.left_edge
