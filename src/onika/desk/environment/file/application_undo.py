"""What was done to an application, and taking it back (requirement X10)."""

from dataclasses import replace

from onika.desk.environment.outcome.on_application import on_resting_application
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.history import History
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import Change, OpenApplication
from onika.model.application import Application
from onika.wire import act


def stepped(before: Model, done: Done, by: str) -> Model:
    """With one more step in the history of the application that was changed, as `done` says."""
    old, new = before.applications[done.doc], done.model.applications[done.doc]
    if not done.label or old.application is new.application or old.history is not new.history:
        return done.model
    change = Change(done.label, by, old.application, new.application)
    return done.model.with_application(replace(new, history=new.history.done(change)))


@on_resting_application
def undo(model: Model, opened: OpenApplication, _asked: act.Undo, _outside: Surroundings) -> Done | No:
    """Take the last step back."""
    change = opened.history.last
    if change is None:
        return No("there is nothing to take back")
    return _restored(model, opened, change, change.before, opened.history.undone())


@on_resting_application
def redo(model: Model, opened: OpenApplication, _asked: act.Redo, _outside: Surroundings) -> Done | No:
    """Do the step again that was taken back last."""
    change = opened.history.next
    if change is None:
        return No("there is nothing to do again")
    return _restored(model, opened, change, change.after, opened.history.redone())


def _restored(model: Model, opened: OpenApplication, change: Change, to: Application, history: History[Change]) -> Done:
    """As it was, but for its name: that is of the file."""
    application = to if to.name == opened.name else replace(to, name=opened.name)
    now = replace(opened, application=application, history=history)
    return Done(model.with_application(now), change.label, opened.id)
