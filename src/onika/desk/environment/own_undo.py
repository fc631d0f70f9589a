"""Undo and Redo in one order, of an open file and of what belongs to none (requirement X10).

The latter are icons of dictionaries, targets, preferences, buttons and rates of libraries.
"""

from dataclasses import replace

from onika.desk.environment import buttons, preferences
from onika.desk.environment.canvas import library_tasks
from onika.desk.environment.file.undo import redo as redo_file, undo as undo_file
from onika.desk.environment.icons.dictionaries import shown_at_once
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.arrangements import with_arrangements
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.restoration import FileText, Restoration
from onika.desk.environment.state.undo_order import redoable, undoable
from onika.files import arrangement, whole
from onika.wire import act
from onika.words.fault import Refusal
from onika.words.reason import Reason
from onika.words.system_error import system_reason


def undo(model: Model, command: act.Undo, outside: Services) -> Done | No:
    """Take back what was done last: to the open file, or to what belongs to none."""
    file, step = model.file(command.doc), model.own.last
    if command.doc and (file is None or step is None or step is not undoable(model, file)):
        return undo_file(model, command, outside)
    if step is None:
        return No(Reason.of("run.nothing_to_undo"))
    done = _restored(model, step.after, step.before, outside)
    if isinstance(done, No):
        return done
    return replace(done, model=replace(done.model, own=model.own.undone(model.next_step)), own=None, value=step.label)


def redo(model: Model, command: act.Redo, outside: Services) -> Done | No:
    """Do again what was taken back last."""
    file, step = model.file(command.doc), model.own.next
    if command.doc and (file is None or step is None or step is not redoable(model, file)):
        return redo_file(model, command, outside)
    if step is None:
        return No(Reason.of("run.nothing_to_redo"))
    done = _restored(model, step.before, step.after, outside)
    if isinstance(done, No):
        return done
    return replace(done, model=replace(done.model, own=model.own.redone(model.next_step)), own=None, value=step.label)


def _restored(model: Model, now: Restoration, then: Restoration, outside: Services) -> Done | No:
    match then:
        case act.Prefer():
            return preferences.prefer(model, then, outside)
        case act.SetButton():
            return buttons.set_button(model, then, outside)
        case act.LibraryRate():
            return library_tasks.library_rate(model, then, outside)
        case FileText():
            return _rewritten(model, now, then, outside)


def _rewritten(model: Model, now: Restoration, then: FileText, outside: Services) -> Done | No:
    """A file as it was, where nobody has changed it since."""
    if FileText.of(then.path) != now:
        return No(Reason.of("run.file_changed_since", path=str(then.path)))
    if then.text is None:
        try:
            then.path.unlink(missing_ok=True)
        except OSError as error:
            return No(Reason.of("run.what_why", what=str(then.path), why=system_reason(error)))
    else:
        written = whole.write(then.path, then.text, whole.ANYTHING)
        if isinstance(written, Refusal):
            return No(written.reason)
    if then.path.name == arrangement.NAME:
        return Done(with_arrangements(model, outside.site)[0])
    return Done(shown_at_once(model, then.path, outside.site))
