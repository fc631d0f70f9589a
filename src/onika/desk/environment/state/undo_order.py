"""The one order of what can be taken back: the steps of an open file, and those of what belongs to none (X10)."""

from typing import Any

from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import UndoStep
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.words.reason import NOTHING, Reason

Step = UndoStep[Any] | None


def undoable(model: Model, file: Document | OpenApplication | None) -> Step:
    """What Undo takes back where this file is shown; None: nothing."""
    return _later(file.history.last if file is not None else None, model.own.last)


def redoable(model: Model, file: Document | OpenApplication | None) -> Step:
    """What Redo does again where this file is shown; None: nothing."""
    return _later(file.history.next if file is not None else None, model.own.next)


def label_of(step: Step) -> Reason:
    """What a step is called; nothing where there is none."""
    return step.label if step is not None else NOTHING


def _later(of_file: Step, own: Step) -> Step:
    if of_file is None or own is None:
        return of_file or own
    return own if own.number > of_file.number else of_file
