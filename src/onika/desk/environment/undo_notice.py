"""One history for all who look: whoever takes back what another did is told, and so is the other (requirement X10)."""

from onika.desk.environment.state.model import Model
from onika.desk.environment.state.undo_order import redoable, undoable
from onika.wire import act, page
from onika.words.reason import Reason


def others(before: Model, command: act.AnyAct, by: str) -> tuple[page.Say, ...]:
    """What is said of taking back, or doing again, what was done on another page."""
    if before.people < 2 or not isinstance(command, act.Undo | act.Redo):
        return ()
    opened = before.file(command.doc)
    is_undo = isinstance(command, act.Undo)
    step = undoable(before, opened) if is_undo else redoable(before, opened)
    if step is None or step.by in ("", by):
        return ()
    if opened is None or step is before.own.last or step is before.own.next:
        key_undone, key_redone = "run.own_undone_elsewhere", "run.own_redone_elsewhere"
        return (page.Say("warning", Reason.of(key_undone if is_undo else key_redone, label=step.label)),)
    key_undone, key_redone = "run.undone_elsewhere", "run.redone_elsewhere"
    reason = Reason.of(key_undone if is_undo else key_redone, label=step.label, name=opened.name)
    return (page.Say("warning", reason, opened.id),)
