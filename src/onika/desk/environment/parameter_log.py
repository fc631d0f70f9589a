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
        old, new = before.libraries.tasks.get(name), after.libraries.tasks.get(name)
        if old is None or new is None or old.local == new.local:
            continue
        changes = tuple(_changes(old, new))
        text = Reason.of("run.parameters_changed", task=name, changes=changes)
        yield page.Say("info", text, where=ShowTask(name), is_quiet=True)


def _changes(old: Task, new: Task) -> Iterator[Reason]:
    was, now = ({line.key: " ".join(line.words) for line in task.local} for task in (old, new))
    for key in dict.fromkeys((*was, *now)):
        if was.get(key) != now.get(key):
            yield Reason.of("run.parameter_changed", name=key, before=was.get(key, "–"), after=now.get(key, "–"))
