"""Loops: two actions of one flow, one of which decides and one of which is gone back to (D06, D13, reading 23)."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from string import ascii_uppercase

from onika.desk.environment.icons.action_of_step import StepAction, action_of, exchanged, unmarked
from onika.desk.environment.icons.alteration import reflowed
from onika.desk.environment.icons.marks import condition_of, tag_refused
from onika.desk.environment.outcome.on_file import on_resting_application, syntax_of
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.plan.icon_names import named, quoted
from onika.model.application import AppFlow, Application, Icon, Step, actions
from onika.model.flow_path import flows_by_path, with_flows
from onika.model.syntax import Syntax
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.reason import Reason


@on_resting_application
def set_loop(model: Model, opened: OpenApplication, command: act.SetLoop, _outside: Services) -> Done | No:
    """Mark two actions of one flow as a loop, in place of the loops they had; the value is its tag."""
    condition = condition_of(command.condition)
    refused = condition if isinstance(condition, No) else tag_refused(command.tag)
    if isinstance(condition, No) or refused:
        return refused or No(Reason.of("desk.no_condition"))
    ends = _ends(model, opened, command)
    if isinstance(ends, No):
        return ends
    test, anchor = ends
    syntax = syntax_of(model)
    freed = _without(test.flow, {test.action.icon.while_tag, anchor.action.icon.while_tag})
    tag = command.tag or free_tag(with_flows(opened.application, {test.path: freed}))
    if tag in tags(freed.steps):
        other = Remedy(
            Reason.of("desk.take_free_tag"),
            act.SetLoop(command.doc, command.test, command.anchor, "", command.condition),
        )
        return No(Reason.of("desk.loop_there", tag=tag), (other,), {"tag": Reason.of("desk.another_tag")})
    job, back = freed.steps[test.action.position], freed.steps[anchor.action.position]
    if not (isinstance(job, Icon) and isinstance(back, Icon)):
        raise TypeError(f"expected icons at the positions of actions, found {job} and {back}")
    flow = exchanged(
        freed,
        {
            test.action.position: replace(job, while_tag=tag, while_test=True, while_if=condition),
            anchor.action.position: replace(back, while_tag=tag, while_test=False, while_if=""),
        },
    )
    crossed = crossing_refused(opened, flow, tag, syntax)
    if crossed:
        return crossed
    label = Reason.of("desk.looping", test=named(job.onikon), anchor=named(back.onikon))
    return reflowed(model, opened, {test.path: flow}, label, tag)


def _ends(model: Model, opened: OpenApplication, command: act.SetLoop) -> tuple[StepAction, StepAction] | No:
    """The two actions of a loop, in one flow."""
    test, anchor = action_of(model, opened, command.test), action_of(model, opened, command.anchor)
    if isinstance(test, No):
        return test
    if isinstance(anchor, No):
        return anchor
    if test.path != anchor.path:
        return No(Reason.of("desk.loop_over_flows"))
    if test.action.position == anchor.action.position:
        return No(Reason.of("desk.loop_of_one_action"))
    return test, anchor


def crossing_refused(opened: OpenApplication, flow: AppFlow, tag: str, syntax: Syntax) -> No | None:
    """Why the loop `tag` of a flow may not be; None: it crosses no other."""
    crossed = _crossed(flow, tag, syntax)
    if not crossed:
        return None
    remove = (
        Remedy(Reason.of("desk.remove_loop", tag=other), act.RemoveLoop(opened.id, at)) for other, at in crossed.items()
    )
    return No(Reason.of("desk.loop_crosses", loops=tuple(crossed)), tuple(remove))


@on_resting_application
def remove_loop(model: Model, opened: OpenApplication, command: act.RemoveLoop, _outside: Services) -> Done | No:
    """Take the loop of a step away: both its tags."""
    action = action_of(model, opened, command.step)
    if isinstance(action, No):
        return action
    tag = action.action.icon.while_tag
    if tag is None:
        return No(Reason.of("desk.in_no_loop", icon=quoted(action.action.icon.onikon)))
    return reflowed(
        model, opened, {action.path: _without(action.flow, {tag})}, Reason.of("desk.removing_loop", tag=tag)
    )


def for_pasting(steps: Sequence[Step], flow: AppFlow) -> tuple[Step, ...]:
    """Steps that come into a flow: a loop of theirs gets a tag that is free there; half a one is a loop no more.

    But for the half that is missing there: it is as if it had only been moved.
    """
    count = tags(steps)
    there = tags(flow.steps)
    free = (name for name in _names() if name not in there and name not in count)
    renamed: dict[str, str] = {}
    for tag, tests in count.items():
        whole = sorted(tests) == [False, True]
        completes = sorted((*tests, *there.get(tag, ()))) == [False, True] and tag in there
        if whole:
            renamed[tag] = next(free) if tag in there else tag
        elif completes:
            renamed[tag] = tag
    return tuple(_renamed(step, renamed) for step in steps)


def tags(steps: Iterable[Step]) -> dict[str, list[bool]]:
    """The loop tags of steps, each with whether each of its icons is the test."""
    tests: dict[str, list[bool]] = {}
    for step in steps:
        if isinstance(step, Icon) and step.while_tag is not None:
            tests.setdefault(step.while_tag, []).append(step.while_test)
    return tests


def _renamed(step: Step, names: dict[str, str]) -> Step:
    if not isinstance(step, Icon) or step.while_tag is None:
        return step
    if step.while_tag in names:
        return replace(step, while_tag=names[step.while_tag])
    return unmarked([(0, step)])[0]


def _without(flow: AppFlow, gone: set[str | None]) -> AppFlow:
    """A flow without the loops of these tags."""
    icons = ((at, step) for at, step in enumerate(flow.steps) if isinstance(step, Icon) and step.while_tag is not None)
    return exchanged(flow, unmarked((at, icon) for at, icon in icons if icon.while_tag in gone))


def free_tag(application: Application) -> str:
    """The first letter that no loop of an application has: two loops of one name would puzzle who reads it."""
    taken = {tag for _, flow in flows_by_path(application) for tag in tags(flow.steps)}
    return next(name for name in _names() if name not in taken)


def _names() -> Iterable[str]:
    yield from ascii_uppercase
    number = 1
    while True:
        yield f"L{number}"
        number += 1


def _crossed(flow: AppFlow, tag: str, syntax: Syntax) -> dict[str, int]:
    """The loops that the loop `tag` crosses, each with the number of an action of it."""
    spans: dict[str, list[int]] = {}
    numbers: dict[str, int] = {}
    for action in actions(flow, syntax):
        if action.icon.while_tag is not None:
            spans.setdefault(action.icon.while_tag, []).append(action.position)
            numbers[action.icon.while_tag] = action.icon.number
    start, end = spans.pop(tag)
    whole = {other: span for other, span in spans.items() if len(span) == 2}
    return {
        other: numbers[other] for other, (first, last) in whole.items() if (start < first < end) != (start < last < end)
    }
