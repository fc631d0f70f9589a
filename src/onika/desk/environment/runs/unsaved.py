"""What a run uses and what has changed here since it was saved: a run reads files (requirement E12)."""

from collections.abc import Iterable, Mapping, Sequence

import msgspec

from onika.desk.environment.canvas.library_tasks import save_task
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
"""A document's id and name; of a task of a library, whose file is meant, the id is empty."""


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


def tasks(model: Model, program: ApplicationProgram | None) -> tuple[Changed, ...]:
    """The tasks that a program reads from their files and that were changed here, where its configurations say less."""
    edits = model.libraries.edits
    names = (
        placed.file
        for configuration in (program.configurations.values() if program else ())
        for placed in configuration.placed
        if program and placed.file in edits and placed.task in program.tasks
        if program.tasks[placed.task] != placed.of(edits[placed.file])
    )
    return tuple(("", name) for name in dict.fromkeys(names))


def other_files(model: Model, places: Mapping[str, str], program: ApplicationProgram | None) -> tuple[Reason, ...]:
    """Tasks of which a run takes another file than is shown here."""
    reasons = []
    for name in program.tasks if program else ():
        file = program.task_files.get(name, name) if program else name
        if file in model.libraries.homes and name in places:
            shown = str(model.libraries.task_file(file))
            if shown != places[name]:
                reasons.append(Reason.of("run.takes_other_file", task=name, path=places[name], seen=shown))
    return tuple(reasons)


def saved(model: Model, changed: Sequence[Changed], outside: Services) -> Done | No:
    """With all of them saved; a no where one cannot be."""
    for doc, name in changed:
        done = file_acts.save(model, act.Save(doc), outside) if doc else save_task(model, act.SaveTask(name), outside)
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
