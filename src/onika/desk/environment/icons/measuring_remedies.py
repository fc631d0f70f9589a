"""What could be done so that something measures what a target says (requirement X01)."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path

from onika.desk.environment.icons.measured_variables import MeasuredVariable
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.plan.target_inputs import takes
from onika.model.configuration import Configuration
from onika.model.syntax import IconType
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import Remedy
from onika.words.reason import Reason

_MOST = 3


def ways_to_measure(model: Model, measures: Sequence[MeasuredVariable], kind: IconType) -> tuple[Remedy, ...]:
    """Buttons, likeliest first: turn tasks ON that live, connect what is open, open what could be.

    kind    the type of target: its own jobs come before others that measure it too
    """
    return tuple(islice(_ways(model, frozenset(measure.variable for measure in measures), kind), _MOST))


def _ways(model: Model, wanted: frozenset[str], kind: IconType) -> Iterator[Remedy]:
    documents = model.documents.values()
    able = [(document, tasks) for document in documents if (tasks := _writers_in(model, document, wanted))]
    for document, tasks in able:
        sleeping = tuple(name for name in _with_hardware(model, document, tasks) if _is_off(document, name))
        if document.live is not None and document.live.state == "live" and sleeping:
            yield Remedy(Reason.of("desk.turn_on_tasks", names=sleeping), act.Turn(document.id, sleeping, True))
    for document, _ in able:
        if document.live is None:
            yield Remedy(Reason.of("desk.connect", name=document.name), act.Connect(document.id))
    for path in _files(model, wanted, kind):
        yield Remedy(Reason.of("desk.open_file", name=Path(path).stem), act.Open(path))


def _files(model: Model, wanted: frozenset[str], kind: IconType) -> Iterator[str]:
    """The configurations that could be opened: jobs of the target first, of these the usual ones, that of few tasks.

    A configuration is as usual as its rarest task that drives nothing.
    """
    opened = {str(document.opened.path) for document in model.documents.values() if document.opened}
    configurations = {
        path: source.tasks(model.libraries.tasks)
        for path, source in model.sources.items()
        if isinstance(source, Configuration)
    }
    usage = Counter(task.module for tasks in configurations.values() for task in tasks.values())
    able_files: list[tuple[bool, int, int, str]] = []
    for path, placed in configurations.items():
        if path not in opened and _writers(placed, wanted):
            usages = [usage[task.module] for task in placed.values() if not _drives(model, task)]
            able_files.append((not _is_job_of(placed, kind, model), -min(usages, default=0), len(placed), path))
    yield from (path for *_, path in sorted(able_files))


def _is_job_of(tasks: Mapping[str, Task], kind: IconType, model: Model) -> bool:
    """Whether one of these tasks takes such a target."""
    return model.syntax is not None and any(takes(task, kind, model.syntax) for task in tasks.values())


def _writers_in(model: Model, document: Document, wanted: frozenset[str]) -> list[Task]:
    return _writers(document.content.configuration.tasks(model.libraries.tasks), wanted)


def _writers(tasks: Mapping[str, Task], wanted: frozenset[str]) -> list[Task]:
    return [task for task in tasks.values() if task.given_while_running & wanted]


def _with_hardware(model: Model, document: Document, tasks: Sequence[Task]) -> tuple[str, ...]:
    """These tasks behind the drivers of robots whose measurements they read."""
    reads = {name for task in tasks for name in task.svars(task.invar)}
    library_tasks = model.libraries_of(document).tasks
    drivers = [
        name
        for name in document.content.names
        if name in library_tasks
        and _drives(model, library_tasks[name])
        and library_tasks[name].given_while_running & reads
    ]
    return tuple(dict.fromkeys((*drivers, *(task.name for task in tasks))))


def _drives(model: Model, task: Task) -> bool:
    """Whether a task is the driver of a device, as its file says or its module does."""
    sheet = model.libraries.sheets.get(task.module)
    return any(line.key == "DEVICE" for line in task.local) or (sheet is not None and sheet.hardware)


def _is_off(document: Document, name: str) -> bool:
    return document.live is not None and document.live.state_of(name) == "OFF"
