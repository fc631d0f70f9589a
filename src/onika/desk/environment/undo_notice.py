"""One history for all who look: whoever takes back what another did is told, and so is the other (requirement X10)."""

from onika.desk.environment.state.model import Model
from onika.wire import act, page
from onika.words.reason import Reason


def others(before: Model, command: act.AnyAct, by: str) -> tuple[page.Say, ...]:
    """What is said of taking back, or doing again, what was done on another page."""
    if before.people < 2 or not isinstance(command, act.Undo | act.Redo):
        return ()
    opened = before.file(command.doc)
    if opened is None:
        return ()
    is_undo = isinstance(command, act.Undo)
    step = opened.history.last if is_undo else opened.history.next
    if step is None or step.by in ("", by):
        return ()
    if is_undo:
        reason = Reason.of("run.undone_elsewhere", label=step.label, name=opened.name)
    else:
        reason = Reason.of("run.redone_elsewhere", label=step.label, name=opened.name)
    return (page.Say("warning", reason, opened.id),)
