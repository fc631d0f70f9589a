"""Copy, cut and paste of icons: all or nothing, within and between applications (requirement D05).

What is copied travels as the text of an application of one flow (§A.4), which a mail takes too.
"""

from collections.abc import Sequence
from dataclasses import replace

from onika.desk.environment.icons.alteration import flow_at, place_behind, reflowed, spots_of
from onika.desk.environment.icons.fitting import misfit
from onika.desk.environment.icons.insertion import is_too_deep, is_within, remove_icons, too_deep
from onika.desk.environment.icons.loops import for_pasting
from onika.desk.environment.outcome import fault_text
from onika.desk.environment.outcome.on_file import (
    is_running,
    on_application,
    on_resting_application,
    running,
    syntax_of,
)
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import several, step_named
from onika.files import appl
from onika.model.application import AppFlow, Application, Hole, Step, actions
from onika.model.flow_path import numbered, unnumbered, with_flows
from onika.model.rules import jigsaw
from onika.model.syntax import Syntax
from onika.wire import act, page
from onika.words.fault import Fault
from onika.words.reason import Reason

_NAME = "copied"
_NAMED = 4
"""Icons that are called by name where they were copied."""


@on_application
def copy_icons(model: Model, opened: OpenApplication, command: act.CopyIcons, _outside: Services) -> Done | No:
    """Take steps into the clipboard of icons; the value is their text."""
    spots = spots_of(opened.application, command.steps)
    if isinstance(spots, No):
        return spots
    numbers = {spot.step.number for spot in spots}
    steps = unnumbered(spot.step for spot in spots if not is_within(spot.path, numbers))
    if all(isinstance(step, Hole) for step in steps):
        return No(Reason.of("desk.hole_not_copied"))
    says = (page.Say("info", _copied(steps), command.doc),)
    return Done(replace(model, icon_clipboard=steps), value=_written(steps), says=says)


@on_application
def cut_icons(model: Model, opened: OpenApplication, command: act.CutIcons, outside: Services) -> Done | No:
    """Take steps into the clipboard of icons and delete them, as one step; the value is their text."""
    if is_running(model, opened.id):
        return running(opened)
    copied = copy_icons(model, act.CopyIcons(command.doc, command.steps), outside)
    if isinstance(copied, No):
        return copied
    done = remove_icons(copied.model, act.RemoveIcons(command.doc, command.steps), outside)
    if isinstance(done, No):
        return done
    return replace(
        done, label=Reason.of("desk.cutting", icons=several(copied.model.icon_clipboard)), value=copied.value
    )


@on_resting_application
def paste_icons(model: Model, opened: OpenApplication, command: act.PasteIcons, _outside: Services) -> Done | No:
    """Insert what was copied behind a step, or the action of that; the value is the numbers of the new steps."""
    syntax = syntax_of(model)
    steps = _read(command.text, syntax) if command.text else model.icon_clipboard
    if isinstance(steps, No):
        return steps
    first = next((step for step in steps if not isinstance(step, Hole)), None)
    if first is None:
        return No(Reason.of("desk.nothing_copied"))
    place = place_behind(opened.application, command.flow, command.after)
    if isinstance(place, No):
        return place
    path, position = place
    flow = flow_at(opened.application, path) or AppFlow(())
    refused = misfit(model, opened, flow, position, first, path=path)
    behind = _behind_action(flow, position, syntax)
    if refused and behind != position and misfit(model, opened, flow, behind, first, path=path) is None:
        refused, position = None, behind
    if refused:
        return replace(refused, reason=Reason.of("desk.nothing_pasted", reason=refused.reason))
    new, last = numbered(Application("", False, (AppFlow(for_pasting(steps, flow)),)), opened.last_number)
    pasted = new.flows[0].steps
    after = jigsaw.insert_all(flow, position, pasted, syntax)
    if is_too_deep(with_flows(opened.application, {path: after})):
        return too_deep()
    opened = replace(opened, last_number=last)
    numbers = tuple(step.number for step in pasted if not isinstance(step, Hole))
    return reflowed(model, opened, {path: after}, Reason.of("desk.pasting", icons=several(pasted)), numbers)


def _behind_action(flow: AppFlow, position: int, syntax: Syntax) -> int:
    """The last step of the action that stands there: whoever selects a job alone means its targets too."""
    ends = (action.end - 1 for action in actions(flow, syntax) if action.position <= position < action.end)
    return next(ends, position)


def _copied(steps: Sequence[Step]) -> Reason:
    """What was copied, by name; of many the first ones."""
    names = tuple(step_named(step) for step in steps if not isinstance(step, Hole))
    if len(names) > _NAMED:
        return Reason.of("desk.copied_and_more", icons=names[:_NAMED], more=len(names) - _NAMED)
    return Reason.of("desk.copied", icons=names, count=len(names))


def _written(steps: tuple[Step, ...]) -> str:
    return appl.write(Application(_NAME, False, (AppFlow(steps),)))


def _read(text: str, syntax: Syntax) -> tuple[Step, ...] | No:
    """The steps of a text; those of its only flow."""
    application, faults = appl.read(text.strip() + "\n", _NAME, "the text", syntax)
    if application is None:
        return No(Reason.of("desk.text_without_icons", why=_why(faults[0])))
    if len(application.flows) != 1:
        return No(Reason.of("desk.icons_of_one_flow", count=len(application.flows)))
    return unnumbered(application.flows[0].steps)


def _why(fault: Fault) -> Reason:
    """What is wrong with the text, and where in it."""
    return Reason.of("desk.placed_fault", place=str(fault.place), reason=fault_text.simple(fault.reason))
