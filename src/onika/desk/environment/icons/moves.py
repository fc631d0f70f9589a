"""Moving steps within and between flows: taken out and put in again as one step, or not at all (requirement D05)."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from onika.desk.environment.icons.alteration import altered, flow_at, place_behind, spots_of
from onika.desk.environment.icons.fitting import misfit
from onika.desk.environment.icons.insertion import is_too_deep, is_within, too_deep, without
from onika.desk.environment.outcome.on_file import on_resting_application, syntax_of
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import several
from onika.model.application import AppFlow, Application, Hole, Step, actions
from onika.model.flow_path import flows_by_path, with_flows
from onika.model.rules import jigsaw
from onika.model.syntax import Syntax
from onika.wire import act
from onika.words.reason import Reason


@on_resting_application
def move_icons(model: Model, opened: OpenApplication, command: act.MoveIcons, _outside: Services) -> Done | No:
    """Take steps out and insert them behind another one, or in its place; an action takes its targets with it."""
    spots = spots_of(opened.application, command.steps)
    if isinstance(spots, No):
        return spots
    syntax = syntax_of(model)
    wanted = {spot.step.number for spot in spots if not isinstance(spot.step, Hole) or spot.step.kept}
    if not wanted:
        return No(Reason.of("desk.hole_no_icon"))
    steps = list(taken(opened.application, wanted, syntax))
    numbers = {step.number for step in steps}
    place = _place(opened.application, command)
    if isinstance(place, No):
        return place
    if is_within(place[0], numbers):
        return No(Reason.of("desk.branch_into_itself"))
    gone = numbers | _replaced(opened.application, command.replaces, numbers, syntax)
    after = _before(opened.application, *place, gone)
    left = with_flows(opened.application, without(model, opened, gone))
    place = place_behind(left, place[0], after)
    if isinstance(place, No):
        return place
    application = _inserted(model, opened, left, place, steps)
    if isinstance(application, No):
        return application
    if is_too_deep(application):
        return too_deep()
    if application == opened.application:
        return Done(model)
    return altered(model, opened, application, Reason.of("desk.moving", icons=several(steps)))


def _place(application: Application, command: act.MoveIcons) -> tuple[str, int] | No:
    """Behind which step of which flow they come; where they replace one, that is it until it goes."""
    return place_behind(application, command.flow, command.replaces or command.after)


def _replaced(application: Application, number: int, moved: set[int], syntax: Syntax) -> set[int]:
    """What goes for what is moved: the icon, and where an action comes for an action all of it; else nothing."""
    if not number or number in moved:
        return set()
    whole = {step.number for step in taken(application, {number}, syntax)}
    heads = {action.icon.number for _, flow in flows_by_path(application) for action in actions(flow, syntax)}
    return whole if heads & moved else {number}


def _inserted(
    model: Model, opened: OpenApplication, left: Application, place: tuple[str, int], steps: Sequence[Step]
) -> Application | No:
    """What is left of an application with steps of it at another place."""
    path, position = place
    flow = flow_at(left, path) or AppFlow(())
    first = next((step for step in steps if not isinstance(step, Hole)), None)
    if first is None:
        return No(Reason.of("desk.hole_no_icon"))
    refused = misfit(model, replace(opened, application=left), flow, position, first, path=path)
    if refused:
        shown = (remedy for remedy in refused.remedies if remedy.show)  # the others would insert, and nothing is moved
        return replace(refused, remedies=tuple(shown))
    return with_flows(left, {path: jigsaw.insert_all(flow, position, steps, syntax_of(model))})


def taken(application: Application, numbers: set[int], syntax: Syntax) -> Iterable[Step]:
    """The steps of these numbers in order, with the targets of their actions, but for those within one of them."""
    for path, flow in flows_by_path(application):
        if is_within(path, numbers):
            continue
        wanted = {at for at, step in enumerate(flow.steps) if step.number in numbers}
        for action in actions(flow, syntax):
            if action.position in wanted:
                wanted.update(at for at in action.positions if not isinstance(flow.steps[at], Hole))
        yield from (flow.steps[at] for at in sorted(wanted))


def _before(application: Application, path: str, position: int, numbers: set[int]) -> int:
    """The number of the nearest icon at or left of a position that is not one of these; 0: the start icon."""
    flow = flow_at(application, path) or AppFlow(())
    left = (step for step in reversed(flow.steps[: position + 1]) if not isinstance(step, Hole))
    return next((step.number for step in left if step.number not in numbers), 0)
