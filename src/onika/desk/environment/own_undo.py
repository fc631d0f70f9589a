"""Undo and Redo of what belongs to no open file: icons, targets, preferences, buttons, library rates (X10)."""

from dataclasses import replace

from onika.desk.environment import buttons, preferences
from onika.desk.environment.canvas import library_tasks
from onika.desk.environment.icons.dictionaries import shown_at_once
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.restoration import FileText, Restoration
from onika.files import whole
from onika.wire import act
from onika.words.fault import Refusal
from onika.words.reason import Reason
from onika.words.system_error import system_reason


def undo_own(model: Model, _command: act.UndoOwn, outside: Services) -> Done | No:
    """Take the last such change back."""
    step = model.own.last
    if step is None:
        return No(Reason.of("run.nothing_to_undo"))
    done = _restored(model, step.after, step.before, outside)
    if isinstance(done, No):
        return done
    return replace(done, model=replace(done.model, own=model.own.undone()), own=None)


def redo_own(model: Model, _command: act.RedoOwn, outside: Services) -> Done | No:
    """Do the change again that was taken back last."""
    step = model.own.next
    if step is None:
        return No(Reason.of("run.nothing_to_redo"))
    done = _restored(model, step.before, step.after, outside)
    if isinstance(done, No):
        return done
    return replace(done, model=replace(done.model, own=model.own.redone()), own=None)


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
    return Done(shown_at_once(model, then.path, outside.site))
