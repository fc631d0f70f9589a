"""The steps of a flow as a page is shown them, with the edges that they have where they stand (requirements D03, D13).

The right edge of a target that is not the last one of its action is the left one of the next (D13); a hole has those
of its neighbours; a branch those of a no-op.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from onika.desk.environment.outcome.on_file import syntax_of
from onika.desk.environment.state import target_values
from onika.desk.environment.state.icon_types import role_of
from onika.desk.environment.state.icon_words import words_of
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.pictures import key_of
from onika.model.application import Action, AppFlow, Branch, Hole, Icon, Step, actions, wanted_targets
from onika.model.rules.gap import begins, kinds
from onika.model.syntax import Syntax
from onika.wire.view import StepView


class StepContext(NamedTuple):
    """Where a step stands: what its view depends on beside itself."""

    left: str
    right: str
    is_joined: bool
    wants: tuple[str, ...]
    path: str


@dataclass(frozen=True, slots=True)
class MadeStep:
    """A view, and what it was made of."""

    step: Step
    stand: StepContext
    view: StepView


def step_views(
    flow: AppFlow, path: str, model: Model, former: Mapping[int, MadeStep], before: AppFlow | None = None
) -> dict[int, MadeStep]:
    """The steps of a flow by their numbers; those that stand as they did in `former` are the same again.

    before  the flow as it was, whose steps are all in `former`: only what changed since, and its actions, is looked at
    """
    steps, syntax = flow.steps, syntax_of(model)
    start, end = _touched(before, flow, syntax) if before is not None else (0, len(steps))
    views = {step.number: former[step.number] for step in steps[:start]}
    part = AppFlow(steps[start : end + 1])  # with the next action, as a hole before it has its edge
    for step, stand in zip(steps[start:end], _stands(part, path, syntax), strict=False):
        former_view = former.get(step.number)
        if former_view is None or former_view.step is not step or former_view.stand != stand:
            former_view = MadeStep(step, stand, _view(step, stand, model))
        views[step.number] = former_view
    views.update((step.number, former[step.number]) for step in steps[end:])
    return views


def _touched(before: AppFlow, flow: AppFlow, syntax: Syntax) -> tuple[int, int]:
    """From where to where steps may stand differently: those that are others, with the actions they belong to."""
    old, new = before.steps, flow.steps
    most = min(len(old), len(new))
    start = next((at for at in range(most) if old[at] is not new[at]), most)
    behind = next((at for at in range(most - start) if old[-1 - at] is not new[-1 - at]), most - start)
    end = len(new) - behind
    start = max(start - 1, 0)
    while start > 0 and not begins(new[start], syntax):
        start -= 1
    while end < len(new) and not begins(new[end], syntax):
        end += 1
    return start, end


def _stands(flow: AppFlow, path: str, syntax: Syntax) -> list[StepContext]:
    acting = actions(flow, syntax)
    joined, wants = _joined(flow, acting, syntax)
    every = kinds(flow, syntax, acting)
    wanted = []
    for at, step in enumerate(flow.steps):
        before, kind, after = every[at], every[at + 1], every[at + 2]
        if isinstance(step, Hole):
            left, right = before.right_edge if before else "", after.left_edge if after else ""
        else:
            left, right = (kind.left_edge, kind.right_edge) if kind else ("", "")
        where = path if isinstance(step, Branch) else ""
        wanted.append(StepContext(str(left), str(right), at in joined, tuple(wants.get(at, ())), where))
    return wanted


def _joined(flow: AppFlow, acting: Sequence[Action], syntax: Syntax) -> tuple[set[int], dict[int, list[str]]]:
    """The positions that belong to the action before them, and the targets that are missing at holes."""
    joined: set[int] = set()
    wants: dict[int, list[str]] = {}
    for action in acting:
        if not action.targets:
            continue
        positions = action.positions
        joined.update(positions)
        if any(isinstance(target, Hole) for target in action.targets):
            for position, kind in zip(positions, wanted_targets(action.icon.onikon, syntax), strict=False):
                if isinstance(flow.steps[position], Hole):
                    wants.setdefault(position, []).append(kind)
    return joined, wants


def _view(step: Step, stand: StepContext, model: Model) -> StepView:
    left, right, is_joined, wants, path = stand
    if isinstance(step, Hole):
        return StepView("hole", left, right, is_joined=is_joined, wants=wants)
    if isinstance(step, Branch):
        flows = tuple(f"{path}/{step.number}/{number}" for number in range(len(step.flows)))
        return StepView("branch", left, right, conditions=step.conditions, flows=flows)
    return _icon(step, stand, model)


def _icon(icon: Icon, stand: StepContext, model: Model) -> StepView:
    onikon, syntax = icon.onikon, syntax_of(model)
    return StepView(
        left=stand.left,
        right=stand.right,
        name=onikon.name,
        type=onikon.type,
        role=role_of(syntax.acting(onikon.type)),
        picture=key_of(onikon.picture),
        description=onikon.description,
        words=words_of(model, onikon),
        values=target_values.shown(onikon, syntax),
        is_joined=stand.is_joined,
        breaks=icon.marker,
        break_if=icon.marker_if,
        synch_tag=icon.synch_tag or "",
        loop=icon.while_tag or "",
        is_test=icon.while_test,
        loop_if=icon.while_if,
    )
