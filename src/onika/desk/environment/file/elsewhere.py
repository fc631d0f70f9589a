"""What another program would make of a configuration's tasks: a run, or Onika started elsewhere, reads files (R-E12).

The page shows tasks from the libraries that are open, with what was changed of them here; whoever reads the file finds
them on the search path, that of its own base directory first (reading 35).
"""

from pathlib import Path

from onika.desk.environment.state.model import Model
from onika.model.configuration import Configuration, Placed
from onika.store.site import Site
from onika.words.reason import NOTHING, Reason


def differences(model: Model, configuration: Configuration, base: Path | None, site: Site) -> dict[str, Reason]:
    """The placed tasks that another program would read differently, or not find; `base` is where the file stands."""
    here = site if base is None else site.at(base)
    seen = {placed.task: _difference(model, placed, here) for placed in configuration.placed}
    return {task: reason for task, reason in seen.items() if reason}


def _difference(model: Model, placed: Placed, site: Site) -> Reason:
    task = model.libraries.tasks.get(placed.file)
    if task is None:
        return NOTHING  # that no open library has it is a problem of its own
    record, _ = site.task(placed.file)
    if record is None:
        return Reason.of("desk.not_found_elsewhere", task=placed.task, path=str(model.libraries.task_file(placed.file)))
    home = site.home_of_task(placed.file)
    if placed.of(record.task) == placed.of(task) or home is None:
        return NOTHING
    file = home.task_file(placed.file)
    if file == model.libraries.task_file(placed.file):
        return Reason.of("desk.changed_here_only", task=placed.task, path=str(file))
    seen = str(model.libraries.task_file(placed.file))
    return Reason.of("desk.other_file_elsewhere", task=placed.task, path=str(file), seen=seen)
