"""Parameters of modules are changed: the LOCAL lines of tasks, all of an act or none (requirements C04, X10)."""

from collections.abc import Mapping
from dataclasses import replace

from onika.desk.environment.canvas import own_lines
from onika.desk.environment.canvas.library_tasks import taken_over, unknown
from onika.desk.environment.canvas.own_lines import placed_in
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.files import rmod
from onika.files.rmod import RmodText
from onika.model import parameter
from onika.model.task import LocalLine, Task
from onika.wire import act
from onika.wire.sheet import ModuleSheet
from onika.words.reason import NOTHING, Reason, reason_of

Lines = tuple[LocalLine, ...]


def local(model: Model, command: act.Local, _outside: Services) -> Done | No:
    """Other parameters of a module; its declarations and the file's own reader say what may stand there."""
    placed = placed_in(model, command.doc, command.task)
    task = (model.libraries_of(placed[0]) if placed else model.libraries).tasks.get(command.task)
    if task is None:
        return unknown(command.task)
    lines = tuple(LocalLine(key, words) for key, words in command.lines)
    wrong = faults_by_line(task, lines, model.libraries.sheets.get(task.module))
    if wrong:
        fields = {f"line {number}": reason for number, reason in wrong.items()}
        return No(Reason.of("desk.parameters_unfit", task=command.task, reasons=tuple(wrong.values())), fields=fields)
    label = Reason.of("desk.setting_parameters", task=command.task)
    changed = replace(task, local=lines)
    if placed:
        return own_lines.changed(model, placed, changed, label, label)
    return Done(taken_over(model, model.libraries.edited({command.task: changed})), label, command.doc)


def with_parameters(model: Model, document: Document, lines: Mapping[str, Lines]) -> Model:
    """With other LOCAL lines of these placed tasks, in this configuration."""
    tasks = model.libraries_of(document).tasks
    changed = {name: replace(tasks[name], local=lines_of_task) for name, lines_of_task in lines.items()}
    return own_lines.with_tasks(model, document, changed)


def faults_by_line(task: Task, lines: Lines, sheet: ModuleSheet | None) -> dict[int, Reason]:
    """Why lines cannot stand in the LOCAL block of a task, by their numbers from 0.

    What its module declares is held against those only that differ from what stands there now: else a file that is
    wrong already could be mended by no one.
    """
    wrong: dict[int, Reason] = {}
    declared = {local.name: local for local in sheet.locals} if sheet else {}
    keys = [line.key for line in lines]
    for number, line in enumerate(lines):
        reason = _unwritable(task, line)
        if not reason and line.key in declared and line not in task.local:
            try:
                parameter.check(declared[line.key], line.words)
            except ValueError as error:
                reason = reason_of(error)
        if line.key in keys[:number]:
            reason = Reason.of("desk.key_once", key=line.key)
        if reason:
            wrong[number] = reason
    return wrong


def _unwritable(task: Task, line: LocalLine) -> Reason:
    """Why a line cannot stand in the file, if so: read again it must be the same."""
    alone = replace(task, local=(line,))
    try:
        text = rmod.write(RmodText(alone), alone)
    except ValueError as error:
        return reason_of(error)
    record, faults = rmod.read(text, task.name, task.name)
    if record is not None and record.task.local == (line,):
        return NOTHING
    fault = next((fault for fault in faults if not fault.is_note), None)
    shown = " ".join((line.key, *line.words))
    if fault:
        return fault.reason
    return Reason.of("desk.no_key_line", line=shown)
