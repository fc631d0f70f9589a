"""What a run uses and what has changed here since it was saved: a run reads files (requirement E12)."""

from collections.abc import Iterable, Sequence

import msgspec

from onika.desk.environment.file import file_acts
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.store.program import ApplicationProgram
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.reason import Reason

Changed = tuple[str, str]
"""A document's id and name."""


def dirty(model: Model) -> tuple[Changed, ...]:
    """What is open here and not saved."""
    return tuple((file.id, file.name) for file in model.open_files if file.is_dirty)


def used(changed: Iterable[Changed], program: ApplicationProgram | None) -> tuple[Changed, ...]:
    """Those that a program uses: configurations of jobs, and applications in it."""
    if program is None:
        return ()
    return tuple(
        (doc, name)
        for doc, name in changed
        if name
        in (program.applications if DocumentKind.of(doc) is DocumentKind.APPLICATION else program.configurations)
    )


def saved(model: Model, changed: Sequence[Changed], outside: Services) -> Done | No:
    """With all of them saved; a no where one cannot be."""
    for doc, _ in changed:
        done = file_acts.save(model, act.Save(doc), outside)
        if isinstance(done, No):
            return done
        model = done.model
    return Done(model)


def refused(opened: OpenApplication, changed: Sequence[Changed], command: act.Run) -> No | None:
    """Why it does not run like this: what is shown is not what would run."""
    if not changed or command.ignores_unsaved:
        return None
    is_one = len(changed) == 1
    as_saved = Reason.of("run.runs_as_saved") if is_one else Reason.of("run.runs_as_all_saved")
    remedies = (
        Remedy(Reason.of("run.save_and_run"), msgspec.structs.replace(command, saves_unsaved=True)),
        Remedy(as_saved, msgspec.structs.replace(command, ignores_unsaved=True)),
    )
    return No(Reason.of("run.unsaved", names=tuple(name for _, name in changed), name=opened.name), remedies)
