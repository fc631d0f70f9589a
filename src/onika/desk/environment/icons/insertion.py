"""Putting icons and branches into flows, by Equation (7) (requirements D03, D05, D13, D19)."""

from dataclasses import replace

from onika.desk.environment.icons.alteration import flow_at, place_behind, reflowed, spots_of
from onika.desk.environment.icons.branches import branch_of
from onika.desk.environment.icons.fitting import misfit, onikon
from onika.desk.environment.outcome.on_file import on_resting_application, syntax_of
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.icon_words import for_placing
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import named, several, step_named
from onika.files.flow import DEEPEST, depth
from onika.model.application import AppFlow, Application, Branch, Hole, Icon
from onika.model.flow_path import with_flows
from onika.model.onikon import Onikon
from onika.model.rules import jigsaw
from onika.model.rules.gap import Solid, kind_of
from onika.wire import act
from onika.words.reason import Reason


@on_resting_application
def insert_icon(model: Model, opened: OpenApplication, command: act.InsertIcon, _outside: Services) -> Done | No:
    """Insert an icon of a dictionary, and before it the one that has to come first; the value is its number."""
    wanted = onikon(model, command.onikon)
    if isinstance(wanted, No):
        return wanted
    if not command.first:
        return _inserted(model, opened, command.flow, command.after, Icon(for_placing(wanted)))
    first = onikon(model, command.first)
    if isinstance(first, No):
        return first
    begun = _inserted(model, opened, command.flow, command.after, Icon(for_placing(first)))
    if isinstance(begun, No):
        return begun
    grown = begun.model.applications[opened.id]
    done = _inserted(begun.model, grown, command.flow, begun.value, Icon(for_placing(wanted)))
    if isinstance(done, No):
        return done
    icons = several([Icon(first), Icon(wanted)])
    return replace(done, label=Reason.of("desk.inserting", step=icons))


@on_resting_application
def insert_branch(model: Model, opened: OpenApplication, command: act.InsertBranch, _outside: Services) -> Done | No:
    """Insert a branch; the value is its number."""
    branch = branch_of(command.flows, command.conditions)
    if isinstance(branch, No):
        return branch
    return _inserted(model, opened, command.flow, command.after, branch)


@on_resting_application
def exchange_icon(model: Model, opened: OpenApplication, command: act.ExchangeIcon, _outside: Services) -> Done | No:
    """Put another icon where one stands, with its marks; a hole before it says that nothing fits there anyway."""
    wanted, spots = onikon(model, command.onikon), spots_of(opened.application, (command.step,))
    if isinstance(wanted, No):
        return wanted
    if isinstance(spots, No):
        return spots
    path, position, step = spots[0]
    if not isinstance(step, Icon):
        return _inserted(model, opened, path, command.step, Icon(for_placing(wanted)))
    flow = flow_at(opened.application, path) or AppFlow(())
    new = _exchanged(model, step, for_placing(wanted))
    if position == 0 or not isinstance(flow.steps[position - 1], Hole):
        refused = misfit(model, opened, flow, position - 1, new, path=path)
        if refused:
            return refused
    after = jigsaw.exchange(flow, position, new, syntax_of(model))
    label = Reason.of("desk.exchanging_icon", step=step_named(step), icon=named(wanted))
    return reflowed(model, opened, {path: after}, label, command.step)


@on_resting_application
def remove_icons(model: Model, opened: OpenApplication, command: act.RemoveIcons, _outside: Services) -> Done | No:
    """Delete steps; a hole is closed by filling it, never by deleting it."""
    spots = spots_of(opened.application, command.steps)
    if isinstance(spots, No):
        return spots
    gone = [spot.step for spot in spots if not isinstance(spot.step, Hole) or spot.step.kept]
    if not gone:
        return No(Reason.of("desk.hole_not_deleted"))
    flows = without(model, opened, {step.number for step in gone})
    return reflowed(model, opened, flows, Reason.of("desk.deleting", icons=several(gone)))


def without(model: Model, opened: OpenApplication, numbers: set[int]) -> dict[str, AppFlow]:
    """The flows that change where the steps of these numbers are taken out; none within a branch that goes."""
    spots = spots_of(opened.application, tuple(numbers))
    taken: dict[str, set[int]] = {}
    for spot in () if isinstance(spots, No) else spots:
        if not is_within(spot.path, numbers):
            taken.setdefault(spot.path, set()).add(spot.position)
    syntax = syntax_of(model)
    application = opened.application
    for path in sorted(taken, key=lambda path: -path.count("/")):  # inner ones first: outer ones hold what is left
        flow = flow_at(application, path) or AppFlow(())
        application = with_flows(application, {path: jigsaw.take_out(flow, taken[path], syntax)})
    roots = {path.split("/")[0] for path in taken}
    return {path: application.flows[int(path)] for path in roots}


def is_within(path: str, numbers: set[int]) -> bool:
    """Whether a flow lies in one of these branches."""
    return any(int(number) in numbers for number in path.split("/")[1::2])


def is_too_deep(application: Application) -> bool:
    """Whether more branches stand within each other than a file may hold."""
    return depth(application.flows) > DEEPEST


def too_deep() -> No:
    """Why no more branches are put into each other."""
    return No(Reason.of("desk.branches_too_deep", most=DEEPEST))


def _inserted(model: Model, opened: OpenApplication, path: str, after: int, step: Solid) -> Done | No:
    place = place_behind(opened.application, path, after)
    if isinstance(place, No):
        return place
    path, position = place
    flow = flow_at(opened.application, path) or AppFlow(())
    refused = misfit(model, opened, flow, position, step, path=path)
    if refused:
        return refused
    number = opened.last_number + 1
    step = replace(step, number=number)
    opened = replace(opened, last_number=number)
    after_ = jigsaw.insert(flow, position, step, syntax_of(model))
    if isinstance(step, Branch) and is_too_deep(with_flows(opened.application, {path: after_})):
        return too_deep()
    return reflowed(model, opened, {path: after_}, Reason.of("desk.inserting", step=step_named(step)), number)


def _exchanged(model: Model, step: Icon, wanted: Onikon) -> Icon:
    """The other icon with the marks of the first; a target bears none."""
    kind = kind_of(Icon(wanted), syntax_of(model))
    if kind is None or kind.is_target:
        return Icon(wanted, number=step.number)
    return replace(step, onikon=wanted)
