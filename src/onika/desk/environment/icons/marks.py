"""Breakpoints and synchronisation tags, which count once for an action (requirement D06, readings 24 to 26)."""

import re
from dataclasses import replace

from onika.desk.environment.icons.action_of_step import StepAction, action_of, exchanged
from onika.desk.environment.icons.alteration import reflowed
from onika.desk.environment.outcome.on_file import on_application, on_resting_application
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import named
from onika.model.application import AppFlow, Icon
from onika.wire import act
from onika.words.condition import Condition
from onika.words.reason import Reason, reason_of

_TAG = re.compile(r"[^\s\x00-\x1f\x7f-\x9f#]{1,16}\Z")


@on_application
def set_breakpoint(model: Model, opened: OpenApplication, command: act.SetBreakpoint, _outside: Services) -> Done | No:
    """Pause after these actions, or no longer; also while they run."""
    condition = condition_of(command.condition)
    if isinstance(condition, No):
        return condition
    actions = [action_of(model, opened, step) for step in command.steps]
    marked = [action for action in actions if not isinstance(action, No)]
    if not marked:
        return next((action for action in actions if isinstance(action, No)), No(Reason.of("desk.nothing_selected")))
    flows: dict[str, AppFlow] = {}
    for path, flow, action in marked:
        icon = replace(action.icon, marker=command.is_set, marker_if=condition if command.is_set else "")
        flows[path] = exchanged(flows.get(path, flow), {action.position: icon})
    done = reflowed(model, opened, flows, _marking(marked, command.is_set))
    return done if condition else _still_looked(done, opened)


def _still_looked(done: Done, before: OpenApplication) -> Done:
    """What a runtime has found is still so: plain breakpoints are nothing that it looks at."""
    after, looked = done.model.applications[before.id], before.looked
    if looked is None or looked.of is not before.application:
        return done
    kept = replace(after, looked=replace(looked, of=after.application))
    return replace(done, model=done.model.with_application(kept))


@on_resting_application
def set_synch_tag(model: Model, opened: OpenApplication, command: act.SetSynchTag, _outside: Services) -> Done | No:
    """The tag at which an action waits for other flows; empty takes it away."""
    tag = command.tag.strip()
    wrong = tag_refused(tag)
    if wrong:
        return wrong
    action = action_of(model, opened, command.step)
    if isinstance(action, No):
        return action
    icon: Icon = replace(action.action.icon, synch_tag=tag or None)
    name = named(icon.onikon)
    label = Reason.of("desk.setting_tag", tag=tag, name=name) if tag else Reason.of("desk.removing_tag", name=name)
    return reflowed(model, opened, {action.path: action.having(icon)}, label)


def tag_refused(tag: str) -> No | None:
    """Why a text is no tag; None: it is one, or empty."""
    if not tag or _TAG.match(tag):
        return None
    return No(Reason.of("desk.tag_unfit", tag=tag), fields={"tag": Reason.of("desk.tag_form")})


def condition_of(text: str) -> str | No:
    """A condition as it is written; empty where there is none."""
    if not text.strip():
        return ""
    try:
        return Condition.parse(text).text
    except ValueError as wrong:
        return No(reason_of(wrong), fields={"condition": reason_of(wrong)})


def _marking(marked: list[StepAction], is_set: bool) -> Reason:
    """What is done with breakpoints after these actions."""
    count = len(marked)
    if count > 1:
        setting, removing = "desk.setting_breakpoints", "desk.removing_breakpoints"
        return Reason.of(setting if is_set else removing, count=count)
    icon = named(marked[0].action.icon.onikon)
    setting, removing = "desk.setting_breakpoint", "desk.removing_breakpoint"
    return Reason.of(setting if is_set else removing, icon=icon)
