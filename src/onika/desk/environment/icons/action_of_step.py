"""The action to which a step belongs: a mark on a target is one of its job (reading 24, requirement D06)."""

from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

from onika.desk.environment.icons.alteration import flow_at
from onika.desk.environment.outcome.on_file import syntax_of
from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import step_named
from onika.model.application import Action, AppFlow, Branch, Icon, actions
from onika.model.flow_path import spots
from onika.words.reason import Reason


class StepAction(NamedTuple):
    """An action, and the flow in which it stands."""

    path: str
    flow: AppFlow
    action: Action

    def having(self, icon: Icon) -> AppFlow:
        """The flow with another icon for it."""
        return exchanged(self.flow, {self.action.position: icon})


def action_of(model: Model, opened: OpenApplication, number: int) -> StepAction | No:
    """The action to which the step of this number belongs."""
    spot = spots(opened.application).get(number)
    if spot is None:
        return No(Reason.of("desk.selection_gone"))
    if isinstance(spot.step, Branch):
        return No(Reason.of("desk.branch_without_marks"))
    flow = flow_at(opened.application, spot.path) or AppFlow(())
    for action in actions(flow, syntax_of(model)):
        if action.position <= spot.position < action.end:
            return StepAction(spot.path, flow, action)
    return No(Reason.of("desk.no_action_of_step", step=step_named(spot.step)))


def exchanged(flow: AppFlow, icons: dict[int, Icon]) -> AppFlow:
    """A flow with other icons of the same types at these positions."""
    return AppFlow(tuple(icons.get(at, step) for at, step in enumerate(flow.steps)))


def unmarked(icons: Iterable[tuple[int, Icon]]) -> dict[int, Icon]:
    """These icons without their part of a loop, by their positions."""
    return {at: replace(icon, while_tag=None, while_test=False, while_if="") for at, icon in icons}
