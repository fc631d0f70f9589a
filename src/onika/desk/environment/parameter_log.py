"""Lines of the log on parameters: whoever changes one, takes a change back or switches a set is written down."""

from collections.abc import Iterator

from onika.desk.environment.file.undo import edits_between
from onika.desk.environment.state.model import Model
from onika.model.task import Task
from onika.wire import page
from onika.wire.view import ShowTask
from onika.words.reason import Reason


def changed_parameters(before: Model, after: Model) -> Iterator[page.Say]:
    """A line for each task whose parameters are others now, with what each was."""
    for name in edits_between(before.libraries, after.libraries):
        yield from _said(name, before.libraries.tasks.get(name), after.libraries.tasks.get(name))
    for doc, document in after.documents.items():
        former = before.documents.get(doc)
        if former is None or former.content.configuration is document.content.configuration:
            continue
        both = (former.content.configuration, document.content.configuration)
        here, there = before.libraries.within(both[0]).tasks, before.libraries.within(both[1]).tasks
        for name in dict.fromkeys(placed.task for configuration in both for placed in configuration.otherwise):
            if former.content.placed(name) and document.content.placed(name):
                yield from _said(name, here.get(name), there.get(name), doc)


def _said(name: str, old: Task | None, new: Task | None, doc: str = "") -> Iterator[page.Say]:
    if old is not None and new is not None and old.local != new.local:
        reason = Reason.of("run.parameters_changed", task=name, changes=tuple(_changes(old, new)))
        yield page.Say("info", reason, doc, ShowTask(name), is_quiet=True)


def _changes(old: Task, new: Task) -> Iterator[Reason]:
    was, now = ({line.key: " ".join(line.words) for line in task.local} for task in (old, new))
    for key in dict.fromkeys((*was, *now)):
        if was.get(key) != now.get(key):
            yield Reason.of("run.parameter_changed", name=key, before=was.get(key, "–"), after=now.get(key, "–"))
