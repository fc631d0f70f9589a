"""A document without what a change did that came to nothing (requirement X10)."""

from collections.abc import Iterator
from dataclasses import replace

from onika.desk.environment.file.undo import moved_wanted
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import History
from onika.model.configuration import Configuration, Group, Placed


def reverted(now: Content, start: Content, end: Content) -> Content:
    """What is there now, without what a step from `start` to `end` has changed."""
    wanted = moved_wanted(now.wanted, end, start)
    kept = start.kept if now.kept == end.kept else now.kept
    if now.configuration is end.configuration:
        return Content(start.configuration, wanted, kept)
    old = {placed.task: placed for placed in start.configuration.placed}
    new = {placed.task: placed for placed in end.configuration.placed}
    placed = [_back(placed, old.get(placed.task), new.get(placed.task)) for placed in now.configuration.placed]
    stays = [placed for placed in placed if placed is not None]
    here = {placed.task for placed in stays}
    again = [placed for name, placed in old.items() if name not in new and name not in here]
    name = start.configuration.name if now.configuration.name == end.configuration.name else now.configuration.name
    configuration = replace(now.configuration, name=name, placed=(*stays, *again))
    configuration = configuration.regrouped(_groups(now.configuration, start.configuration, end.configuration))
    return Content(configuration, wanted, kept).with_configuration(configuration)


def file_before(now: Document, before: History[Content], after: History[Content]) -> Document:
    """Tied to the file again that it had before the steps that came between two histories."""
    kept = {id(step) for step in before.past}
    steps = [step for step in after.past if id(step) not in kept and step.file_before and step.file_after]
    if not steps or not steps[-1].file_after or now.opened is not steps[-1].file_after.opened:
        return now  # it was saved meanwhile, and knows better
    former = steps[0].file_before
    if former:
        return replace(now, opened=former.opened, base=former.base)
    return now


def without_steps(now: History[Content], before: History[Content], after: History[Content]) -> History[Content]:
    """The history without the steps that came between two others."""
    if now is after:
        return before
    added = {id(step) for step in after.past} - {id(step) for step in before.past}
    return History(tuple(step for step in now.past if id(step) not in added), now.future)


def _groups(now: Configuration, start: Configuration, end: Configuration) -> Iterator[Group]:
    """The supermodules of now, where the step has changed one as it was before, and those it has expanded."""
    for group in now.groups:
        old, new = start.group(group.name), end.group(group.name)
        if new is None or new == old or new != group:
            yield group
        elif old is not None:
            yield old
    yield from (group for group in start.groups if end.group(group.name) is None and now.group(group.name) is None)


def _back(now: Placed, old: Placed | None, new: Placed | None) -> Placed | None:
    """One task on the canvas without what the step did to it."""
    if new is None or old == new:
        return now
    if old is None:
        return None
    return replace(now, frequency=old.frequency, rtpu=old.rtpu, own=old.own)
